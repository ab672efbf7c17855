#include "io/bytes/atomic_output.hpp"

#include "io/bytes/gzip_stream.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 20;

// ---- Temporary files that a signal handler must find --------------------------------------

enum SlotState : int { kFree, kFilling, kOpen };

struct Slot {
  std::atomic<int> state{kFree};
  std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<int>::is_always_lock_free, "signal handlers may use nothing else");

constexpr std::size_t kMostOpen = 16;
std::array<Slot, kMostOpen> open_files;

std::size_t claim_slot() {
  for (std::size_t i = 0; i < open_files.size(); ++i) {
    int expected = kFree;
    if (open_files[i].state.compare_exchange_strong(expected, kFilling)) return i;
  }
  return kMostOpen;
}

// ---- Paths --------------------------------------------------------------------------------

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

// Where a chain of symbolic links leads, also when nothing is there yet; sets errno on failure.
bool follow_links(std::string& path) {
  constexpr int kMostLinks = 40;
  for (int i = 0; i < kMostLinks; ++i) {
    struct stat status = {};
    if (::lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return true;
    std::array<char, PATH_MAX> target = {};
    const ssize_t size = ::readlink(path.c_str(), target.data(), target.size());
    if (size < 0) return false;
    const std::string text(target.data(), static_cast<std::size_t>(size));
    path = !text.empty() && text.front() == '/' ? text : folder_of(path).append(text);
  }
  errno = ELOOP;
  return false;
}

bool folder_exists(const std::string& path) {
  const std::string folder = folder_of(path);
  struct stat status = {};
  return ::stat(folder.empty() ? "." : folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

Error write_error(const std::string& path, int error_number) {
  std::string message;
  switch (error_number) {
    case ENOENT:
      message = folder_exists(path) ? "the system lets no file be made in this folder; name another"
                                    : "the folder does not exist; create it first";
      break;
    case ENOTDIR:
      message = "a part of this path is a file, not a folder; check the name";
      break;
    case EROFS:
      message = "nothing can be written in this file system; name another place";
      break;
    case ENAMETOOLONG:
      message = "the name is too long; choose a shorter one";
      break;
    case EISDIR:
      message = "this is a directory; name a file";
      break;
    case EACCES:
    case EPERM:
      message = "not allowed to write here; check the permissions";
      break;
    case ENOSPC:
      message = "the disk is full; free some room or write elsewhere";
      break;
    case EMFILE:
      message = "too many output files are open";
      break;
    default:
      message = "check the place and try again";
      break;
  }
  return {ErrorCode::kWriteFailed,
          "cannot write (" + std::string(std::strerror(error_number)) + "): " + message,
          {path == "-" ? "<stdout>" : path}};
}

}  // namespace

void discard_open_outputs_in_signal_handler() noexcept {
  const int saved = errno;
  for (Slot& slot : open_files) {
    if (slot.state.load() == kOpen) ::unlink(slot.path.data());
  }
  errno = saved;
}

AtomicOutput::AtomicOutput() = default;

Result<AtomicOutput> AtomicOutput::open(const std::string& path, Packing packing) {
  auto output = open_plain(path);
  if (output && packing == Packing::kGzip) output->gzip_ = std::make_unique<GzipStream>();
  return output;
}

Result<AtomicOutput> AtomicOutput::open_plain(const std::string& path) {
  AtomicOutput output;
  output.path_ = path;
  // By its other name, standard output must not be replaced or written to from the start.
  if (path == "-" || path == "/dev/stdout") {
    output.descriptor_ = STDOUT_FILENO;
    output.buffer_.reserve(kBufferSize);
    return output;
  }
  struct stat status = {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) return write_error(path, errno);
  if (exists && S_ISDIR(status.st_mode)) return write_error(path, EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    output.descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (output.descriptor_ < 0) return write_error(path, errno);
    output.buffer_.reserve(kBufferSize);
    return output;
  }
  std::string target = path;
  if (!follow_links(target)) return write_error(path, errno);
  // A rename would replace a write-protected file too: ask first.
  if (exists && ::access(target.c_str(), W_OK) != 0) return write_error(path, errno);
  if (target.empty() || target.back() == '/') return write_error(path, EISDIR);
  output.final_path_ = std::move(target);
  if (!output.create_temporary()) return write_error(path, output.error_number_);
  if (exists) ::fchmod(output.descriptor_, status.st_mode & 07777u);
  output.buffer_.reserve(kBufferSize);
  return output;
}

bool AtomicOutput::create_temporary() {
  constexpr int kMostTries = 1000;
  static_assert(kNotRegistered == kMostOpen);
  registered_ = claim_slot();
  error_number_ = registered_ == kNotRegistered ? EMFILE : 0;
  for (int i = 0; i < kMostTries && error_number_ == 0; ++i) {
    const std::string name = folder_of(final_path_) + ".beespace-" + std::to_string(::getpid()) +
                             "-" + std::to_string(i) + ".tmp";
    Slot& slot = open_files[registered_];
    if (name.size() >= slot.path.size()) {
      error_number_ = ENAMETOOLONG;
      break;
    }
    // Registered before it is there: a signal may come as soon as the file exists. The name holds
    // this process's id, so whatever else bears it was left behind by a process that is gone.
    std::memcpy(slot.path.data(), name.c_str(), name.size() + 1);
    slot.state = kOpen;
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      temporary_path_ = name;
      return true;
    }
    slot.state = kFilling;
    if (errno != EEXIST && errno != EINTR) error_number_ = errno;
  }
  if (error_number_ == 0) error_number_ = EEXIST;
  if (registered_ != kNotRegistered) open_files[registered_].state = kFree;
  registered_ = kNotRegistered;
  return false;
}

AtomicOutput::AtomicOutput(AtomicOutput&& other) noexcept {
  *this = std::move(other);
}

AtomicOutput& AtomicOutput::operator=(AtomicOutput&& other) noexcept {
  if (this == &other) return *this;
  discard();
  path_ = std::move(other.path_);
  final_path_ = std::move(other.final_path_);
  temporary_path_ = std::exchange(other.temporary_path_, {});
  descriptor_ = std::exchange(other.descriptor_, -1);
  error_number_ = other.error_number_;
  registered_ = std::exchange(other.registered_, kNotRegistered);
  buffer_ = std::move(other.buffer_);
  gzip_ = std::move(other.gzip_);
  return *this;
}

AtomicOutput::~AtomicOutput() {
  discard();
}

void AtomicOutput::write(std::string_view text) {
  if (!gzip_) return write_plain(text);
  if (!failed()) gzip_->write(text, [this](std::string_view bytes) { write_plain(bytes); });
}

void AtomicOutput::write_plain(std::string_view text) {
  if (text.size() > kBufferSize - buffer_.size()) {
    flush();
    if (text.size() >= kBufferSize) {
      send(text.data(), text.size());
      return;
    }
  }
  buffer_.insert(buffer_.end(), text.begin(), text.end());
}

void AtomicOutput::flush() {
  send(buffer_.data(), buffer_.size());
  buffer_.clear();
}

void AtomicOutput::send(const char* data, std::size_t size) {
  while (size > 0 && error_number_ == 0) {
    const ssize_t count = ::write(descriptor_, data, size);
    if (count >= 0) {
      data += count;
      size -= static_cast<std::size_t>(count);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      pollfd waiting = {descriptor_, POLLOUT, 0};
      ::poll(&waiting, 1, -1);
    } else if (errno != EINTR) {
      error_number_ = errno;
    }
  }
}

Status AtomicOutput::commit() {
  if (gzip_ && !failed()) {
    gzip_->finish([this](std::string_view bytes) { write_plain(bytes); });
  }
  gzip_.reset();
  flush();
  if (descriptor_ > STDERR_FILENO) {
    // Network file systems say only here that the disk is full.
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR && error_number_ == 0) {
      error_number_ = errno;
    }
  }
  if (error_number_ == 0 && !temporary_path_.empty()) {
    if (std::rename(temporary_path_.c_str(), final_path_.c_str()) == 0) {
      temporary_path_.clear();
    } else {
      error_number_ = errno;
    }
  }
  discard();
  if (error_number_ != 0) return error();
  return std::monostate{};
}

bool AtomicOutput::pipe_closed() const {
  return error_number_ == EPIPE;
}

Error AtomicOutput::error() const {
  return write_error(path_, error_number_);
}

void AtomicOutput::discard() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  descriptor_ = -1;
  if (!temporary_path_.empty()) ::unlink(temporary_path_.c_str());
  temporary_path_.clear();
  if (registered_ < open_files.size()) open_files[registered_].state = kFree;
  registered_ = kNotRegistered;
  buffer_.clear();
}

}  // namespace beespace::io
