#include "io/recording/recorded_noun.hpp"

#include "io/bytes/number_text.hpp"

namespace beespace::io {

std::string RecordedNoun::counted(std::uint64_t count) const {
  return io::counted(count, one.c_str(), several.c_str());
}

RecordedNoun noun_of(const Recording& recording) {
  if (recording.show || recording.of_drones || recording.called_drones) return {"drone", "drones"};
  if (recording.of_aircraft) return {"aircraft", "aircraft"};
  if (recording.of_animals) return {"animal", "animals"};
  return {};
}

}  // namespace beespace::io
