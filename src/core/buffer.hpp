// An array whose elements start uninitialised: large working memory that is written before it is
// read. Owns its memory; moves, does not copy.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace beespace::core {

template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  explicit Buffer(std::size_t size) : data_(std::make_unique_for_overwrite<T[]>(size)) {}

  [[nodiscard]] T* data() { return data_.get(); }
  [[nodiscard]] const T* data() const { return data_.get(); }
  T& operator[](std::size_t index) { return data_[index]; }
  const T& operator[](std::size_t index) const { return data_[index]; }
  void release() { data_.reset(); }

 private:
  std::unique_ptr<T[]> data_;
};

}  // namespace beespace::core
