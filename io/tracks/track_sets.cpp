#include "io/tracks/track_sets.hpp"

#include "io/table/column_overrides.hpp"
#include "io/table/header_words.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

// Whether places are those of a video, or so small that they may be of one of several cameras.
bool is_of_laboratory(const TrackLayout& layout, const RecordingOptions& options) {
  const auto& units = layout.table.choice.units;
  return options.pixel || layout.time->form == TimeForm::kFrames ||
         std::any_of(units.begin(), units.end(), [](Unit unit) {
           return unit == Unit::kMillimetre || unit == Unit::kCentimetre ||
                  unit == Unit::kMicrometre;
         });
}

// How the records of one value of that column are taken out of a text, up to the value.
std::string filter_of(const TableLayout& table, std::size_t column) {
  const char delimiter = table.delimiter;
  std::string text = "awk ";
  if (delimiter == '\t') {
    text += "-F'\\t' ";
  } else if (delimiter != ' ') {
    text.append("-F'").append(1, delimiter).append("' ");
  }
  text.append("'NR <= ").append(std::to_string(table.lines_before)).append(" || $");
  return text.append(std::to_string(column + 1)).append(" == \"");
}

}  // namespace

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

void settle_scenes(const Header& header, const RecordingOptions& options, TrackLayout& layout) {
  const auto& id = layout.table.choice.id;
  if (!layout.time || options.frame == Frame::kMetres) return;
  if (layout.frame == Frame::kWgs84 || !is_of_laboratory(layout, options)) return;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool is_free = i != id && header.meaning(i).role != Role::kTime;
    if (layout.scenes.size() == TrackSlot::kMostScenes) break;
    if (is_free && names_scene(header.table().names[i])) layout.scenes.push_back(i);
  }
}

std::string columns_of_trials(const TrackLayout& layout) {
  std::string text;
  for (const std::size_t set : layout.trials) {
    text += (text.empty() ? "" : " with ") + column_text(layout.table, layout.sets[set]);
  }
  return text;
}

std::string columns_of_scenes(const TrackLayout& layout) {
  std::string text;
  for (const std::size_t column : layout.scenes) {
    text += (text.empty() ? "" : " with ") + column_text(layout.table, column);
  }
  return text;
}

std::string filter_of_trials(const TrackLayout& layout) {
  return layout.trials.size() == 1 ? filter_of(layout.table, layout.sets[layout.trials.front()])
                                   : std::string();
}

std::string filter_of_scenes(const TrackLayout& layout) {
  return layout.scenes.size() == 1 ? filter_of(layout.table, layout.scenes.front()) : std::string();
}

}  // namespace beespace::io
