// An array whose elements start uninitialised: large working memory that is written before it is
// read. Owns its memory; moves, does not copy. Throws std::bad_alloc.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace beespace::core {

inline constexpr std::size_t kHugePage = std::size_t{1} << 21;

// Asks for huge pages where the system has them: 512 times fewer page faults when the memory is
// new, and scattered writes that do not miss the translation buffer. Advice: nothing depends on it.
inline void advise_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t first = (begin + kHugePage - 1) / kHugePage * kHugePage;
  if (first + kHugePage > begin + bytes) return;
  madvise(static_cast<std::byte*>(data) + (first - begin), begin + bytes - first, MADV_HUGEPAGE);
#endif
}

template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  explicit Buffer(std::size_t size) : data_(allocate(size * sizeof(T))) {}
  Buffer(Buffer&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    std::swap(data_, other.data_);
    return *this;
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() { std::free(data_); }

  // The same memory as an array of other elements, which must fit; its contents are forgotten.
  template <class Other>
  [[nodiscard]] Buffer<Other> reused_as() && {
    Buffer<Other> other;
    other.data_ = reinterpret_cast<Other*>(std::exchange(data_, nullptr));
    return other;
  }

  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  T& operator[](std::size_t index) { return data_[index]; }
  const T& operator[](std::size_t index) const { return data_[index]; }

 private:
  static constexpr std::size_t kCacheLine = 64;

  static T* allocate(std::size_t bytes) {
    const std::size_t alignment = bytes >= kHugePage ? kHugePage : kCacheLine;
    if (bytes > SIZE_MAX - alignment) throw std::bad_alloc();
    const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
    void* data = std::aligned_alloc(alignment, std::max(whole, alignment));
    if (data == nullptr) throw std::bad_alloc();
    advise_huge_pages(data, whole);
    return static_cast<T*>(data);
  }

  template <class Other>
  friend class Buffer;

  T* data_ = nullptr;
};

}  // namespace beespace::core
