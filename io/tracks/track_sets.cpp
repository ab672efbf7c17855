#include "io/tracks/track_sets.hpp"

#include "io/table/table_sources.hpp"

namespace beespace::io {

void settle_sets(const Header& header, TrackLayout& layout) {
  const auto& id = layout.table.choice.id;
  if (!layout.time) return;
  // Numbers that begin again every day, or with every video of a day.
  const bool dated = layout.time->form == TimeForm::kDatesAndTimes ||
                     layout.time->form == TimeForm::kClock || layout.time->since_1970;
  for (std::size_t i = 0; i < header.size() && layout.sets.size() < TrackSlot::kMostSets; ++i) {
    if (i != id && i != layout.time->column &&
        (names_set(header.table().names[i]) || (!dated && header.meaning(i).role == Role::kDate))) {
      layout.sets.push_back(i);
    }
  }
}

}  // namespace beespace::io
