#include "io/bytes/scratch_file.hpp"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace beespace::io {
namespace {

Error scratch_error(ErrorCode code, const std::string& doing, const std::string& folder,
                    int error_number) {
  return {code, doing + " in '" + folder + "': " + std::strerror(error_number), {}};
}

std::uint32_t checksum_of(std::string_view bytes) {
  // Of those that zlib has the fastest: small blocks are read in any order.
  const uLong none = adler32_z(0, nullptr, 0);
  return static_cast<std::uint32_t>(
      adler32_z(none, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

Result<ScratchFile> ScratchFile::make(const std::string& folder) {
#ifdef O_TMPFILE
  Descriptor unnamed(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
  if (unnamed.is_open()) return ScratchFile(std::move(unnamed), folder);
#endif
  // Not all file systems know files without a name.
  std::string path = folder + "/beespace-XXXXXX";
  Descriptor named(::mkostemp(path.data(), O_CLOEXEC));
  if (!named.is_open()) {
    return scratch_error(ErrorCode::kWriteFailed, "cannot put a temporary file", folder, errno);
  }
  ::unlink(path.c_str());
  return ScratchFile(std::move(named), folder);
}

Error ScratchFile::failed(ErrorCode code, const char* doing, int error_number) const {
  return scratch_error(code, std::string("cannot ") + doing + " a temporary file", folder_,
                       error_number);
}

Result<ScratchFile::Block> ScratchFile::append(std::string_view bytes) {
  const Block block{size_, static_cast<std::uint32_t>(bytes.size()), checksum_of(bytes)};
  while (!bytes.empty()) {
    const ssize_t count =
        ::pwrite(file_.number(), bytes.data(), bytes.size(), static_cast<off_t>(size_));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return failed(ErrorCode::kWriteFailed, "write", count < 0 ? errno : ENOSPC);
    bytes.remove_prefix(static_cast<std::size_t>(count));
    size_ += static_cast<std::uint64_t>(count);
  }
  return block;
}

Status ScratchFile::read(const Block& block, std::span<char> into) const {
  std::size_t done = 0;
  while (done < block.size) {
    const ssize_t count = ::pread(file_.number(), into.data() + done, block.size - done,
                                  static_cast<off_t>(block.offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failed(ErrorCode::kReadFailed, "read", errno);
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  if (done == block.size && checksum_of({into.data(), block.size}) == block.checksum) {
    return std::monostate{};
  }
  return Error{ErrorCode::kCorrupt,
               "a temporary file in '" + folder_ +
                   "' does not hold what was written to it; check the disk, or name another "
                   "folder",
               {}};
}

Result<std::uint64_t> free_bytes_in(const std::string& folder) {
  struct statvfs room {};
  if (::statvfs(folder.c_str(), &room) != 0) {
    return scratch_error(ErrorCode::kWriteFailed, "cannot put temporary files", folder, errno);
  }
  return std::uint64_t{room.f_bavail} * room.f_frsize;
}

}  // namespace beespace::io
