// Telemetry logs of MAVLink (.tlog): before each frame, when it came, in eight bytes.
#pragma once

#include "io/mavlink/mavlink_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// Whether it is one, by the first frames; what lies before them may be damaged.
bool is_telemetry_log(std::string_view bytes);

// Whether it is a stream as it comes over the air, without these times: in a log a frame is
// followed by 0, the first byte of one.
bool is_stream_without_times(std::string_view bytes);
// What to say of one: as it comes, and of a file.
inline constexpr std::string_view kStreamOverTheAir =
    "a stream of MAVLink without the times of a log";
inline constexpr std::string_view kStreamWithoutTimes =
    "a stream of MAVLink without the times of a log, as MAVProxy writes it to .tlog.raw; name the "
    ".tlog beside it, which has them; where there is none, play the stream into MAVProxy or "
    "QGroundControl, which write one";

// Whether what comes may be a log, by its first nine bytes: a time of these decades, and how a
// frame begins. No text begins so.
inline constexpr std::size_t kTelemetryFront = 9;
bool begins_as_telemetry_log(std::string_view bytes);

// No time and frame together are longer.
inline constexpr std::size_t kLongestLogged = 8 + 280;
// The size of the time and the frame that `bytes` begin with; nothing where there is none, or not
// all of it.
std::optional<std::size_t> logged_frame_size(std::string_view bytes);
// Whether all of `bytes`, which are no frame, may be the beginning of one.
bool may_be_cut_frame(std::string_view bytes);

// The same two of a stream without times.
std::optional<std::size_t> streamed_frame_size(std::string_view bytes);
bool may_be_cut_streamed_frame(std::string_view bytes);
// `frame`, one of such a stream, as a log has it: behind that time, in microseconds since 1970.
std::string logged_frame(std::string_view frame, std::uint64_t micros);

// A walk over the frames of a log. What is no frame, or one with a wrong checksum, is passed over
// byte by byte until the next one.
class TelemetryWalk {
 public:
  explicit TelemetryWalk(std::string_view bytes) : bytes_(bytes) {}

  // To the next frame; false when there is none.
  bool next();

  [[nodiscard]] const MavlinkFrame& frame() const { return frame_; }
  // Microseconds since 1970.
  [[nodiscard]] std::uint64_t stamp() const { return stamp_; }
  // 0-based, of the current frame.
  [[nodiscard]] std::uint64_t index() const { return frames_ - 1; }

  // So far: how many bytes were passed over, and in how many places.
  [[nodiscard]] std::uint64_t damaged_bytes() const { return damaged_bytes_; }
  [[nodiscard]] std::uint64_t damaged_places() const { return damaged_places_; }
  // At the end: whether the last frame is not all there.
  [[nodiscard]] bool cut_short() const { return cut_short_; }

 private:
  bool take(std::size_t at);
  void end(std::size_t from);

  std::string_view bytes_;
  std::size_t at_ = 0;
  MavlinkFrame frame_ = {};
  std::uint64_t stamp_ = 0;
  std::uint64_t frames_ = 0;
  std::uint64_t damaged_bytes_ = 0;
  std::uint64_t damaged_places_ = 0;
  bool cut_short_ = false;
};

}  // namespace beespace::io
