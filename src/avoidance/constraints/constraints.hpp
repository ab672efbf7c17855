// What the others make one bee do in a step.
#pragma once

#include "avoidance/constraints/half_spaces.hpp"

#include <cstddef>
#include <vector>

namespace beespace::avoidance {

struct Constraints {
  // Of where it would stop after the step; its way to a stop lies in them.
  std::vector<HalfSpace> hard;
  // The same, farther in, as far as possible: an agent that is too close gets away.
  struct Farther {
    std::size_t of;  // hard
    double by;
  };
  std::vector<Farther> separation_requests;
  // Of its velocity, as far as that goes.
  std::vector<HalfSpace> intruder_requests;

  void clear() {
    hard.clear();
    separation_requests.clear();
    intruder_requests.clear();
  }
};

}  // namespace beespace::avoidance
