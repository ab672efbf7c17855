// Who came too close to whom, and when? For recordings: whole tracks, with their own, unaligned and
// irregular times.
//
// Between two fixes a bee moves in a straight line at constant velocity, exactly (see track.hpp),
// so a pass between two fixes is found as well. Whether two are in conflict at some instant is
// decided as real numbers on the given doubles.
#pragma once

#include <beespace/conflict.hpp>
#include <beespace/export.hpp>
#include <beespace/not_given.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace beespace {

struct ConflictOptions {
  // Metres. Two bees conflict when their distance is below it; with `vertical_m`, their horizontal
  // distance. Must be given.
  double threshold_m = kNotGiven;

  // Metres. Given, two bees conflict when they are closer than the threshold horizontally (in x and
  // y) and closer than this in height (z), both at the same time.
  std::optional<double> vertical_m = {};

  // Whether exactly the threshold counts as too close.
  bool inclusive = false;

  // Seconds. Where two fixes of a bee are farther apart in time, nobody knows where it was in
  // between: it counts as absent, and the answer says so.
  double max_gap_s = std::numeric_limits<double>::infinity();

  // How many threads may work, the calling one included; 0 means one per processor. The answer is
  // the same for every number.
  unsigned threads = 1;

  // More conflicts than this are an error, kTooManyResults.
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();

  // How many metres one unit of heights is that are kept apart from positions, where these are not
  // metres: 0.3048 for feet. Then `vertical_m` and climb rates are in that unit too, and compared
  // with the heights as they are, exactly; distances that are told are in metres all the same.
  double height_unit_m = 1.0;
};

// Between which of its fixes a bee counts as absent.
struct Gap {
  PointId track = 0;
  double begins_s = 0.0;
  double ends_s = 0.0;

  friend constexpr bool operator==(const Gap&, const Gap&) = default;
};

struct RecordedConflicts {
  // In ascending order of (first, second, begins_s). A pair may be in conflict several times: the
  // stretches of time do not overlap; two may share the instant at which the pair is exactly the
  // threshold apart. Where tracks have a tolerance, a stretch is as long as the two may have been
  // too close.
  std::vector<Conflict> conflicts;
  std::vector<Gap> gaps;  // in ascending order of (track, begins_s)
};

// All conflicts between two of the tracks, over the whole time.
//
// Errors: kInvalidThreshold; kInvalidArgument for a max_gap_s that is not above zero, or a negative
// or infinite tolerance; kNotFinite, kOutsideDomain (the motion domain, see mover.hpp) and
// kTimeOrder, with the track in place.record and the fix in the message; kTooManyPoints for more
// tracks than ids, kTooManyResults. A track without fixes is a bee that never appears.
BEESPACE_API Result<RecordedConflicts> find_conflicts(std::span<const Track> tracks,
                                                      const ConflictOptions& options);

// Of all the time in which two of the tracks are there: when which two are closest in a straight
// line, and how close. Nothing where no two are there at the same time. The times of the span are
// all the closest instant. Cost: a few searches as above, with thresholds that grow until somebody
// is found. Errors: as find_conflicts.
BEESPACE_API Result<std::optional<Conflict>> find_closest_encounter(
    std::span<const Track> tracks, double max_gap_s = std::numeric_limits<double>::infinity(),
    unsigned threads = 1);

}  // namespace beespace
