#include "io/bytes/byte_source.hpp"

#include "io/bytes/descriptor.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kPadding = 64;
constexpr std::size_t kReadSize = std::size_t{1} << 20;

Error open_error(const std::string& path, int error_number) {
  std::string message;
  switch (error_number) {
    case ENOENT:
      message = "there is no such file; check the name and the folder";
      break;
    case EACCES:
    case EPERM:
      message = "not allowed to read this file; check its permissions (ls -l)";
      break;
    case EISDIR:
      message = "this is a directory; name a file in it";
      break;
    case ENOTDIR:
      message = "a part of this path is not a directory; check the name";
      break;
    default:
      message = std::string("cannot open this file: ") + std::strerror(error_number);
      break;
  }
  return {ErrorCode::kCannotOpen, message, {source_name(path)}};
}

Error read_error(const std::string& path, int error_number) {
  return {ErrorCode::kReadFailed,
          std::string("reading failed: ") + std::strerror(error_number) +
              "; check the disk or the connection and try again",
          {source_name(path)}};
}

Result<Bytes> read_to_end(int descriptor, const std::string& path, Progress* progress) {
  GrowingBytes bytes;
  while (true) {
    bytes.make_room(kReadSize);
    const ssize_t count = ::read(descriptor, bytes.free_begin(), bytes.free_size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EISDIR) return open_error(path, EISDIR);
    if (count < 0) return read_error(path, errno);
    if (count == 0) return bytes.release();
    bytes.add(static_cast<std::size_t>(count));
    if (progress != nullptr) progress->done = bytes.size();
  }
}

std::optional<Bytes> map_file(int descriptor, std::size_t size) {
  void* const begin = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  if (begin == MAP_FAILED) return std::nullopt;
  ::madvise(begin, size, MADV_SEQUENTIAL);
  ::madvise(begin, size, MADV_WILLNEED);
  return Bytes{
      std::shared_ptr<const void>(
          begin, [size](const void* mapped) { ::munmap(const_cast<void*>(mapped), size); }),
      std::string_view(static_cast<const char*>(begin), size)};
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
  const bool standard_input = path == "-";
  int number = STDIN_FILENO;
  while (!standard_input) {
    number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (number >= 0) break;
    if (errno != EINTR) return open_error(path, errno);
  }
  const Descriptor owned(standard_input ? -1 : number);
  struct stat status = {};
  if (::fstat(number, &status) != 0) return open_error(path, errno);
  if (S_ISDIR(status.st_mode)) return open_error(path, EISDIR);
  // A size of 0 is also what /proc says of files that have content. Standard input may stand in
  // the middle of a file; then the rest is read.
  if (S_ISREG(status.st_mode) && status.st_size > 0 && ::lseek(number, 0, SEEK_CUR) == 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    if (auto mapped = map_file(number, size)) return *std::move(mapped);
  }
  return read_to_end(number, path, progress);
}

}  // namespace beespace::io
