// Which velocity shall each bee take next, so that nobody comes too close to anybody?
//
// Given where all bees are, how fast they fly and how each would like to fly, advise() gives each
// the velocity for the next step that is closest to its wish among those that are *certified*: as
// long as everybody does as advised, no two come closer than the threshold, in this step and for
// ever after, because everybody can always still brake to a stop clear of everybody else. Nor does
// anybody come too close to an obstacle. The proof and its conditions are in docs/prevention.md.
//
// One bad number never stops the advice: a bee whose state cannot be used is named
// (Advised::refused) and gets no advice, and the others get theirs, certified as far as that is
// true without it.
//
// Values too small for the motion domain (below kSmallestInMotion, see mover.hpp) count as zero
// where they enter, which the certificate allows for.
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
#include <optional>
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
//
// Errors: kNotFinite and kOutsideDomain (the motion domain, see mover.hpp) for the position and the
// goal; kInvalidArgument for a step that is not above zero, and for limits as Adviser::advise.
BEESPACE_API Result<Velocity> velocity_to_goal(const Point& position, const Point& goal,
                                               const FlightLimits& limits, double step_s);

// Who keeps bees apart.
enum class AdviseMethod : std::uint8_t {
  kCertified,
  // Methods that are well known, to compare with. They promise nothing, and certify nobody; of
  // obstacles and intruders they know nothing.
  kOrca,  // optimal reciprocal collision avoidance, in space
  kMvp,   // modified voltage potential: sideways, out of each conflict that is ahead
};

// A bee that is not where it could be told, or was not heard of for a while: all that is known is a
// ball that it is in. So many seconds after the step begins, the ball has grown by its growth times
// that; of a bee that is known to hover, the growth is zero.
struct UnknownBee {
  Point center;
  double radius_m = 0.0;    // as the step begins; zero or more
  double growth_mps = 0.0;  // its greatest speed; zero or more

  // Which of the movers it is, if it is one: what they say of it is not looked at then, and it gets
  // no advice.
  std::optional<PointId> bee = {};

  friend constexpr bool operator==(const UnknownBee&, const UnknownBee&) = default;
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

  // Bees of which only a ball is known, that grows (see above); not owned. Everybody keeps clear of
  // what the balls are after so many seconds, above zero, as far as it can. What is promised of
  // them: Advice::clear_of_unknown_s.
  std::span<const UnknownBee> unknown = {};
  double unknown_horizon_s = 10.0;

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
  kNone,       // no advice: its state is unknown, or cannot be used (see Advised::refused)
};

struct Advice {
  // For the end of the step; without a limit of acceleration, for all of it. Of kNone it is no
  // advice, and zero.
  Velocity velocity;
  AdviceKind kind = AdviceKind::kNone;

  // The all-clear: all of the three below. What is proven of it holds for ever, or for
  // clear_of_unknown_s where that is finite.
  bool certified = false;

  // Proven: as long as everybody does as advised, this bee keeps the threshold from all others that
  // are advised, and the clearance from obstacles, for ever. It does not where it is closer
  // already, or could not brake in time: see Advised::too_close and Advised::near_obstacle.
  bool keeps_apart = false;

  // Foreseen, not proven: no intruder comes too close within the horizon, if it flies straight on
  // and the bee as advised. See Advised::intruder_conflicts. False for all where an intruder cannot
  // be used (Advised::refused): it may be anywhere.
  bool clear_of_intruders = false;

  // Proven: as long as this bee does as advised, it keeps the threshold from all unknown bees for
  // so many seconds from the beginning of the step, wherever in their balls they are, and however
  // often it is advised anew. Infinite where there are none, or where they do not grow; zero where
  // one that is nowhere to be found (Advised::refused) may be anywhere.
  double clear_of_unknown_s = 0.0;
  bool clear_of_unknown = false;  // for the whole unknown_horizon_s

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

// One whose way to a stop comes closer than the threshold to what the ball of an unknown bee may be
// within the horizon.
struct NearUnknown {
  PointId bee = 0;
  std::size_t unknown = 0;
  double gap_m = 0.0;    // between the way and the ball as the step begins
  double clear_s = 0.0;  // for so long it surely keeps the threshold

  friend constexpr bool operator==(const NearUnknown&, const NearUnknown&) = default;
};

// What was given that cannot be used, and what that means.
enum class RefusedKind : std::uint8_t {
  kState,  // of a bee, its position, velocity or limits: no advice for it. It may be anywhere, so
           // no other bee is clear of it, unless AdviseOptions::unknown says where it is at most.
  kWish,   // of a bee, its preferred velocity: it is advised as if it wished to stand
  kIntruder,  // no bee is clear of it
  kUnknown,   // no bee is clear of it
};

struct Refused {
  RefusedKind kind = RefusedKind::kState;
  std::size_t index = 0;  // of the bee, the intruder, or the unknown one
  Error error;            // what is wrong: kNotFinite, kOutsideDomain, kInvalidArgument
};

struct Advised {
  std::vector<Advice> advice;  // of each bee
  // What could not be certified, and because of whom; each ascending.
  std::vector<TooClose> too_close;
  std::vector<NearObstacle> near_obstacle;
  std::vector<IntruderConflict> intruder_conflicts;
  std::vector<NearUnknown> near_unknown;
  std::vector<Refused> refused;

  // Keeps the memory.
  void clear() {
    advice.clear();
    too_close.clear();
    near_obstacle.clear();
    intruder_conflicts.clear();
    near_unknown.clear();
    refused.clear();
  }
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
  // zero, a negative uncertainty, a method that is none, spans of the wrong length, an unknown bee
  // that is none of the movers; for limits that are given once for all, a greatest speed that is
  // negative or infinite, or a greatest acceleration that is not above zero; kTooManyPoints. Then
  // `advised` is empty. What is wrong with one bee or intruder alone is no error of the call: see
  // Advised::refused.
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
