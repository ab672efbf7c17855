#include "io/bytes/file_lock.hpp"

#include "io/bytes/durable_file.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>

namespace beespace::io {

Result<FileLock> FileLock::take(const std::string& path, const char* holder) {
  constexpr mode_t kMode = 0644;
  const std::string beside = file_behind(path) + ".lock";
  FileLock lock(Descriptor(::open(beside.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode)));
  const char* problem = lock.file_.is_open() ? nullptr : std::strerror(errno);
  if (problem == nullptr) {
    int done = -1;
    do {
      done = ::flock(lock.file_.number(), LOCK_EX | LOCK_NB);
    } while (done != 0 && errno == EINTR);
    if (done == 0) return lock;
    if (errno == EWOULDBLOCK) {
      return Error{ErrorCode::kCannotOpen,
                   std::string("another ") + holder + " works with this store; stop it first",
                   {.source = path}};
    }
    problem = std::strerror(errno);
  }
  return Error{
      ErrorCode::kWriteFailed,
      std::string("cannot lock this file, by another beside it that ends in .lock: ") + problem,
      {.source = path}};
}

}  // namespace beespace::io
