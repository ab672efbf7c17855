#include "io/bytes/byte_source.hpp"

#include "io/bytes/input_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kPadding = 64;
constexpr std::size_t kReadSize = std::size_t{1} << 20;

Result<Bytes> read_to_end(const InputFile& file, Progress* progress) {
  GrowingBytes bytes;
  while (true) {
    bytes.make_room(kReadSize);
    const auto count = file.read(bytes.free_begin(), bytes.free_size());
    if (!count) return count.error();
    if (*count == 0) return bytes.release();
    bytes.add(*count);
    if (progress != nullptr) progress->done = bytes.size();
  }
}

}  // namespace

GrowingBytes::~GrowingBytes() {
  std::free(data_);
}

void GrowingBytes::make_room(std::size_t wanted) {
  if (free_size() >= wanted) return;
  const std::size_t capacity = std::max(size_ + wanted, capacity_ + capacity_ / 2);
  // realloc moves large blocks by their page tables, without a copy.
  void* const moved = std::realloc(data_, capacity + kPadding);
  if (moved == nullptr) throw std::bad_alloc();
  data_ = static_cast<char*>(moved);
  capacity_ = capacity;
}

void GrowingBytes::drop(std::size_t count) {
  if (count == 0) return;
  size_ -= count;
  std::memmove(data_, data_ + count, size_);
}

Bytes GrowingBytes::release() {
  make_room(0);
  if (data_ == nullptr) return {};
  std::memset(data_ + size_, 0, kPadding);
  Bytes bytes;
  bytes.view = std::string_view(data_, size_);
  bytes.owner = std::shared_ptr<const void>(
      data_, [](const void* data) { std::free(const_cast<void*>(data)); });
  data_ = nullptr;
  size_ = 0;
  capacity_ = 0;
  return bytes;
}

Bytes copy_of(std::string_view content) {
  GrowingBytes copy;
  copy.make_room(content.size());
  std::copy(content.begin(), content.end(), copy.free_begin());
  copy.add(content.size());
  return copy.release();
}

std::string source_name(const std::string& path) {
  return path == "-" ? "<stdin>" : path;
}

Result<Bytes> open_bytes(const std::string& path, Progress* progress) {
  const auto file = InputFile::open(path);
  if (!file) return file.error();
  if (auto mapped = file->map()) return *std::move(mapped);
  return read_to_end(*file, progress);
}

}  // namespace beespace::io
