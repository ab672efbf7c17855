// Live input, line by line: where a bee is now, as each line says it.
//
// The first line tells the kind. A line is
// - a record of a table of fixes, whose first line is the header ("id,time_s,lon,lat,height"), or
//   which RecordingOptions::columns describes; the same words as in load_recording.hpp;
// - or a JSON object, whose keys are such words: {"id": "a", "time_s": 1, "x": 2, "y": 3, "z": 4};
// - or an object of readsb's JSON port: {"now": ..., "hex": ..., "lat": ..., "alt_geom": ...}. Its
//   time is `now` less `seen_pos`: an object without `now` has no time and is refused;
// - or a message of BaseStation (SBS-1), of which MSG,3 completes a position.
// - or, of a telemetry log of MAVLink (.tlog), a frame behind its time: take_frame(). Metres (of
//   message 32) are taken where RecordingOptions::frame says so.
// Where the first lines cannot be read, as in the middle of a stream, the next one tells the kind.
//
// Among lines of every kind an object {"event": "leave", "id": "a"} says that a bee is there no
// longer.
//
// Every bee needs an id and a time. Nothing is converted but units, as in recording.hpp. Memory is
// bounded by the longest line, and for BaseStation by the velocity and name of 65,536 aircraft.
// One thread at a time.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/recording.hpp"
#include "io/recording/recording_options.hpp"
#include "io/units/heights.hpp"
#include "io/units/unit_taken.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

inline constexpr Velocity kNoVelocity = {std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::quiet_NaN()};

struct ReportLine {
  std::string_view id = {};     // as long as the line, and until the next one is taken
  std::string_view label = {};  // the same: what it is called beside its id, or nothing
  double time_s = 0.0;          // since 1970 (UTC), or from a zero of the input's own
  Point position = {};          // metres; or longitude, latitude in degrees, height in metres
  // The height, or z, as the line states it: in that unit, the same for all lines.
  double stated_height = 0.0;
  Unit height_unit = Unit::kMetre;
  Frame frame = Frame::kMetres;  // which of them: never kAuto, and the same for all lines
  // m/s along x, y, z; or east, north, up beside degrees. Nothing unless all of it is known.
  std::optional<Velocity> velocity = {};
  Velocity stated_velocity = kNoVelocity;  // the same with not-a-numbers for what is not known
  bool since_1970 = false;
  // Which column or key the time is of, where it counts from when each vehicle was switched on, so
  // that those of several cannot be compared; or nothing. As long as the id.
  std::string_view own_clock = {};
  bool leaves = false;  // only the id is known: it is there no longer
};

class JsonLine;
class LineReader;

class ReportLines {
 public:
  // Of `options` skip_bad, format and progress are of no account: a bad line is for the caller to
  // pass over. `source` is what errors blame.
  explicit ReportLines(RecordingOptions options = {}, std::string source = "<stdin>");
  ReportLines(const ReportLines&) = delete;
  ReportLines& operator=(const ReportLines&) = delete;
  ReportLines(ReportLines&&) noexcept;
  ReportLines& operator=(ReportLines&&) noexcept;
  ~ReportLines();

  // The next line, with or without its line end. Nothing where it says no position: blank lines,
  // the header, and what is left out as load_recording() leaves it out (see notes()).
  // Errors: those of load_recording(), with source and line; the next line may follow.
  Result<std::optional<ReportLine>> take(std::string_view line);

  // The same of a telemetry log, all of whose frames come so: one behind its time, or bytes that
  // are none, which is an error. Errors have the number of the frame, from 0.
  Result<std::optional<ReportLine>> take_frame(std::string_view logged);

  // Whether a line was understood as a report, or may have been. Until then an error is likely to
  // be about the input as a whole: columns that are missing, a unit or a frame that must be said.
  [[nodiscard]] bool understood() const { return understood_; }

  // Of a line that is an error: whose it was, as far as that could be read; or empty. As long as
  // the line.
  [[nodiscard]] std::string_view bad_id() const { return bad_id_; }
  // Of a line that is no report: whose it was where it speaks of a bee that flies and does not say
  // where; or empty. As long as the line.
  [[nodiscard]] std::string_view hidden_id() const { return hidden_id_; }
  // Whether that error is about all lines to come: another header, of other columns, or heights
  // that are in another unit than those before were taken for.
  [[nodiscard]] bool ended() const;

  [[nodiscard]] std::uint64_t lines() const { return lines_; }
  // Whether these are frames of a telemetry log.
  [[nodiscard]] bool in_frames() const { return in_frames_; }
  [[nodiscard]] std::string description() const;  // "text, comma-separated", "readsb JSON", ...
  [[nodiscard]] HeightDatum heights() const;
  // Whether the format, or what columns are called so far, says that these are aircraft.
  [[nodiscard]] bool of_aircraft() const;
  [[nodiscard]] std::vector<UnitTaken> units() const;
  // What was decided, and how much was left out so far, to be told.
  [[nodiscard]] std::vector<std::string> notes() const;
  // Of how many it is not known when they were where they say, as MissingRecords::untimed.
  [[nodiscard]] std::uint64_t untimed() const;

 private:
  Result<std::optional<ReportLine>> read(std::string_view line);
  Result<std::optional<ReportLine>> read_report(std::string_view line);
  Result<std::optional<ReportLine>> leave(std::string_view line);
  // What came before was taken for metres in good faith; nothing is any more.
  [[nodiscard]] std::optional<Error> height_doubt(const ReportLine& report) const;

  RecordingOptions options_;
  std::string source_;
  bool doubted_ = false;
  std::unique_ptr<LineReader> reader_;  // of the kind that the first line told
  std::unique_ptr<LineReader> later_;   // until a line is understood: of a later one
  std::unique_ptr<JsonLine> leave_;
  std::string_view bad_id_ = {};
  std::string_view hidden_id_ = {};
  std::uint64_t lines_ = 0;
  bool understood_ = false;
  bool in_frames_ = false;
};

}  // namespace beespace::io
