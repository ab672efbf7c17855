// How a text table is laid out: what separates lines and fields, whether there is a header, and
// which columns hold the position. Found from the first lines, the header and the caller's
// overrides.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/frames/frame_decision.hpp"
#include "io/table/column_options.hpp"
#include "io/table/fields.hpp"
#include "io/units/heights.hpp"
#include "io/units/unit_taken.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

inline constexpr double kScaledPerDegree = 1e7;

// Which columns (0-based) hold which coordinate, and what that says about the frame.
struct ColumnChoice {
  std::array<std::size_t, 3> axes = {0, 1, 2};  // x or longitude, y or latitude, z or height
  std::size_t dimensions = 3;                   // 2: there is no third coordinate, it is 0
  std::optional<std::size_t> id = {};
  Frame evidence = Frame::kAuto;  // what names and overrides say; kAuto: nothing
  std::string reason = {};        // and why
  Naming naming = Naming::kSure;  // how sure that is
  // Of the three, and what is to be said of that; of degrees none.
  std::array<Unit, 3> units = {Unit::kMetre, Unit::kMetre, Unit::kMetre};
  std::vector<UnitTaken> units_taken = {};
  HeightDatum datum = HeightDatum::kUnstated;
  double pixel_m = 1.0;  // of those that are in pixels
  // Longitude and latitude are whole numbers of 1e-7 degrees, which in_metric() makes degrees.
  bool scaled_degrees = false;

  [[nodiscard]] bool is_metric() const {
    return !scaled_degrees &&
           units == std::array<Unit, 3>{Unit::kMetre, Unit::kMetre, Unit::kMetre};
  }
  [[nodiscard]] Unit height_unit() const {
    return dimensions == 3 && units[2] != Unit::kPixel ? units[2] : Unit::kMetre;
  }
};

// What the first records hold in a column. An empty field, or "N/A", is unknown: a number may
// follow.
enum class ColumnContent : std::uint8_t { kUnknown, kNumber, kText };

// Between the fields of records that are put together from others: no text has it.
inline constexpr char kUnitSeparator = '\x1F';

struct TableLayout {
  char line_end = '\n';  // '\r' for files of the old Macintosh
  char delimiter = ',';
  std::string_view header = {};         // the header line, empty when there is none
  std::vector<std::string> names = {};  // of the columns, when there is a header
  std::vector<ColumnContent> contents = {};
  std::size_t columns = 0;             // in every record
  std::size_t data_offset = 0;         // where the first line after the header begins
  bool titles_say_utc = false;         // what stands above the header says that times are of UTC
  std::uint64_t lines_before = 0;      // how many lines lie before that place
  std::uint64_t records_per_line = 1;  // where each line was taken apart into several
  ColumnChoice choice = {};
  std::vector<std::string> notes = {};  // of lines that are passed over
};

// What a layout is told by: the longest line, and the first lines after it.
inline constexpr std::size_t kHeadBytes = kLongestLine + (std::size_t{1} << 17U);

// `text` has no byte-order mark any more. Errors: kNoPoints, kMalformedRecord, kMissingColumn,
// kInvalidArgument, kUnsupportedFormat; without location.source.
Result<TableLayout> find_layout(std::string_view text, const ColumnOptions& options);

// The same without the choice of columns: that is left to who knows what they mean.
Result<TableLayout> find_table(std::string_view text, bool skip_bad);

// An error of the columns as such has the first line of the table; what is wrong with an option has
// none.
Error at_first_line(Error error, const TableLayout& table);

// Whether it begins with "#".
bool has_comment_sign(std::string_view line);

// Whether it is drawn around a table, "+-----+----+", as consoles of databases do.
bool is_ruler(std::string_view line);

// Whether it is a comment, or a ruler: a line behind the header that begins with "#", but not one
// that could be a record that was taken out, or has an id that begins so, since it has a number
// between delimiters: those are errors of read_record() and its like.
bool is_comment(std::string_view line, const TableLayout& layout);

// Whether it is the header again, as where tables were joined one behind the other; perhaps behind
// a byte-order mark.
inline bool repeats_header(std::string_view line, std::string_view header) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (header.empty() || line.size() < header.size()) return false;
  if (line.size() == header.size()) return line == header;
  return line.size() == header.size() + kByteOrderMark.size() && line.starts_with(kByteOrderMark) &&
         line.ends_with(header);
}

// kNoPoints where nothing follows the header.
std::optional<Error> no_record_problem(std::string_view text, const TableLayout& layout);

// The names of a line that can only be a header: words alone, two of which say a position. Nothing
// for other lines.
std::optional<std::vector<std::string>> header_names(std::string_view line, char delimiter);

// "comma", "semicolon", "tab" or "space".
std::string_view delimiter_name(char delimiter);

// The line at `offset` without its line end, and where the next one begins.
struct Line {
  std::string_view text;
  std::size_t next;
};
Line line_at(std::string_view text, std::size_t offset, char line_end);

}  // namespace beespace::io
