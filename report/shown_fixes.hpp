// The fixes of a recording that a page shows: all, or of very long ones every second, third, ...
#pragma once

#include <beespace/find_conflicts.hpp>
#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace beespace::report {

struct ShownFixes {
  std::size_t every = 1;              // of so many fixes one is shown
  std::vector<std::uint32_t> counts;  // of each bee
  std::vector<double> times_s;        // of the first bee, then of the second, ...
  std::vector<Point> positions;
  std::vector<std::uint32_t> absent_after;  // fixes after which the bee is nowhere until the next
  double shortest_s = std::numeric_limits<double>::infinity();  // from one to the next of a bee
  double error_m = 0.0;  // how far from where it is shown a bee may be, between fixes too
};

// At most about `most` of them; of each bee the first and the last one, and those beside its gaps.
ShownFixes shown_fixes(std::span<const Track> tracks, std::span<const Gap> gaps, std::size_t most);

// The fixes from `begin` to before `end`, between which a bee is always somewhere.
struct ShownRun {
  std::size_t bee = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// In the order of the fixes; none is empty.
std::vector<ShownRun> runs_of(const ShownFixes& shown);

}  // namespace beespace::report
