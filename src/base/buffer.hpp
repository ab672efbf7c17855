// An array whose elements start uninitialised: it is written before it is read. Lies in working
// memory, or in memory of its own where it is to stay. Moves, does not copy. Throws std::bad_alloc.
#pragma once

#include "base/memory.hpp"

#include <cstddef>
#include <type_traits>
#include <utility>

namespace beespace::core {

template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  Buffer(Memory& memory, std::size_t size)
      : memory_(&memory),
        bytes_(size * sizeof(T)),
        data_(static_cast<T*>(memory.allocate(bytes_))) {}
  explicit Buffer(std::size_t size)
      : bytes_(size * sizeof(T)), data_(static_cast<T*>(allocate_block(bytes_))) {}
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() {
    if (memory_ != nullptr) {
      if (data_ != nullptr) memory_->deallocate(data_, bytes_);
    } else {
      free_block(data_, bytes_);
    }
  }

  // The same memory as an array of other elements, which must fit; its contents are forgotten.
  template <class Other>
  [[nodiscard]] Buffer<Other> reused_as() && {
    Buffer<Other> other;
    other.memory_ = std::exchange(memory_, nullptr);
    other.bytes_ = std::exchange(bytes_, 0);
    other.data_ = reinterpret_cast<Other*>(std::exchange(data_, nullptr));
    return other;
  }

  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  T& operator[](std::size_t index) { return data_[index]; }
  const T& operator[](std::size_t index) const { return data_[index]; }

 private:
  void swap(Buffer& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(bytes_, other.bytes_);
    std::swap(data_, other.data_);
  }

  template <class Other>
  friend class Buffer;

  Memory* memory_ = nullptr;
  std::size_t bytes_ = 0;
  T* data_ = nullptr;
};

}  // namespace beespace::core
