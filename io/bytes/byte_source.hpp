// The bytes of the input: mapped where that is possible, read into memory otherwise.
//
// A regular file is mapped (it must not shrink while it is in use), also when it is standard
// input; pipes and devices are read to their end. Gzip-compressed bytes, wherever they come from,
// are unpacked.
#pragma once

#include "io/bytes/progress.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace beespace::io {

// A view of bytes and whatever keeps them alive. Cheap to copy; immutable.
struct Bytes {
  std::shared_ptr<const void> owner = {};
  std::string_view view = {};
};

// Bytes that grow without being copied twice over; 64 readable bytes follow the last one.
class GrowingBytes {
 public:
  GrowingBytes() = default;
  GrowingBytes(const GrowingBytes&) = delete;
  GrowingBytes& operator=(const GrowingBytes&) = delete;
  ~GrowingBytes();

  // At least `wanted` bytes of free room behind the content.
  void make_room(std::size_t wanted);
  [[nodiscard]] char* free_begin() { return data_ + size_; }
  [[nodiscard]] std::size_t free_size() const { return capacity_ - size_; }
  void add(std::size_t count) { size_ += count; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::string_view view() const { return {data_, size_}; }
  // Takes so many bytes away from the front.
  void drop(std::size_t count);

  // Hands the content over; this object is empty afterwards.
  Bytes release();

 private:
  char* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

// A copy of bytes that their owner may change or free.
Bytes copy_of(std::string_view content);

// "<stdin>" for "-", the path itself otherwise.
std::string source_name(const std::string& path);

// The input as it lies there, still compressed if it is. Errors: kCannotOpen, kReadFailed.
Result<Bytes> open_bytes(const std::string& path, Progress* progress);

}  // namespace beespace::io
