#include "io/tracks/track_sets.hpp"

#include "io/table/column_overrides.hpp"
#include "io/table/table_sources.hpp"

namespace beespace::io {

void settle_sets(const Header& header, TrackLayout& layout) {
  const auto& id = layout.table.choice.id;
  if (!layout.time) return;
  // Numbers that begin again every day, or with every video of a day.
  const bool of_day = layout.time->form == TimeForm::kDatesAndTimes ||
                      layout.time->form == TimeForm::kClock || layout.time->since_1970;
  const bool dated = of_day && (!layout.time->clock || layout.time->clock->dated);
  for (std::size_t i = 0; i < header.size() && layout.sets.size() < TrackSlot::kMostSets; ++i) {
    if (i == id || i == layout.time->column) continue;
    const std::string& name = header.table().names[i];
    const bool day = !of_day && header.meaning(i).role == Role::kDate;
    if (!names_set(name) && !day && (dated || !names_session(name))) continue;
    if (!dated && !names_arena(name)) layout.trials.push_back(layout.sets.size());
    layout.sets.push_back(i);
  }
}

std::string columns_of_trials(const TrackLayout& layout) {
  std::string text;
  for (const std::size_t set : layout.trials) {
    text += (text.empty() ? "" : " with ") + column_text(layout.table, layout.sets[set]);
  }
  return text;
}

std::string filter_of_trials(const TrackLayout& layout) {
  if (layout.trials.size() != 1) return {};
  const char delimiter = layout.table.delimiter;
  std::string text = "awk ";
  if (delimiter == '\t') {
    text += "-F'\\t' ";
  } else if (delimiter != ' ') {
    text.append("-F'").append(1, delimiter).append("' ");
  }
  return text + "'NR <= " + std::to_string(layout.table.lines_before) + " || $" +
         std::to_string(layout.sets[layout.trials.front()] + 1) + " == \"";
}

}  // namespace beespace::io
