#include "cli/input/line_source.hpp"

#include "cli/console/signals.hpp"
#include "io/mavlink/telemetry_log.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <utility>

namespace beespace::cli {
namespace {

Error system_error(ErrorCode code, const std::string& what, const std::string& source) {
  ErrorLocation location;
  location.source = source;
  if (errno == EISDIR) {
    return {ErrorCode::kCannotOpen,
            "this is a directory; name a file in it, or ask 'beespace replay' about all of them",
            location};
  }
  if (errno == ENOENT) {
    return {code, "there is no such file; check the name and the folder", location};
  }
  if (errno == EACCES) {
    return {code, "not allowed to read this file; check its permissions (ls -l)", location};
  }
  return {code, what + ": " + std::strerror(errno), location};
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::uint64_t micros_since_1970() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(since).count());
}

}  // namespace

LineSource::LineSource(std::string name, int descriptor, bool owned)
    : name_(std::move(name)), descriptor_(descriptor), owned_(owned), looked_s_(seconds_now()) {
  struct stat status {};
  live_ = ::fstat(descriptor, &status) == 0 &&
          (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode) || ::isatty(descriptor) == 1);
}

Result<LineSource> LineSource::open(const std::string& path) {
  if (path == "-") return LineSource("<stdin>", STDIN_FILENO, false);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return system_error(ErrorCode::kCannotOpen, "cannot open", path);
  return LineSource(path, descriptor, true);
}

LineSource::LineSource(LineSource&& other) noexcept
    : name_(std::move(other.name_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      owned_(std::exchange(other.owned_, false)),
      live_(other.live_),
      looked_s_(other.looked_s_),
      ended_(other.ended_),
      cutting_(other.cutting_),
      buffer_(std::move(other.buffer_)),
      begin_(other.begin_),
      compressed_(other.compressed_),
      coming_(other.coming_),
      unpacking_(std::move(other.unpacking_)),
      packed_(std::move(other.packed_)),
      damaged_(other.damaged_),
      stamped_(std::move(other.stamped_)) {
}

LineSource::~LineSource() {
  if (owned_) ::close(descriptor_);
}

bool LineSource::take_line(std::string_view& line) {
  while (true) {
    const std::string_view rest = std::string_view(buffer_).substr(begin_);
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) {
      if (ended_ && !rest.empty() && !cutting_) {
        line = rest;
        begin_ = buffer_.size();
        return true;
      }
      if (rest.size() <= kLongest) return false;
      // Shown once as far as it goes; what follows until its end is no line of its own.
      const bool shown = std::exchange(cutting_, true);
      line = rest.substr(0, kLongest);
      begin_ = buffer_.size();
      if (shown) return false;
      return true;
    }
    begin_ += end + 1;
    if (std::exchange(cutting_, false)) continue;
    line = rest.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return true;
  }
}

// One frame behind its time, or all bytes that are none before the next.
bool LineSource::take_frame(std::string_view& frame) {
  while (true) {
    const std::string_view rest = std::string_view(buffer_).substr(begin_);
    const std::string_view ahead = rest.substr(damaged_);
    const auto size = frame_size(ahead);
    const bool over = ended_ && ahead.empty();
    if ((size || over || damaged_ >= kLongest) && damaged_ > 0) {
      frame = rest.substr(0, std::exchange(damaged_, 0));
      begin_ += frame.size();
      return true;
    }
    if (size) {
      frame = ahead.substr(0, *size);
      begin_ += *size;
      if (without_times()) {
        stamped_ = io::logged_frame(frame, micros_since_1970());
        frame = stamped_;
      }
      return true;
    }
    if (over) return false;
    if (ended_ && damaged_ == 0 && may_be_cut(ahead)) {
      begin_ = buffer_.size();  // the last frame is cut short
      return false;
    }
    if (!ended_ && ahead.size() < io::kLongestLogged) return false;
    ++damaged_;
  }
}

bool LineSource::comes_in_frames() {
  if (coming_ != Coming::kNotKnown) return coming_ != Coming::kText;
  const std::string_view front = std::string_view(buffer_).substr(begin_);
  // Text is known by its first byte, so that a short line need not wait for more.
  const bool may_be_log = front.empty() || front.front() == '\0';
  if (may_be_log && front.size() < io::kTelemetryFront && !ended_) return false;
  if (io::begins_as_telemetry_log(front)) {
    coming_ = Coming::kLog;
  } else if (io::streamed_frame_size(front)) {
    coming_ = Coming::kStream;
  } else if (!ended_ && io::may_be_cut_streamed_frame(front)) {
    return false;
  } else {
    coming_ = Coming::kText;
  }
  return coming_ != Coming::kText;
}

std::optional<std::size_t> LineSource::frame_size(std::string_view bytes) const {
  return without_times() ? io::streamed_frame_size(bytes) : io::logged_frame_size(bytes);
}

bool LineSource::may_be_cut(std::string_view bytes) const {
  return without_times() ? io::may_be_cut_streamed_frame(bytes) : io::may_be_cut_frame(bytes);
}

Status LineSource::add(std::string_view bytes) {
  packed_.append(bytes);
  if (!compressed_) {
    if (packed_.size() < 2 && !ended_) return std::monostate{};
    compressed_ = io::is_packed(packed_);
    if (*compressed_) unpacking_.emplace(name_);
  }
  if (!*compressed_) {
    buffer_.append(std::exchange(packed_, {}));
    return std::monostate{};
  }
  constexpr std::size_t kRoom = std::size_t{1} << 17;
  std::string_view packed = packed_;
  for (bool full = true; full;) {
    io::GrowingBytes room;
    room.make_room(kRoom);
    if (auto status = unpacking_->unpack(packed, ended_, room); !status) return status;
    buffer_.append(room.view());
    full = room.free_size() == 0;
  }
  packed_.erase(0, packed_.size() - packed.size());
  return std::monostate{};
}

Result<LineSource::Got> LineSource::next(std::string_view& line, int patience_ms) {
  while (!interrupted()) {
    const bool frames = comes_in_frames();
    if (frames ? take_frame(line) : coming_ == Coming::kText && take_line(line)) {
      return frames ? Got::kFrame : Got::kLine;
    }
    if (ended_) return Got::kEnd;
    buffer_.erase(0, begin_);
    begin_ = 0;
    pollfd waiting{descriptor_, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, patience_ms);
    looked_s_ = seconds_now();
    if (ready == 0) return Got::kNothingYet;
    std::array<char, std::size_t{1} << 16> block;
    const ssize_t count = ready < 0 ? -1 : ::read(descriptor_, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return system_error(ErrorCode::kReadFailed, "cannot read", name_);
    if (count == 0) ended_ = true;
    if (auto status = add({block.data(), static_cast<std::size_t>(count)}); !status) {
      return status.error();
    }
  }
  return Got::kEnd;
}

}  // namespace beespace::cli
