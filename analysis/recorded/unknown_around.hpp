// What is not known of two that come too close: whether one of them is lost just before or after,
// so that the conflict may be longer than it is told, or one with the next; and for how long it is
// not known how far apart they were.
#pragma once

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>

#include <vector>

namespace beespace::analysis {

// Whether one of the two is not known just before a conflict begins, and just after it ends.
struct UnknownAround {
  bool before = false;
  bool after = false;
};

// `unknown` are those of all_unknown_spans().
UnknownAround unknown_around(const Conflict& conflict, const std::vector<Gap>& unknown);

// For how long one of the two is not known, or both are not.
double unknown_of_pair_s(PointId first, PointId second, const std::vector<Gap>& unknown);

}  // namespace beespace::analysis
