// What the others make one bee do in a step.
#pragma once

#include "avoidance/constraints/half_spaces.hpp"

#include <cstddef>
#include <vector>

namespace beespace::avoidance {

struct Claims {
  // Of where it would stop after the step; its way to a stop lies in them.
  std::vector<HalfSpace> keep_to;
  // The same, farther in, as far as that goes: who is too close gets away.
  struct Farther {
    std::size_t of;  // keep_to
    double by;
  };
  std::vector<Farther> get_away;
  // Of its velocity, as far as that goes.
  std::vector<HalfSpace> give_way;

  void clear() {
    keep_to.clear();
    get_away.clear();
    give_way.clear();
  }
};

}  // namespace beespace::avoidance
