#include "io/tracks/clover_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/unit_doubts.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"

#include <cstdint>
#include <optional>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kCloverColumns = 8;

// What a record says that tells it from those of other tools.
struct CloverRecord {
  std::uint64_t frame = 0;
  bool has_colours = false;  // whole numbers up to 255
};

std::optional<CloverRecord> read_clover_record(std::string_view line) {
  constexpr std::uint64_t kBrightest = 255;
  CloverRecord record;
  FieldCursor cursor(line, ',');
  Field field;
  for (std::size_t column = 0; column < kCloverColumns; ++column) {
    if (!cursor.next(field)) return std::nullopt;
    const std::string_view text = without_padding(field.text);
    if (column >= 1 && column <= 4) {
      double number = 0.0;
      if (parse_number(text, number) != NumberKind::kNumber) return std::nullopt;
      continue;
    }
    const auto whole = parse_whole(text);
    if (!whole || (column > 4 && *whole > kBrightest)) return std::nullopt;
    if (column == 0) record.frame = *whole;
  }
  if (cursor.next(field)) return std::nullopt;
  return record;
}

// One cell that is no number.
bool is_name_of_drone(std::string_view line) {
  double number = 0.0;
  const std::string_view name = without_padding(line);
  return !name.empty() && name.find_first_of(",;\t") == std::string_view::npos &&
         parse_number(name, number) == NumberKind::kNotANumber;
}

}  // namespace

std::size_t find_clover_records(std::string_view text) {
  constexpr int kLookedAt = 100;
  std::size_t begins = kNoCloverTable;
  std::optional<std::uint64_t> before;
  int seen = 0;
  bool named = false;
  for (std::size_t offset = 0; offset < text.size() && seen < kLookedAt;) {
    const Line line = line_at(text, offset, '\n');
    const bool last = line.next >= text.size();
    if (!is_blank_line(line.text)) {
      const auto record = read_clover_record(line.text);
      if (!record && (named || seen > 0 || !is_name_of_drone(line.text))) {
        // The last line of a beginning may be cut off.
        return last && seen > 1 ? begins : kNoCloverTable;
      }
      if (!record) named = true;
      // Each frame is there: of what counts otherwise it is asked what it counts.
      if (record && before && record->frame != *before + 1) return kNoCloverTable;
      if (record && seen == 0) begins = offset;
      if (record) {
        before = record->frame;
        ++seen;
      }
    }
    offset = line.next;
  }
  return seen > 1 ? begins : kNoCloverTable;
}

Result<TrackLayout> clover_layout(TableLayout table, std::string_view text,
                                  const RecordingOptions& options, SeenRecords seen) {
  if (!options.frames_per_second) {
    return at_column(ErrorCode::kInvalidArgument,
                     "this is a path as clever-show plays it on COEX Clover: frame, x, y, z, yaw, "
                     "red, green, blue, but how many frames are there in a second? Say it, as in "
                     "--fps 10, which clever-show takes where its settings (frame_delay) say "
                     "nothing else",
                     0);
  }
  RecordingOptions columns = options;
  columns.columns = "frame=1,x=2,y=3,z=4";
  auto layout = choose_track_layout(std::move(table), text, columns, seen);
  if (!layout) return layout;
  const bool supposed = options.units.position == Unit::kUnstated && layout->frame != Frame::kWgs84;
  if (supposed) {
    layout->frame = Frame::kMetres;
    layout->frame_reason = "paths of clever-show are in metres";
    for (UnitTaken& taken : layout->units) {
      if (taken.evidence != UnitEvidence::kUsual) continue;
      taken.evidence = UnitEvidence::kNamed;
      taken.reason = "paths of clever-show are in metres";
    }
    layout->doubted_above_mps = kFastestShow_mps;
  }
  layout->show = true;
  layout->notes.emplace_back(
      "this is taken for a path as clever-show plays it on COEX Clover: frame, x, y, z [m], yaw, "
      "red, green, blue");
  return layout;
}

}  // namespace beespace::io
