#include "io/tracks/unclear_id.hpp"

#include "io/bytes/number.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/flat_distance.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/header_words.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_record.hpp"

#include <beespace/track.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

struct LabelledFix {
  Fix fix;
  std::size_t bee;    // by the id that is taken
  std::size_t value;  // of the column, as they came
};

struct LabelledFixes {
  std::vector<LabelledFix> fixes;   // in the order of time
  std::vector<std::string> values;  // each once
  std::size_t bees = 0;
  bool within_bees = true;  // no value is of two bees
};

// The first records, as if that column were what they are called.
LabelledFixes sample_of(std::string_view text, const TrackLayout& layout, std::size_t column) {
  constexpr std::size_t kMostLookedAt = 20'000;
  TrackLayout labelled = layout;
  labelled.label = column;
  TrackRecordReader reader(labelled);
  TrackRecord record;
  LabelledFixes sample;
  std::unordered_map<std::string, std::size_t> bees;
  std::unordered_map<std::string, std::size_t> known;
  std::vector<std::size_t> bee_of;  // by value
  RecordWalk walk(text, layout.table.data_offset, layout.table);
  while (walk.next() && sample.fixes.size() < kMostLookedAt) {
    if (reader.read(walk.record(), record) || record.left_out != nullptr) continue;
    const std::size_t bee =
        bees.try_emplace(std::string(record.id) + '\0' + std::string(record.set), bees.size())
            .first->second;
    const auto [value, added] = known.try_emplace(std::string(record.label), known.size());
    if (added) sample.values.push_back(value->first);
    if (added) bee_of.push_back(bee);
    sample.within_bees = sample.within_bees && bee_of[value->second] == bee;
    sample.fixes.push_back({{record.time_s, record.position}, bee, value->second});
  }
  sample.bees = bees.size();
  std::stable_sort(
      sample.fixes.begin(), sample.fixes.end(),
      [](const LabelledFix& a, const LabelledFix& b) { return a.fix.time_s < b.fix.time_s; });
  return sample;
}

// Negative, or with a fraction: what is measured, and no id.
bool is_measured(const std::string& text) {
  double value = 0.0;
  return parse_number(without_padding(text), value) == NumberKind::kNumber &&
         (value < 0.0 || value != std::floor(value));
}

// Whether those of each value together go a small part of the way of all as the bees that are
// taken: that is so many times as long.
bool explains(const LabelledFixes& sample, Frame frame, double times) {
  constexpr std::size_t kFewest = 4;  // fixes of a value, on average
  if (sample.values.size() <= sample.bees || kFewest * sample.values.size() > sample.fixes.size()) {
    return false;
  }
  std::vector<const Fix*> last(sample.values.size(), nullptr);
  std::vector<const Fix*> last_of_bee(sample.bees, nullptr);
  double as_taken_m = 0.0;
  double as_several_m = 0.0;
  for (const LabelledFix& at : sample.fixes) {
    const auto way_m = [&](const Fix* from) {
      return from == nullptr ? 0.0 : flat_distance_m(from->position, at.fix.position, frame);
    };
    as_taken_m += way_m(std::exchange(last_of_bee[at.bee], &at.fix));
    as_several_m += way_m(std::exchange(last[at.value], &at.fix));
  }
  return as_taken_m > times * as_several_m;
}

// Whether some bee is of one value, of another one, and of the first again.
bool come_in_turn(const LabelledFixes& sample) {
  std::vector<std::optional<std::size_t>> last_of_bee(sample.bees);
  std::vector<bool> left(sample.values.size(), false);  // another one has come since
  for (const LabelledFix& at : sample.fixes) {
    auto& last = last_of_bee[at.bee];
    if (last == at.value) continue;
    if (left[at.value]) return true;
    if (last) left[*last] = true;
    last = at.value;
  }
  return false;
}

Error which_id(const TrackLayout& layout, std::size_t column, const LabelledFixes& sample) {
  const ColumnChoice& choice = layout.table.choice;
  const bool geographic = layout.frame == Frame::kWgs84;
  const auto number = [](std::size_t of) { return std::to_string(of + 1); };
  std::string others = "time=" + number(layout.time->column);
  others.append(geographic ? ",lon=" : ",x=").append(number(choice.axes[0]));
  others.append(geographic ? ",lat=" : ",y=").append(number(choice.axes[1]));
  if (choice.dimensions == 3) {
    others.append(geographic ? ",height=" : ",z=").append(number(choice.axes[2]));
  }
  return {ErrorCode::kMissingColumn,
          "no column is known to hold the id, but " + column_text(layout.table, column) + " (" +
              excerpt(sample.values[0]) + ", " + excerpt(sample.values[1]) +
              (sample.values.size() > 2 ? ", ..." : "") +
              ") may: taken for one bee, the records go to and fro between its values; say "
              "--columns id=" +
              number(column) + ", or, if all are of one bee, --columns " + others,
          {}};
}

Error which_of_two(const TableLayout& table, std::size_t column, const LabelledFixes& sample) {
  const std::size_t id = *table.choice.id;
  return {ErrorCode::kMissingColumn,
          "which column is the id? By " + column_text(table, id) + " there " +
              (sample.bees == 1 ? "is one bee" : "are " + std::to_string(sample.bees) + " bees") +
              ", which go" + (sample.bees == 1 ? "es" : "") + " to and fro between what " +
              column_text(table, column) + " tells apart (" + excerpt(sample.values[0]) + ", " +
              excerpt(sample.values[1]) + (sample.values.size() > 2 ? ", ..." : "") +
              "); say --columns id=" + std::to_string(column + 1) +
              ", or, if the first is right, --columns id=" + std::to_string(id + 1),
          {}};
}

// One bee by the id that is taken, and several by another column that may be the id.
std::optional<Error> contradicted_id(std::string_view text, const Header& header,
                                     const TrackLayout& layout) {
  constexpr double kFarther = 1.5;
  for (const std::size_t other : header.columns(Role::kId)) {
    if (other == layout.table.choice.id || names_flight(layout.table.names[other])) continue;
    if (!may_hold_ids(header, layout, other)) continue;
    const LabelledFixes sample = sample_of(text, layout, other);
    if (sample.within_bees && come_in_turn(sample) && explains(sample, layout.frame, kFarther)) {
      return which_of_two(layout.table, other, sample);
    }
  }
  return std::nullopt;
}

}  // namespace

bool may_hold_ids(const Header& header, const TrackLayout& layout, std::size_t column) {
  const Role role = header.meaning(column).role;
  const bool unclear =
      role == Role::kNone || role == Role::kId || (role == Role::kTrack && !layout.velocity);
  const bool taken =
      column == layout.table.choice.id || column == layout.axes_name || column == layout.visible ||
      column == layout.zone || column == layout.clock_zone ||
      (layout.quality && column == layout.quality->column) ||
      std::find(layout.sets.begin(), layout.sets.end(), column) != layout.sets.end() ||
      names_scene(layout.table.names[column]);
  return unclear && !taken && !names_other_quantity(layout.table.names[column]);
}

std::optional<Error> unclear_id(std::string_view text, const Header& header,
                                const TrackLayout& layout) {
  constexpr double kMuchFarther = 4.0;
  const TableLayout& table = layout.table;
  if (!layout.time || header.source() != nullptr) return std::nullopt;
  if (header.override_of(Role::kId)) return std::nullopt;
  if (table.choice.id) return contradicted_id(text, header, layout);
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (!may_hold_ids(header, layout, i)) continue;
    const LabelledFixes sample = sample_of(text, layout, i);
    if (std::any_of(sample.values.begin(), sample.values.end(), is_measured)) continue;
    if (explains(sample, layout.frame, kMuchFarther)) return which_id(layout, i, sample);
  }
  return std::nullopt;
}

}  // namespace beespace::io
