#include "analysis/scene/noun.hpp"

namespace beespace::analysis {

report::Noun noun_of(const io::Recording& recording) {
  if (recording.show || recording.of_drones) return {"drone", "drones"};
  if (recording.of_aircraft) return {"aircraft", "aircraft"};
  if (recording.of_animals) return {"animal", "animals"};
  return {};
}

}  // namespace beespace::analysis
