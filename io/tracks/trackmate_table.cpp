#include "io/tracks/trackmate_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/problems/unplaced.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_table.hpp"
#include "io/tracks/video_units.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// What is read of a spot, as TrackMate calls it and as it is called here.
struct SpotColumn {
  std::string_view name;
  std::string_view called;
};
constexpr std::array<SpotColumn, 5> kRead = {{{"TRACK_ID", "id"},
                                              {"POSITION_T", "time"},
                                              {"POSITION_X", "x"},
                                              {"POSITION_Y", "y"},
                                              {"POSITION_Z", "z"}}};
constexpr std::size_t kTime = 1;
constexpr std::size_t kX = 2;

struct SpotLayout {
  char delimiter = ',';
  std::size_t columns = 0;
  std::array<std::size_t, kRead.size()> read = {};
  std::array<std::string, kRead.size()> units = {};  // as the row of units has them, or nothing
  bool in_frames = false;                            // the time
  std::size_t offset = 0;                            // where the spots begin
  std::uint64_t lines_before = 0;
};

bool is_spot_number(std::string_view text) {
  double number = 0.0;
  return parse_number(text, number) == NumberKind::kNumber;
}

// "micron" of "(micron)".
std::string in_brackets(std::string text) {
  if (text.size() < 2 || text.front() != '(' || text.back() != ')') return {};
  return text.substr(1, text.size() - 2);
}

// All of the columns that are read, and the label ("Label" in Fiji's table of results), which no
// other tool has beside them.
bool find_columns(const std::vector<std::string>& names, SpotLayout& spots) {
  if (std::none_of(names.begin(), names.end(),
                   [](const std::string& name) { return lower_case(name) == "label"; })) {
    return false;
  }
  for (std::size_t i = 0; i < kRead.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), kRead[i].name);
    if (found == names.end()) return false;
    spots.read[i] = static_cast<std::size_t>(found - names.begin());
  }
  spots.columns = names.size();
  return true;
}

std::optional<SpotLayout> spot_layout(std::string_view text) {
  constexpr int kMostRowsOfNames = 3;
  SpotLayout spots;
  const Line first = line_at(text, 0, '\n');
  bool found = false;
  for (const char delimiter : {',', '\t', ';'}) {
    spots.delimiter = delimiter;
    found = found || find_columns(cells_of_line(first.text, delimiter), spots);
    if (found) break;
  }
  if (!found) return std::nullopt;
  spots.offset = first.next;
  spots.lines_before = 1;
  for (int i = 0; i < kMostRowsOfNames && spots.offset < text.size(); ++i) {
    const Line line = line_at(text, spots.offset, '\n');
    const auto fields = cells_of_line(line.text, spots.delimiter);
    if (fields.size() != spots.columns || is_spot_number(fields[spots.read[kX]])) break;
    for (std::size_t k = 0; k < kRead.size(); ++k) {
      if (auto unit = in_brackets(fields[spots.read[k]]); !unit.empty()) {
        spots.units[k] = std::move(unit);
      }
    }
    spots.offset = line.next;
    ++spots.lines_before;
  }
  return spots;
}

// How long the unit of times is in which films of hours are, which tables of others are asked to
// convert.
std::optional<double> seconds_of_unit(std::string_view unit) {
  if (is_one_of("min mins minute minutes", lower_case(unit))) return 60.0;
  if (is_one_of("h hr hour hours", lower_case(unit))) return 3'600.0;
  return std::nullopt;
}

// As it is where it is no number.
std::string times_so_many(const std::string& text, double seconds) {
  double number = 0.0;
  return parse_number(text, number) == NumberKind::kNumber ? exact(number * seconds) : text;
}

// The same with what is read alone.
std::string records_of(std::string_view text, const SpotLayout& spots, double time_unit_s) {
  std::string out;
  std::uint64_t lines = 0;
  RecordWalk walk(text, spots.offset, '\n');
  while (walk.next()) {
    out.append(walk.line() - lines, '\n');
    lines = walk.line() + 1;
    const auto fields = cells_of_line(walk.record(), spots.delimiter);
    if (fields.size() != spots.columns) {
      out.append("a row of ").append(std::to_string(fields.size())).append(" values\n");
      continue;
    }
    for (std::size_t i = 0; i < kRead.size(); ++i) {
      const std::string& field = fields[spots.read[i]];
      const bool in_seconds = i != kTime || time_unit_s == 1.0;
      out.append(in_seconds ? field : times_so_many(field, time_unit_s)) += kUnitSeparator;
    }
    out.back() = '\n';
  }
  return out;
}

TableLayout spot_table(const SpotLayout& spots) {
  TableLayout table;
  table.delimiter = kUnitSeparator;
  for (std::size_t i = 0; i < kRead.size(); ++i) {
    const bool frames = i == kTime && spots.in_frames;
    table.names.emplace_back(frames ? "frame" : kRead[i].called);
    if (!frames && !spots.units[i].empty()) table.names.back().append(" [" + spots.units[i] + "]");
  }
  table.columns = table.names.size();
  table.contents.assign(table.columns, ColumnContent::kNumber);
  table.lines_before = spots.lines_before;
  return table;
}

// Where a video is not calibrated, or a table has no row of units, all that is to be said at once.
std::optional<Error> units_unsaid(const SpotLayout& spots, const RecordingOptions& options) {
  const std::string& length = spots.units[kX];
  const bool pixels = length.starts_with("pixel");
  const bool frames = spots.units[kTime].starts_with("frame");
  const bool places_unsaid =
      !options.pixel && (pixels || (length.empty() && options.units.position == Unit::kUnstated));
  const bool times_unsaid =
      !options.frames_per_second &&
      (frames || (spots.units[kTime].empty() && options.time_unit == Unit::kUnstated));
  if (!places_unsaid && !times_unsaid) return std::nullopt;
  std::string text = "spots of TrackMate, ";
  if (places_unsaid) {
    text += pixels ? "in pixels: say how long one is, as in --scale 0.1mm (--scale 1 takes it for "
                     "a metre)"
                   : "and no row says the unit of places: say it, as in --units position=um, or "
                     "how long a pixel is, as in --scale 0.1mm";
  }
  if (times_unsaid) {
    text += places_unsaid ? "; and " : "";
    text += frames ? "times are numbers of frames: say how many there are in a second, as in "
                     "--fps 25"
                   : "no row says the unit of times: say how many frames there are in a second, as "
                     "in --fps 25, or the unit, as in --time-unit s";
  }
  return Error{ErrorCode::kInvalidArgument, std::move(text), {}};
}

// Who says how many frames there are in a second has them counted.
void take_frames(std::string_view text, SpotLayout& spots) {
  const auto names = cells_of_line(line_at(text, 0, '\n').text, spots.delimiter);
  const auto frame = std::find(names.begin(), names.end(), "FRAME");
  if (frame == names.end() && !spots.units[kTime].starts_with("frame")) return;
  spots.in_frames = true;
  if (frame != names.end()) spots.read[kTime] = static_cast<std::size_t>(frame - names.begin());
}

}  // namespace

bool is_trackmate_table(std::string_view text) {
  return spot_layout(text).has_value();
}

std::optional<Error> read_trackmate_table(std::string_view text, RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  auto spots = spot_layout(text);
  if (!spots) return Error{ErrorCode::kUnsupportedFormat, "this is no table of spots", {}};
  const RecordingOptions& options = assembly.options();
  if (auto error = units_unsaid(*spots, options)) return error;
  if (options.frames_per_second) take_frames(text, *spots);
  double time_unit_s = 1.0;
  if (const auto seconds = seconds_of_unit(spots->units[kTime]); seconds && !spots->in_frames) {
    assembly.note("times of the table are in " + spots->units[kTime] +
                  ", and are turned into seconds");
    time_unit_s = *seconds;
    spots->units[kTime] = "sec";
  }
  const std::string records = records_of(text, *spots, time_unit_s);
  if (records.empty()) {
    return Error{ErrorCode::kNoPoints, "there are rows that name columns and none after them", {}};
  }
  if (options.progress != nullptr) options.progress->total += records.size();
  auto layout = choose_track_layout(spot_table(*spots), records, options, SeenRecords::kWhole);
  if (!layout) {
    Error error = std::move(layout).error();
    error.location.column.reset();
    return error;
  }
  layout->without_id = &kNoTrack;
  if (auto error = lengths_problem(layout->table, options)) return error;
  assembly.note("a table of spots, as TrackMate writes them: each track is a bee");
  SourceFacts facts = facts_of(*layout, "text, spots");
  facts.y_is_down = true;  // of an image, in whichever unit
  if (auto error = assembly.agree(facts)) return error;
  for (std::string& note : layout->notes) assembly.note(std::move(note));
  RecordsBefore none;
  return read_track_records(records, *layout, {}, RecordPlace::kLineAndName, none, assembly);
}

}  // namespace beespace::io
