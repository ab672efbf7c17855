// Which velocity shall each bee take next, so that nobody comes too close to anybody?
//
// Given where all bees are, how fast they fly and how each would like to fly, advise() gives each
// the velocity for the next step that is closest to its wish among those that are *certified*: as
// long as everybody does as advised, no two come closer than the threshold, in this step and for
// ever after, because everybody can always still brake to a stop clear of everybody else. Nor does
// anybody come too close to an obstacle. The proof and its conditions are in docs/prevention.md.
//
// The motion that is meant: in a step of `step_s` a bee changes its velocity evenly from the old
// one to the new one, within its greatest acceleration; one without such a limit flies with the new
// one from the start. Units: metres, seconds, in one Cartesian frame.
#pragma once

#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace beespace {

// What a bee can do.
struct FlightLimits {
  double max_speed_mps = 10.0;
  // Infinite: velocities change at once.
  double max_acceleration_mps2 = std::numeric_limits<double>::infinity();

  friend constexpr bool operator==(const FlightLimits&, const FlightLimits&) = default;
};

// The fastest flight straight to a goal that stops there: what to prefer for who has a place to go
// to. Zero within a nanometre of it.
BEESPACE_API Velocity velocity_to_goal(const Point& position, const Point& goal,
                                       const FlightLimits& limits, double step_s);

// Who keeps bees apart.
enum class AdviseMethod : std::uint8_t {
  kCertified,
  // Methods that are well known, to compare with. They promise nothing, and certify nobody; of
  // obstacles and intruders they know nothing.
  kOrca,  // optimal reciprocal collision avoidance, in space
  kMvp,   // modified voltage potential: sideways, out of each conflict that is ahead
};

struct AdviseOptions {
  // Metres: nobody shall come closer than this to anybody. Must be given.
  double threshold_m = kNotGiven;

  // Seconds: until the next advice. All bees begin it at the same time.
  double step_s = 0.1;

  // Metres: how far from where it is said to be a bee may be at most, if what is said moves as the
  // bee was told to: positions are those that the advice before led to, not measured anew (see
  // docs/prevention.md). It widens the threshold by twice this, and the clearance by once.
  double uncertainty_m = 0.0;

  // What stands in the way; not owned, and null for nothing. Nobody shall come closer to it than
  // the clearance, in metres, above zero; it must be given where there are obstacles.
  const ObstacleMap* obstacles = nullptr;
  double clearance_m = kNotGiven;

  // Who flies among the bees and does not do as advised; not owned. Everybody gives way to them, as
  // if they flew straight on for so many seconds, above zero. Nothing is promised about them.
  MoversView intruders = {};
  double intruder_horizon_s = 10.0;

  AdviseMethod method = AdviseMethod::kCertified;

  // How many threads may work, the calling one included; 0 means one per processor. The answer is
  // the same for every number.
  unsigned threads = 1;
};

enum class AdviceKind : std::uint8_t {
  kAsWished,   // the preferred velocity, or as near to it as the bee's limits allow
  kDeflected,  // another one, for the sake of others
  kBraking,    // the bee brakes as hard as it can: there is nothing better
  kWaiting,    // it would like to fly, and stands (or all but): others are in its way
};

struct Advice {
  Velocity velocity;  // for the end of the step; without a limit of acceleration, for all of it
  AdviceKind kind = AdviceKind::kAsWished;
  // Whether this bee keeps the threshold from all others that do as advised, and the clearance from
  // obstacles. It does not where it is closer already, or could not brake in time: see
  // Advised::too_close and Advised::near_obstacle.
  bool certified = true;

  friend constexpr bool operator==(const Advice&, const Advice&) = default;
};

// Two whose ways to a stop come closer than the threshold. They do not come closer than those ways
// are, and are told to part as fast as they can.
struct TooClose {
  Pair pair;
  double gap_m = 0.0;  // between the two ways; below zero, or so, where they cross
  // When the two are the threshold apart, if both go on as advised; infinite: not ever. Zero for
  // two who are too fast to stop in time, and still far enough apart.
  double clear_s = 0.0;

  friend constexpr bool operator==(const TooClose&, const TooClose&) = default;
};

// One whose way to a stop comes closer to an obstacle than the clearance.
struct NearObstacle {
  PointId bee = 0;
  std::size_t obstacle = 0;
  double gap_m = 0.0;

  friend constexpr bool operator==(const NearObstacle&, const NearObstacle&) = default;
};

// One to whom an intruder comes too close, if both fly straight on, the bee as advised.
struct IntruderConflict {
  PointId bee = 0;
  std::size_t intruder = 0;
  double begins_s = 0.0;
  double closest_m = 0.0;

  friend constexpr bool operator==(const IntruderConflict&, const IntruderConflict&) = default;
};

struct Advised {
  std::vector<Advice> advice;  // of each bee
  // What could not be certified, and because of whom; each ascending.
  std::vector<TooClose> too_close;
  std::vector<NearObstacle> near_obstacle;
  std::vector<IntruderConflict> intruder_conflicts;
};

// Gives advice again and again: keeps its working memory and its threads between calls.
//
// Ownership: an Adviser owns its memory. Not thread-safe: use one a thread.
class BEESPACE_API Adviser {
 public:
  Adviser();
  Adviser(const Adviser&) = delete;
  Adviser& operator=(const Adviser&) = delete;
  Adviser(Adviser&&) noexcept;
  Adviser& operator=(Adviser&&) noexcept;
  ~Adviser();

  // `preferred` has a velocity for each of `movers`; `limits` one set of limits for each, or one
  // for all. The answer depends on nothing but these: not on the order of calls, nor on threads.
  //
  // Cost: a microsecond or two a bee, and a tenth for each that it may meet; of n bees at one place
  // that is n squared, in time and in memory.
  //
  // Errors: kInvalidThreshold; kInvalidArgument for a step, clearance or horizon that is not above
  // zero, a negative uncertainty, a greatest speed that is negative or infinite, a greatest
  // acceleration that is not above zero, or spans of the wrong length; kNotFinite and
  // kOutsideDomain (the motion domain, see mover.hpp) for movers, preferred velocities and
  // intruders, with the mover in place.record; kTooManyPoints. Then `advised` is unspecified.
  Status advise(const MoversView& movers, std::span<const Velocity> preferred,
                std::span<const FlightLimits> limits, const AdviseOptions& options,
                Advised& advised);

 private:
  class State;
  std::unique_ptr<State> state_;
};

// The same once.
BEESPACE_API Result<Advised> advise(const MoversView& movers, std::span<const Velocity> preferred,
                                    std::span<const FlightLimits> limits,
                                    const AdviseOptions& options);

}  // namespace beespace
