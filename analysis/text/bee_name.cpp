#include "analysis/text/bee_name.hpp"

#include <algorithm>

namespace beespace::analysis {

std::string text_of(const BeeName& name) {
  return name.label.empty() ? name.id : name.id + " (" + name.label + ")";
}

BeeName name_of(PointId bee, const io::Recording& recording) {
  return {recording.bees[bee].id, recording.bees[bee].label};
}

BeeName name_at(double time_s, PointId bee, const io::Recording& recording) {
  const io::RecordedBee& named = recording.bees[bee];
  if (named.called.empty()) return name_of(bee, recording);
  const std::string* label = &named.called.front().label;
  for (const auto& called : named.called) {
    if (called.since_s <= time_s) label = &called.label;
  }
  return {named.id, *label};
}

bool has_labels(const io::Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return !bee.label.empty(); });
}

}  // namespace beespace::analysis
