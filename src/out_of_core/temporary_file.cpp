#include "out_of_core/temporary_file.hpp"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

namespace beespace::out_of_core {

namespace {

Error failed(ErrorCode code, const std::string& what, const std::string& folder, int number) {
  return {code, what + " in '" + folder + "': " + std::generic_category().message(number), {}};
}

std::string megabytes(std::uint64_t bytes) {
  return std::to_string((bytes + 999'999) / 1'000'000) + " MB";
}

// For less it is not worth while.
constexpr std::uint64_t kLeastRoom = std::uint64_t{1} << 20U;

// Not all file systems know files without a name.
int open_unnamed(const std::string& folder) {
#ifdef O_TMPFILE
  const int unnamed = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (unnamed >= 0) return unnamed;
#endif
  std::string path = folder + "/beespace-XXXXXX";
  const int named = ::mkostemp(path.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(path.c_str());
  return named;
}

}  // namespace

Result<TemporaryFile> TemporaryFile::make(const std::string& folder, std::uint64_t needed_bytes) {
  struct statvfs room {};
  if (::statvfs(folder.c_str(), &room) != 0) {
    return failed(ErrorCode::kWriteFailed, "cannot put a temporary file", folder, errno);
  }
  const std::uint64_t free_bytes = std::uint64_t{room.f_bavail} * room.f_frsize;
  if (free_bytes < needed_bytes) {
    return Error{ErrorCode::kWriteFailed,
                 "the search needs up to " + megabytes(needed_bytes) +
                     " of disk for a while, and '" + folder + "' has " + megabytes(free_bytes) +
                     ": name a folder with more room, or allow more memory",
                 {}};
  }
  const int descriptor = open_unnamed(folder);
  if (descriptor < 0) {
    return failed(ErrorCode::kWriteFailed, "cannot put a temporary file", folder, errno);
  }
  TemporaryFile file(descriptor, folder);
  file.take_room(needed_bytes);
  return file;
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      folder_(std::move(other.folder_)),
      size_(other.size_.load()),
      room_(other.room_.load()) {
}

TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(folder_, other.folder_);
  size_ = other.size_.exchange(size_);
  room_ = other.room_.exchange(room_);
  return *this;
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

// Blocks of a disk that are found one by one, while they are written, are written several times as
// slowly. Whether there is room in the end is for writing to say: not all file systems can tell.
void TemporaryFile::take_room(std::uint64_t end) {
#ifdef __linux__
  std::uint64_t begin = room_;
  if (end <= begin || end < kLeastRoom) return;
  end = std::max(end, begin + begin / 8);
  if (!room_.compare_exchange_strong(begin, end)) return;  // another thread does
  ::fallocate(descriptor_, FALLOC_FL_KEEP_SIZE, static_cast<off_t>(begin),
              static_cast<off_t>(end - begin));
#else
  static_cast<void>(end);
#endif
}

Result<std::uint64_t> TemporaryFile::append(std::span<const std::byte> bytes) {
  const std::uint64_t begin = size_.fetch_add(bytes.size());
  take_room(begin + bytes.size());
  std::uint64_t offset = begin;
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      return failed(ErrorCode::kWriteFailed, "cannot write a temporary file", folder_,
                    written < 0 ? errno : ENOSPC);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
  return begin;
}

Status TemporaryFile::read(std::uint64_t offset, std::span<iovec> parts) const {
  while (!parts.empty()) {
    if (parts.front().iov_len == 0) {
      parts = parts.subspan(1);
      continue;
    }
    const ssize_t count = ::preadv(descriptor_, parts.data(), static_cast<int>(parts.size()),
                                   static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      return failed(ErrorCode::kReadFailed, "cannot read a temporary file", folder_, errno);
    }
    if (count == 0) {
      return Error{ErrorCode::kCorrupt, "a temporary file in '" + folder_ + "' ends too early", {}};
    }
    offset += static_cast<std::uint64_t>(count);
    auto left = static_cast<std::size_t>(count);
    while (left > 0) {
      iovec& part = parts.front();
      const std::size_t taken = left < part.iov_len ? left : part.iov_len;
      part.iov_base = static_cast<std::byte*>(part.iov_base) + taken;
      part.iov_len -= taken;
      left -= taken;
      if (part.iov_len == 0) parts = parts.subspan(1);
    }
  }
  return std::monostate{};
}

}  // namespace beespace::out_of_core
