// The last instant of a recording: movers at the present moment of a look at aircraft, which is
// when the input was written, where it says so.
#pragma once

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/last_climb.hpp"
#include "io/recording/recording.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {

// All bees at one instant, that in which the input was written, or the last that it knows of. A bee
// that was last heard of before is brought there in a straight line; or left out when that is more
// than max_age_s ago, but for one of which the input says how it flies on.
struct Snapshot {
  std::vector<Mover> movers;
  std::vector<double> heights_m;  // empty, or of each mover, kept apart from its position: in the
                                  // unit that the geometry compares, as climb rates are
  std::vector<double> climbs_mps;
  std::vector<std::uint32_t> bees;  // whose each mover is: ascending places in the recording
  double time_s = 0.0;
  std::uint64_t brought_forward = 0;
  double oldest_s = 0.0;    // of those: how far
  std::uint64_t stale = 0;  // left out
  // Of aircraft that are surely on the ground, heard of there max_age_s before that at most: left
  // out too, as they are no flyers to compare.
  std::uint64_t on_ground = 0;
  // Of aircraft that are created and fly on: since when there are two, where that is before now.
  // What was between is not in here.
  std::optional<double> passed_over_since_s = {};
  // Of these neither a velocity nor two fixes, max_age_s apart at most, tell how fast they go, or
  // nothing tells how fast they climb: they are no movers, and known only where they were last
  // heard of.
  struct Placed {
    std::uint32_t bee = 0;
    Point position = {};
    double height_m = 0.0;  // apart, as above
    double age_s = 0.0;     // how long before that it was there
  };
  std::vector<Placed> unmoving;
  bool with_heights = false;    // whether they are kept apart, of movers and unmoving ones
  std::uint64_t climbless = 0;  // of these: those of which only the climb rate is not known
  // Likewise, but of those that have one fix only.
  std::uint64_t level_only = 0;
  std::uint64_t estimated = 0;  // velocities that come from the last two fixes
  // Climb rates that are not those of the last fix, by what they come from; velocities that come
  // from the last two fixes as a whole are not among them.
  struct Climbs {
    std::uint64_t earlier = 0;
    std::uint64_t heights = 0;
    std::uint64_t two_fixes = 0;

    std::uint64_t& of(ClimbFrom from) {
      return from == ClimbFrom::kEarlier   ? earlier
             : from == ClimbFrom::kHeights ? heights
                                           : two_fixes;
    }
  };
  Climbs climbs;

  [[nodiscard]] MoversView view() const;
  // The movers, and behind them the unmoving ones where they were last heard of: the present moment
  // as far as it is known, of which a search must not look ahead.
  [[nodiscard]] Snapshot present() const;
};

// Whether the input says how it flies on from where it was created, on the Earth.
bool flies_round_the_earth(const io::Recording& recording, const io::RecordedBee& bee);

// Where such a one is so long after, at its track and height; with its height, apart as above.
struct FlownOn {
  Point position = {};
  double height_m = 0.0;
};
Result<FlownOn> flown_on(const io::Recording& recording, const io::RecordedBee& bee,
                         Geometry geometry, double by_s);

// Whether velocities matter of bees that need not be brought there.
enum class Wanted : std::uint8_t {
  kMotion,
  kMotionOrNow,  // where the input has velocities, of which none is known, the present moment alone
  kPlaces,       // likewise
};

// Errors: kMissingColumn where no bee has a velocity that is wanted, or two fixes to tell it from.
Result<Snapshot> snapshot_of(const io::Recording& recording, Geometry geometry, double max_age_s,
                             Wanted wanted);

// "from 0.00 s to 300.00 s not looked at"; empty where nothing was passed over.
std::string passed_over_text(const Snapshot& snapshot, const io::Recording& recording);

}  // namespace beespace::analysis
