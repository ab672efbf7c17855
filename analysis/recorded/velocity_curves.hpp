// Whether bees may have come too close along the curves that have their given velocities at every
// fix, where straight lines from fix to fix keep apart: fixes that are far apart in time leave open
// which of both was flown.
//
// Velocities are measured, too. What follows from them alone is possible, not certain, and counts
// only where two come closer than kCloserThan of the threshold, and kCloserInHeight of a vertical
// one: rates of climb come late, and change more than heights do.
#pragma once

#include "analysis/geometry/geometry.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <vector>

namespace beespace::analysis {

inline constexpr double kCloserThan = 0.99;
inline constexpr double kCloserInHeight = 0.9;

struct VelocityCurves {
  bool given = false;       // some two fixes, one after the other, have velocities
  bool followed = true;     // false: they lead too far away from straight lines
  double most_off_m = 0.0;  // no curve is farther from its straight line; horizontally where there
                            // is a vertical threshold
  PointId bee = 0;          // whose that curve is,
  TimeSpan span = {};       // and when
  // Possible ones, in ascending order of (first, second, begins_s): none of a pair that is in
  // conflict along straight lines at some instant of it.
  std::vector<Conflict> conflicts = {};
  // With a vertical threshold the curves, in straight lines within a hundredth of the thresholds.
  std::vector<Track> tracks = {};

  // Whether what was found along straight lines is all that there is to say.
  [[nodiscard]] bool agree() const { return followed && conflicts.empty(); }
};

// Nothing of shows, whose curves are their own. Without a vertical threshold distances are decided
// along the curves themselves, as verify_paths() does. `along_lines` are the conflicts along
// straight lines, in ascending order of (first, second). Errors: those of the conversion and of
// find_conflicts(), with the bee's id.
Result<VelocityCurves> follow_velocities(const io::Recording& recording, Geometry geometry,
                                         const ConflictOptions& options,
                                         const std::vector<Conflict>& along_lines);

}  // namespace beespace::analysis
