// Lines as they come from a file or standard input, without waiting for more than there is; of a
// telemetry log its frames, and of a stream of MAVLink without times, as it comes over the air, its
// frames behind the time of this machine. What is compressed is unpacked as it comes.
#pragma once

#include "io/bytes/byte_source.hpp"
#include "io/bytes/gzip.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::cli {

class LineSource {
 public:
  // "-" is standard input. Errors: kCannotOpen.
  static Result<LineSource> open(const std::string& path);
  LineSource(LineSource&& other) noexcept;
  LineSource& operator=(LineSource&&) = delete;
  LineSource(const LineSource&) = delete;
  LineSource& operator=(const LineSource&) = delete;
  ~LineSource();

  enum class Got {
    kLine,
    kFrame,  // of a telemetry log: a time and a frame, or bytes between them that are none
    kNothingYet,
    kEnd,
  };
  // The next line, without its end, valid until the next call; or that none has come for
  // `patience_ms`. A line longer than kLongest is cut there. A signal that has been let wait is an
  // end too. Error: kReadFailed.
  Result<Got> next(std::string_view& line, int patience_ms);

  // Whether the frames are those of a stream without times: each has the time when it was read.
  [[nodiscard]] bool without_times() const { return coming_ == Coming::kStream; }

  // Whether it comes as things happen: from a pipe, a terminal, a connection; not from a file.
  [[nodiscard]] bool live() const { return live_; }
  // When it was read last, or nothing was found there: seconds by a clock that never goes back.
  [[nodiscard]] double looked_s() const { return looked_s_; }

  static constexpr std::size_t kLongest = std::size_t{1} << 20;

 private:
  LineSource(std::string name, int descriptor, bool owned);
  enum class Coming { kNotKnown, kText, kLog, kStream };

  // Whether frames come: once enough is there to tell.
  bool comes_in_frames();
  // Of a log and of a stream; see telemetry_log.hpp.
  [[nodiscard]] std::optional<std::size_t> frame_size(std::string_view bytes) const;
  [[nodiscard]] bool may_be_cut(std::string_view bytes) const;
  bool take_line(std::string_view& line);
  bool take_frame(std::string_view& frame);
  // Behind what is there, unpacked. Errors: those of Unpacking.
  Status add(std::string_view bytes);

  std::string name_;  // what errors blame
  int descriptor_;
  bool owned_;
  bool live_ = false;
  double looked_s_ = 0.0;
  bool ended_ = false;
  bool cutting_ = false;  // the rest of a line that was too long is to be passed over
  std::string buffer_;
  std::size_t begin_ = 0;
  std::optional<bool> compressed_;  // once it is known
  Coming coming_ = Coming::kNotKnown;
  std::optional<io::Unpacking> unpacking_;
  std::string packed_;       // what is to be unpacked
  std::size_t damaged_ = 0;  // bytes at begin_ that are no frame
  std::string stamped_;      // the frame of a stream that was taken last, behind its time
};

}  // namespace beespace::cli
