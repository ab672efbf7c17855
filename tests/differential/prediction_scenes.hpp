// Movers that are constructed to provoke wrong answers.
#pragma once

#include "tests/differential/mover_oracle.hpp"
#include "tests/differential/random.hpp"

#include <string>
#include <vector>

namespace beespace::differential {

struct PredictionScene {
  std::string name;
  std::vector<Flight> flights;
  bool apart = false;  // heights are kept apart
  PredictOptions options;
};

PredictionScene random_prediction(Random& random);

}  // namespace beespace::differential
