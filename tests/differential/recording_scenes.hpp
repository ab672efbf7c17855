// Recordings that are constructed to provoke wrong answers.
#pragma once

#include "tests/differential/random.hpp"

#include <beespace/find_conflicts.hpp>

#include <string>
#include <vector>

namespace beespace::differential {

struct RecordingScene {
  std::string name;
  std::vector<Track> tracks;
  ConflictOptions options;
};

RecordingScene random_recording(Random& random);

std::string text_of(const RecordingScene& scene);

}  // namespace beespace::differential
