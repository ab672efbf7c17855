// What was found in a recording, put together: whole tracks, their conflicts, and what follows
// from these for pairs, bees and moments.
#pragma once

#include "analysis/recorded/chords.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/kept_by_height.hpp"
#include "analysis/recorded/low_conflicts.hpp"
#include "analysis/recorded/turn_arcs.hpp"
#include "analysis/recorded/velocity_curves.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "io/recording/recording.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::analysis {

struct Findings {
  const io::Recording& recording;
  const std::vector<Track>& tracks;
  const std::vector<Track>& in_space;  // the same; differs where heights are apart from positions
  const RecordedConflicts& recorded;
  const std::optional<Conflict>& closest;  // of all encounters, conflict or not
  const Coverage& coverage;
  bool has_encounters;  // two bees are there at the same time
  // Of each bee, in conflict or not; empty where that was not looked for.
  std::vector<std::optional<Conflict>> closest_of_each = {};

  std::vector<Conflict> with_standing = {};  // as AllConflicts has them
  // Where `closest` is with a drone on the ground: of two in the air, conflict or not.
  std::optional<Conflict> closest_in_the_air = {};

  // Conflicts that are left out, as is asked for.
  LowConflicts low = {};

  // Of given velocities; `recorded` has the conflicts along them too. Null where these were not
  // looked at.
  const VelocityCurves* curves = nullptr;
  bool velocities_passed_over = false;  // there are some, and they would have to be looked at

  Chords chords = {};
  // `recorded` has the conflicts along these too; null where they were not looked at.
  const TurnArcs* arcs = nullptr;
  // Of pairs without a conflict: closer than the minimum that holds above FL410.
  std::vector<Conflict> above_fl410 = {};
  // Nothing where it was not looked at.
  std::optional<KeptByHeight> kept_by_height = {};

  // Whether animals, or two that drive or swim, are kept apart by heights, which say little of
  // them.
  [[nodiscard]] bool heights_open() const { return kept_by_height && kept_by_height->unsure > 0; }
  // Whether velocities may hide a conflict that straight lines do not show.
  [[nodiscard]] bool velocities_open() const {
    return velocities_passed_over || (curves != nullptr && !curves->followed);
  }
  // Whether this is no all-clear: there is a conflict, one may be hidden, or nothing was compared.
  [[nodiscard]] bool is_risky() const {
    return !recorded.conflicts.empty() || coverage.may_hide_conflicts() || !has_encounters ||
           velocities_open() || heights_open() || !above_fl410.empty();
  }
};

// When the first bee appears and the last one vanishes; nothing where there is none.
std::optional<TimeSpan> time_of(const std::vector<Track>& tracks);

// Both, in ascending order of (first, second, begins_s).
std::vector<Conflict> merged(std::vector<Conflict> some, const std::vector<Conflict>& more);

// Those of the conflicts that are not among `others`; both are in ascending order of (first,
// second, begins_s).
std::vector<Conflict> without(const std::vector<Conflict>& conflicts,
                              const std::vector<Conflict>& others);

// The pairs in conflict, the worst first (rank_of): each with all its conflicts together.
struct PairInConflict {
  Conflict closest;  // in a straight line
  Conflict worst;    // the same without `worst`
  std::size_t conflicts = 0;
  double time_s = 0.0;
};
std::vector<PairInConflict> pairs_in_conflict(const std::vector<Conflict>& conflicts,
                                              const WorstOf& worst = {});

// What a bee was in: its conflicts, how long it was in conflict (with however many at a time), and
// the one in which it came closest to another bee.
struct BeeInConflict {
  std::size_t conflicts = 0;
  double time_s = 0.0;
  const Conflict* closest = nullptr;  // one of those given; none: it is in no conflict
};
// One for each of `bees`, in their order. `conflicts` must outlive the answer.
std::vector<BeeInConflict> bees_in_conflict(std::size_t bees,
                                            const std::vector<Conflict>& conflicts);

// How far apart the closest two are of those that are known, at one moment after the other.
struct Moment {
  double time_s;
  double distance_m;  // infinite where there are fewer than two
  PointId first;
  PointId second;
  std::uint64_t unknown;  // bees
  // One of these would be closer to another, on a straight line across its gap, or where it jumps:
  // how far apart the
  // closest two were is not known.
  bool open = false;
};
std::vector<Moment> separation_over_time(const Findings& findings, double every_s);
// The same at those times.
std::vector<Moment> separation_at(const Findings& findings, const std::vector<double>& times_s);

}  // namespace beespace::analysis
