// The constraints on one bee in a step.
#pragma once

#include "avoidance/constraints/half_spaces.hpp"

#include <cstddef>
#include <vector>

namespace beespace::avoidance {

struct Constraints {
  // Hard constraints on its stop after the step; its stopping segment satisfies them.
  std::vector<HalfSpace> hard;
  // The same, farther in, as far as possible: an agent that is too close gets away.
  struct Farther {
    std::size_t of;  // hard
    double by;
  };
  std::vector<Farther> separation_requests;
  // Requests about its velocity, met as far as possible.
  std::vector<HalfSpace> intruder_requests;

  void clear() {
    hard.clear();
    separation_requests.clear();
    intruder_requests.clear();
  }
};

}  // namespace beespace::avoidance
