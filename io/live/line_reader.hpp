// One kind of live input, line by line; ReportLines chooses which.
#pragma once

#include "io/live/report_lines.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// What a reader says of all its lines.
struct LineFacts {
  std::string description = {};
  HeightDatum heights = HeightDatum::kUnstated;
  std::vector<std::string> notes = {};
  std::vector<UnitTaken> units = {};
  std::uint64_t untimed = 0;  // as MissingRecords::untimed
};

class LineReader {
 public:
  LineReader() = default;
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  virtual ~LineReader() = default;

  // `line` has no line end and is not blank. Errors have a line only where it is not this one.
  virtual Result<std::optional<ReportLine>> read(std::string_view line) = 0;
  // Whether the lines to come are known to be understood, each for itself.
  [[nodiscard]] virtual bool settled() const = 0;
  [[nodiscard]] virtual LineFacts facts() const = 0;
  // Whose the last line was, as far as that could be read; or empty. As long as the line.
  [[nodiscard]] virtual std::string_view last_id() const { return {}; }
  // Of a line that is no report: whether it speaks of a bee that flies, and does not say where.
  [[nodiscard]] virtual bool hides() const { return false; }
  // Whether its format, or what its columns are called so far, says that these are aircraft.
  [[nodiscard]] virtual bool of_aircraft() const { return false; }
  // Whether the last error is about all lines to come: they cannot be understood as those before.
  [[nodiscard]] virtual bool ended() const { return false; }
};

// `first_line` is where the table begins, counted from 1.
std::unique_ptr<LineReader> make_table_lines(const RecordingOptions& options,
                                             std::uint64_t first_line);
std::unique_ptr<LineReader> make_json_lines(const RecordingOptions& options);

std::unique_ptr<LineReader> make_aircraft_lines(const RecordingOptions& options);
std::unique_ptr<LineReader> make_base_station_lines(const RecordingOptions& options);

// Of a telemetry log: each "line" is a time and a frame, or bytes that are none.
std::unique_ptr<LineReader> make_telemetry_frames(const RecordingOptions& options);

// Of readsb's objects, not of words of another source; `line` is one object.
bool is_aircraft_line(std::string_view line);

}  // namespace beespace::io
