#include "analysis/text/bee_name.hpp"

#include <algorithm>

namespace beespace::analysis {

std::string text_of(const BeeName& name) {
  return name.label.empty() ? name.id : name.id + " (" + name.label + ")";
}

BeeName name_of(PointId bee, const io::Recording& recording) {
  return {recording.bees[bee].id, recording.bees[bee].label};
}

bool has_labels(const io::Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return !bee.label.empty(); });
}

}  // namespace beespace::analysis
