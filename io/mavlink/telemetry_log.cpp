#include "io/mavlink/telemetry_log.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

constexpr std::size_t kStamp = 8;  // bytes before each frame

std::uint64_t stamp_at(std::string_view bytes, std::size_t at) {
  std::uint64_t stamp = 0;
  for (std::size_t i = 0; i < kStamp; ++i) {
    stamp = stamp << 8u | static_cast<unsigned char>(bytes[at + i]);
  }
  return stamp;
}

// Until the year 2255: beyond that a double does not hold every microsecond, and hardly any bytes
// that are no time begin with eleven zero bits.
bool is_stamp(std::uint64_t stamp) {
  return stamp < std::uint64_t{1} << 53u;
}

bool may_begin(std::string_view bytes, std::size_t at) {
  return at + kStamp < bytes.size() && is_mavlink_magic(bytes[at + kStamp]) &&
         is_stamp(stamp_at(bytes, at));
}

// A frame behind its stamp. Where its checksum cannot be compared, what follows must look right:
// nothing, the beginning of another, or too little to tell.
std::optional<MavlinkFrame> frame_at(std::string_view bytes, std::size_t at) {
  if (!may_begin(bytes, at)) return std::nullopt;
  const auto frame = read_mavlink_frame(bytes.substr(at + kStamp));
  if (!frame || frame->checksum == Checksum::kWrong) return std::nullopt;
  if (frame->checksum == Checksum::kRight) return frame;
  const std::size_t behind = at + kStamp + frame->size;
  if (behind + kStamp >= bytes.size() || may_begin(bytes, behind)) return frame;
  return std::nullopt;
}

}  // namespace

bool is_telemetry_log(std::string_view bytes) {
  constexpr std::size_t kLookedAt = 4096;
  for (std::size_t at = 0; at < std::min(bytes.size(), kLookedAt); ++at) {
    const auto frame = frame_at(bytes, at);
    if (!frame) continue;
    // A short file of anything may end like one frame of an unknown message.
    const std::size_t behind = at + kStamp + frame->size;
    if (at == 0 || frame->checksum == Checksum::kRight || may_begin(bytes, behind)) return true;
  }
  return false;
}

bool is_stream_without_times(std::string_view bytes) {
  constexpr std::size_t kLookedAt = 65'536;
  for (std::size_t at = 0; at < std::min(bytes.size(), kLookedAt); ++at) {
    if (!is_mavlink_magic(bytes[at])) continue;
    const auto frame = read_mavlink_frame(bytes.substr(at));
    if (!frame || frame->checksum != Checksum::kRight) continue;
    const auto next = read_mavlink_frame(bytes.substr(at + frame->size));
    if (!next || next->checksum == Checksum::kWrong) continue;
    const std::size_t behind = at + frame->size + next->size;
    if (behind == bytes.size() || is_mavlink_magic(bytes[behind])) return true;
  }
  return false;
}

bool begins_as_telemetry_log(std::string_view bytes) {
  constexpr std::uint64_t kEarliestMicros = 1'000'000'000'000'000;  // the year 2001
  constexpr std::uint64_t kLatestMicros = 5'000'000'000'000'000;    // 2128
  if (bytes.size() < kTelemetryFront || !may_begin(bytes, 0)) return false;
  const std::uint64_t stamp = stamp_at(bytes, 0);
  return stamp >= kEarliestMicros && stamp < kLatestMicros;
}

std::optional<std::size_t> logged_frame_size(std::string_view bytes) {
  const auto frame = frame_at(bytes, 0);
  if (!frame) return std::nullopt;
  return kStamp + frame->size;
}

bool may_be_cut_frame(std::string_view bytes) {
  return bytes.size() <= kStamp ||
         (may_begin(bytes, 0) && !read_mavlink_frame(bytes.substr(kStamp)));
}

std::optional<std::size_t> streamed_frame_size(std::string_view bytes) {
  if (bytes.empty() || !is_mavlink_magic(bytes.front())) return std::nullopt;
  const auto frame = read_mavlink_frame(bytes);
  if (!frame || frame->checksum == Checksum::kWrong) return std::nullopt;
  const bool followed = bytes.size() == frame->size || is_mavlink_magic(bytes[frame->size]);
  if (frame->checksum == Checksum::kUnknown && !followed) return std::nullopt;
  return frame->size;
}

bool may_be_cut_streamed_frame(std::string_view bytes) {
  return bytes.empty() || (is_mavlink_magic(bytes.front()) && !read_mavlink_frame(bytes));
}

std::string logged_frame(std::string_view frame, std::uint64_t micros) {
  std::string logged;
  logged.reserve(kStamp + frame.size());
  for (std::size_t i = 0; i < kStamp; ++i) {
    logged += static_cast<char>(micros >> (8u * (kStamp - 1 - i)) & 0xFFu);
  }
  logged += frame;
  return logged;
}

bool TelemetryWalk::take(std::size_t at) {
  const auto frame = frame_at(bytes_, at);
  if (!frame) return false;
  frame_ = *frame;
  stamp_ = stamp_at(bytes_, at);
  at_ = at + kStamp + frame->size;
  ++frames_;
  return true;
}

bool TelemetryWalk::next() {
  const std::size_t from = at_;
  for (std::size_t at = from; at < bytes_.size(); ++at) {
    if (!take(at)) continue;
    if (at > from) {
      damaged_bytes_ += at - from;
      ++damaged_places_;
    }
    return true;
  }
  end(from);
  return false;
}

void TelemetryWalk::end(std::size_t from) {
  at_ = bytes_.size();
  if (from >= bytes_.size()) return;
  // All of a frame that is there is right as far as it goes.
  cut_short_ = may_be_cut_frame(bytes_.substr(from));
  if (cut_short_) return;
  damaged_bytes_ += bytes_.size() - from;
  ++damaged_places_;
}

}  // namespace beespace::io
