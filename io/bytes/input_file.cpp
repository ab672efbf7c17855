#include "io/bytes/input_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>

namespace beespace::io {
namespace {

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
      message =
          "this is a directory; name a file in it, or ask 'beespace replay' about all of them";
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

InputFile::State state_of(const struct stat& status) {
  return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino),
          static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec};
}

}  // namespace

Result<InputFile> InputFile::open(const std::string& path) {
  const bool standard_input = path == "-";
  int number = STDIN_FILENO;
  while (!standard_input) {
    number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (number >= 0) break;
    if (errno != EINTR) return open_error(path, errno);
  }
  InputFile file(path, Descriptor(standard_input ? -1 : number), number);
  struct stat status = {};
  if (::fstat(number, &status) != 0) return open_error(path, errno);
  if (S_ISDIR(status.st_mode)) return open_error(path, EISDIR);
  // A size of 0 is also what /proc says of files that have content. Standard input may stand in
  // the middle of a file; then the rest is read.
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    file.state_ = state_of(status);
    file.from_start_ = ::lseek(number, 0, SEEK_CUR) == 0;
  }
  return file;
}

Result<std::size_t> InputFile::read(char* into, std::size_t most) const {
  while (true) {
    const ssize_t count = ::read(number_, into, most);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno == EISDIR) return open_error(path_, EISDIR);
    if (errno != EINTR) return read_error(path_, errno);
  }
}

std::optional<Bytes> InputFile::map() const {
  if (!state_ || !from_start_) return std::nullopt;
  const auto size = static_cast<std::size_t>(state_->size);
  void* const begin = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, number_, 0);
  if (begin == MAP_FAILED) return std::nullopt;
  ::madvise(begin, size, MADV_SEQUENTIAL);
  ::madvise(begin, size, MADV_WILLNEED);
  return Bytes{
      std::shared_ptr<const void>(
          begin, [size](const void* mapped) { ::munmap(const_cast<void*>(mapped), size); }),
      std::string_view(static_cast<const char*>(begin), size)};
}

Status InputFile::check_unchanged() const {
  if (!state_) return std::monostate{};
  struct stat status = {};
  if (::fstat(number_, &status) != 0) return read_error(path_, errno);
  if (state_of(status) == *state_) return std::monostate{};
  return written_meanwhile(path_);
}

Error written_meanwhile(const std::string& path) {
  return {ErrorCode::kReadFailed,
          "this file was written to while it was read, so the answer would be about neither of "
          "the two; read a copy that stays as it is",
          {source_name(path)}};
}

}  // namespace beespace::io
