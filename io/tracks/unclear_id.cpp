#include "io/tracks/unclear_id.hpp"

#include "io/problems/excerpt.hpp"
#include "io/recording/flat_distance.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/record_walk.hpp"
#include "io/table/table_sources.hpp"
#include "io/tracks/track_record.hpp"

#include <beespace/track.hpp>

#include <algorithm>
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
  std::size_t value;  // of the column, as they came
};

struct LabelledFixes {
  std::vector<LabelledFix> fixes;   // in the order of time
  std::vector<std::string> values;  // each once
};

// The first records, as if that column were what they are called.
LabelledFixes sample_of(std::string_view text, const TrackLayout& layout, std::size_t column) {
  constexpr std::size_t kMostLookedAt = 20'000;
  TrackLayout labelled = layout;
  labelled.label = column;
  TrackRecordReader reader(labelled);
  TrackRecord record;
  LabelledFixes sample;
  std::unordered_map<std::string, std::size_t> known;
  RecordWalk walk(text, layout.table.data_offset, layout.table);
  while (walk.next() && sample.fixes.size() < kMostLookedAt) {
    if (reader.read(walk.record(), record) || record.left_out != nullptr) continue;
    const auto [value, added] = known.try_emplace(std::string(record.label), known.size());
    if (added) sample.values.push_back(value->first);
    sample.fixes.push_back({{record.time_s, record.position}, value->second});
  }
  std::stable_sort(
      sample.fixes.begin(), sample.fixes.end(),
      [](const LabelledFix& a, const LabelledFix& b) { return a.fix.time_s < b.fix.time_s; });
  return sample;
}

// Whether those of each value together go a small part of the way of all as one.
bool explains(const LabelledFixes& sample, Frame frame) {
  constexpr std::size_t kFewest = 4;  // fixes of a value, on average
  constexpr double kPart = 4.0;
  if (sample.values.size() < 2 || kFewest * sample.values.size() > sample.fixes.size()) {
    return false;
  }
  std::vector<const Fix*> last(sample.values.size(), nullptr);
  const Fix* last_of_all = nullptr;
  double as_one_m = 0.0;
  double as_several_m = 0.0;
  for (const LabelledFix& at : sample.fixes) {
    const auto way_m = [&](const Fix* from) {
      return from == nullptr ? 0.0 : flat_distance_m(from->position, at.fix.position, frame);
    };
    as_one_m += way_m(std::exchange(last_of_all, &at.fix));
    as_several_m += way_m(std::exchange(last[at.value], &at.fix));
  }
  return as_one_m > kPart * as_several_m;
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

}  // namespace

std::optional<Error> unclear_id(std::string_view text, const Header& header,
                                const TrackLayout& layout) {
  const TableLayout& table = layout.table;
  if (table.choice.id || !layout.time || header.source() != nullptr) return std::nullopt;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const Role role = header.meaning(i).role;
    const bool unclear = role == Role::kNone || (role == Role::kTrack && !layout.velocity);
    const bool taken = i == layout.axes_name || i == layout.visible || i == layout.zone ||
                       (layout.quality && i == layout.quality->column) ||
                       std::find(layout.sets.begin(), layout.sets.end(), i) != layout.sets.end();
    if (!unclear || taken || names_other_quantity(table.names[i])) continue;
    const LabelledFixes sample = sample_of(text, layout, i);
    if (explains(sample, layout.frame)) return which_id(layout, i, sample);
  }
  return std::nullopt;
}

}  // namespace beespace::io
