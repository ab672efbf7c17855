// Whether a recording kept its distance and its limits along curves: of shows, and of flights whose
// bees have fixes at times of their own, in metres or in degrees.
#pragma once

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/limits_beside.hpp"
#include "analysis/recorded/low_conflicts.hpp"
#include "analysis/recorded/low_navigation.hpp"
#include "analysis/recorded/turn_arcs.hpp"
#include "analysis/recorded/velocity_curves.hpp"
#include "io/recording/recording.hpp"
#include "io/recording/show_facts.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/track.hpp>
#include <beespace/verify.hpp>
#include <beespace/verify_path.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace beespace::analysis {

struct PathBreach {
  PointId bee = 0;
  PathExcess excess;
  // Of a limit of the show in PathVerdict::accelerations: its place there.
  std::optional<std::size_t> beside = {};
};

struct PathClearanceLoss {
  PointId bee = 0;
  ClearanceLoss loss;
};

struct PathVerdict {
  std::vector<Conflict> losses;         // each pair as long as it may be closer than the threshold
  std::vector<Conflict> with_standing;  // of the losses: with a drone of a show on the ground
  std::vector<PathClearanceLoss> clearance_losses;
  std::vector<PathBreach> breaches;                       // by limit, then bee, then time
  std::array<std::optional<BeePeak>, kPathLimits> peaks;  // of all bees
  std::optional<Conflict> closest;  // of all; nothing where no two are there at the same time
  // The same of two in the air; it differs where `closest` is with a drone on the ground.
  std::optional<Conflict> closest_in_the_air;
  std::size_t standing_count = 0;  // left out: of two that both say that they have landed
  LowConflicts low;                // that are left out of the losses, as the question asks
  bool encounters = false;         // some two are there at the same time
  // Distances that were decided as `beespace replay` does: the lines and the curves along which.
  std::vector<Track> lines = {};
  VelocityCurves curves = {};
  TurnArcs arcs = {};
  std::vector<Gap> gaps;
  // Of the accelerations that a show declares: those that are looked at in their direction. Their
  // excesses are in `breaches`.
  std::vector<AccelerationCheck> accelerations;
  std::vector<NavigationCheck> navigation;  // below which heights drones move sideways
  // Limits that are not known to be kept or broken, and those of `navigation` that are not kept.
  std::vector<std::string> not_looked_at;
  std::vector<std::string> undecided;  // those of them that the question does not skip

  [[nodiscard]] bool found_nothing() const {
    return losses.empty() && clearance_losses.empty() && breaches.empty();
  }
  // Velocities that lead too far away from straight lines may hide a loss.
  [[nodiscard]] bool holds() const {
    return found_nothing() && undecided.empty() && curves.followed;
  }
};

// In degrees, with a vertical threshold, and where drones say that they have landed, distances are
// decided as `beespace replay` does: along straight lines, and as possible along the curves with
// the given velocities.
struct PathQuestion {
  // In metres all fixes then have one.
  bool with_velocities = false;
  double threshold_m = 0.0;
  std::optional<io::StatedLength> vertical = {};
  std::optional<double> ignore_below_m = {};  // see leave_out_low()
  double max_gap_s = 0.0;
  const ObstacleMap* obstacles = nullptr;
  double clearance_m = 0.0;
  PathLimits limits = {};
  std::vector<std::string> skipped_limits = {};  // that need not be looked at, by their names
  unsigned threads = 0;
  std::stop_token stop = {};

  [[nodiscard]] bool has_limits() const;
};

// Whether, of several, some two are there at the same time; drones of a show may fly one after the
// other. One alone is compared with its limits, or with obstacles. Otherwise nothing was compared,
// and nothing found is no all-clear.
bool compares(const io::Recording& recording, const PathVerdict& verdict,
              const PathQuestion& question);

// What a show declares; nothing where it does not say.
std::optional<double> declared_limit(const io::ShowFacts& show, PathLimit limit);

// `progress` hears which share of the bees was looked at. Errors: those of the library, with the
// bee's id.
Result<PathVerdict> verify_paths(const io::Recording& recording, const PathQuestion& question,
                                 const std::function<void(double)>& progress = {});

}  // namespace beespace::analysis
