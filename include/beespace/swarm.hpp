// A swarm as it is heard of: reports come in, events come out.
//
// What has happened is told from reports alone: between two reports a bee moves in a straight line,
// as in track.hpp, so the events *entered*, *closest passed* and *left* are exact, and the same
// however often advance() is called, where reports come in the order of their times (a bee that is
// first heard of late has missed what all others know by then) and nobody is removed in the middle
// of a conflict. They come as soon as both bees have been heard of again. What
// is about to happen, *predicted*, is told from the last reports and velocities, as by
// predict_conflicts; it comes again for a pair only after the pair has been out of danger.
//
// So that nothing flaps, a pair that has entered (come closer than the threshold) has left only
// when it is farther apart than the leave threshold.
//
// Units: metres and seconds, in one Cartesian frame. Ids are the caller's own numbers. Memory: a
// few hundred bytes a bee, and what is known of the time since the bee that was last heard of
// longest ago, which max_age_s bounds. Not thread-safe.
#pragma once

#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace beespace {

struct SwarmOptions {
  // Metres, as in ConflictOptions. Must be given.
  double threshold_m = kNotGiven;
  std::optional<double> vertical_m = {};

  // With vertical_m: heights are those that reports give apart from their positions, not z (as in
  // Track::heights_m).
  bool heights_apart = false;

  // Thresholds of leaving are those of entering times this: 1 or more.
  double leave_factor = 1.1;

  // Seconds: how far to look ahead. 0: no predictions.
  double horizon_s = 10.0;

  // Seconds: who has not been heard of for longer is stale, and counts as absent until it is.
  double max_age_s = 5.0;

  // How many threads may work, the calling one included; 0 means one per processor.
  unsigned threads = 1;

  // How many metres one unit of heights is that are apart, where these are not
  // metres: 0.3048 for feet. Then `vertical_m` and climb rates are in that unit too, and compared
  // with the heights as they are, exactly; distances that are told are in metres all the same.
  double height_unit_m = 1.0;
};

// One message: where a bee was at a time, and how fast it went, where that is known.
struct Report {
  PointId id = 0;
  double time_s = 0.0;
  Point position;
  std::optional<Velocity> velocity = {};  // absent: that of the last two reports

  // With SwarmOptions::heights_apart.
  double height_m = 0.0;
  double climb_mps = 0.0;  // counts where there is a velocity
};

enum class EventKind : std::uint8_t {
  kPredicted,      // a conflict lies ahead, or is there now
  kEntered,        // closer than the threshold
  kClosestPassed,  // the closest has passed: they are getting farther apart again
  kLeft,           // farther apart than the leave threshold, or one of the two is stale or removed
  kStale,          // a bee has not been heard of for max_age_s
};

struct SwarmEvent {
  EventKind kind = EventKind::kPredicted;
  double time_s = 0.0;  // when it happened; of a prediction, when it begins
  PointId first = 0;    // below second
  PointId second = 0;   // of kStale, the same as first
  // How far apart they are then; of a prediction, when they are closest.
  double distance_m = 0.0;
  double closest_s = 0.0;  // when they are closest: of a prediction; otherwise so far

  friend constexpr bool operator==(const SwarmEvent&, const SwarmEvent&) = default;
};

// What became of the reports.
struct SwarmCounts {
  std::uint64_t taken = 0;
  std::uint64_t repeated = 0;  // the same time and position again: left out
  std::uint64_t late = 0;      // before one that was taken from the same bee: left out
  std::uint64_t bees = 0;      // known and not stale, now
  std::uint64_t stale = 0;     // now
};

// Where a bee is, flown on straight from its last report, and how fast it goes.
struct LiveMover {
  PointId id = 0;
  Mover mover;

  friend constexpr bool operator==(const LiveMover&, const LiveMover&) = default;
};

class BEESPACE_API Swarm {
 public:
  // Errors of a swarm with options that make no sense come from every call.
  explicit Swarm(const SwarmOptions& options);
  Swarm(const Swarm&) = delete;
  Swarm& operator=(const Swarm&) = delete;
  Swarm(Swarm&&) noexcept;
  Swarm& operator=(Swarm&&) noexcept;
  ~Swarm();

  // Takes note of a report, in any order of bees; of one bee, late and repeated ones are counted
  // and left out. Errors: kNotFinite, kOutsideDomain (the motion domain, see mover.hpp), with the
  // bee in place.record; the report is then left out.
  Status update(const Report& report);

  // A bee that is there no longer; unknown ones are no matter.
  void remove(PointId id);

  // What has happened since the last call, and what is predicted at `now_s`, by which the age of
  // reports is told: in ascending order of (time, kind, first, second). Errors: kTimeOrder where
  // `now_s` is before that of the last call, kNotFinite, kInvalidThreshold, kInvalidArgument.
  Result<std::vector<SwarmEvent>> advance(double now_s);

  [[nodiscard]] SwarmCounts counts() const;

  // Everybody at `time_s`, as predictions see them, in ascending order of ids: but for those that
  // were stale when advance() was last called, and those heard of once and without a velocity.
  // Heights that are kept apart are left out. Nobody at a time outside the motion domain.
  [[nodiscard]] std::vector<LiveMover> movers(double time_s) const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace beespace
