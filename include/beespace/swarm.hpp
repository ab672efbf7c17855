// A swarm as it is heard of: reports come in, events come out.
//
// What has happened is told from reports alone: between two reports that are no more than max_age_s
// apart a bee moves in a straight line, as in track.hpp; the time between two that are farther
// apart is unknown, as in a gap of a recording; and a bee that is heard of once is there at that
// instant. So the events *entered*, *closest passed*, *left* and *lost* are exact, and the same
// however often advance() is called, where reports come in the order of their times (a bee that is
// first heard of late has missed what all others know by then). They come as soon as both bees are
// known up to then. What is about to happen, *predicted*, is told from the last reports and
// velocities, as by predict_conflicts; it comes again for a pair only after the pair has been out
// of danger.
//
// Silence is not absence. A bee that has not been heard of for max_age_s is *stale*: it is
// somewhere, and stays known until it is removed. A pair that had entered and of which one falls
// silent is *lost*, which is neither left nor a distance that is kept. Each *entered* is followed
// by one of *left*, *lost* and *ended* of its pair. When the stale bee is *heard* of again, what
// there is then is told anew: *entered*, if the two are in conflict at that instant. With
// max_speed_mps, a stale bee is somewhere in a ball that grows with it around where it was last
// heard of, and any other bee in one around its own last report: where these come closer than the
// threshold, before one of the two is heard of, a conflict is *possible*. It is said once for a
// pair until one of the two is heard of again after a silence, or removed, and is so until then.
//
// So that nothing flaps, a pair that has entered (come closer than the threshold) has left only
// when it is farther apart than the leave threshold.
//
// Values of reports that are too small for exact comparison are zero to a swarm (see mover.hpp).
//
// Units: metres and seconds, in one Cartesian frame. Ids are the caller's own numbers. Memory: a
// few hundred bytes a bee until it is removed, of which there are at most max_bees; so much a pair
// that is followed, of which there are at most max_pairs; and the reports since the bee that was
// last heard of longest ago, which max_age_s bounds. Where a bound leaves something out, advance()
// says so (kOverloaded), and what it leaves out are the pairs farthest apart. A pair in conflict
// that makes room for closer ones is *lost*. Time: as the bees and their reports, and as the pairs
// up to a few times max_pairs; with max_speed_mps, stale bees times all bees too, as long as their
// balls have not reached all. Not thread-safe.
#pragma once

#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
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

  // Seconds: a bee that has not been heard of for longer is stale: unknown until it is.
  double max_age_s = 5.0;

  // How many threads may work, the calling one included; 0 means one per processor.
  unsigned threads = 1;

  // How many metres one unit of heights is that are apart, where these are not
  // metres: 0.3048 for feet. Then `vertical_m` and climb rates are in that unit too, and compared
  // with the heights as they are, exactly; distances that are told are in metres all the same.
  double height_unit_m = 1.0;

  // Metres per second: no bee is ever faster, heights included. Where it is given, what a stale bee
  // may be in conflict with comes as kPossible; without it that is unknown.
  std::optional<double> max_speed_mps = {};

  // How many bees are known at a time, stale ones included. The report of another one is refused.
  std::size_t max_bees = 1'000'000;

  // How many pairs are followed at a time: of those in conflict, of those predicted, and of those
  // possible so many each. Of more, the closest are. A pair takes up to some 700 bytes.
  std::size_t max_pairs = 500'000;
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

// In the order in which events of one instant are told.
enum class EventKind : std::uint8_t {
  kPredicted,      // a conflict lies ahead, or is there now
  kPossible,       // a stale bee may be in conflict with another one, at max_speed_mps
  kHeard,          // a stale bee has been heard of again
  kEntered,        // closer than the threshold
  kClosestPassed,  // the closest has passed: they are getting farther apart again
  kLeft,           // farther apart than the leave threshold, or one of the two was removed
  kStale,          // a bee has not been heard of for max_age_s
  kLost,           // one of two that had entered has fallen silent: from then on it is unknown
  kEnded,          // of finish(): two that had entered, when nothing more was heard
  kOverloaded,     // a bound was reached, and something left out: for as long as advance() says so
};
inline constexpr std::size_t kEventKinds = 10;

// What was reached where a swarm is overloaded.
enum class SwarmBound : std::uint8_t {
  kNone,
  kBees,       // max_bees: reports of others were refused; the first of them was of `first`
  kPairs,      // max_pairs, of pairs in conflict
  kPredicted,  // max_pairs, of pairs predicted
  kPossible,   // max_pairs, of possible conflicts
};

struct SwarmEvent {
  EventKind kind = EventKind::kPredicted;
  // When it happened; of a prediction, when it begins; of kStale, when the bee was last heard of;
  // of kLost and kEnded, up to when both are known; of kPossible, since when it may be so, from
  // where both were last heard of; of kOverloaded, when advance() was asked about.
  double time_s = 0.0;
  PointId first = 0;   // below second
  PointId second = 0;  // of kStale, kHeard and kOverloaded, the same as first
  // How far apart they are then; of a prediction, when they are closest; of kPossible, where they
  // were last heard of. Of kOverloaded, from what distance on pairs were left out.
  double distance_m = 0.0;
  // When they are closest: of a prediction; otherwise so far. Of the others, as time_s.
  double closest_s = 0.0;
  // Of kHeard, kStale, kLost and kPossible: since when the bee has been silent, or the one of two
  // that has been for longer.
  double since_s = 0.0;
  std::uint64_t count = 0;  // of kOverloaded: how many were left out, at least; 0: not known
  SwarmBound bound = SwarmBound::kNone;  // of kOverloaded

  friend constexpr bool operator==(const SwarmEvent&, const SwarmEvent&) = default;
};

// What became of the reports.
struct SwarmCounts {
  std::uint64_t taken = 0;
  std::uint64_t repeated = 0;  // the same time and position again: left out
  std::uint64_t late = 0;      // before one that was taken from the same bee: left out
  std::uint64_t bees = 0;      // known and not stale, now
  std::uint64_t stale = 0;     // now
  std::uint64_t refused = 0;   // of a bee beyond max_bees: left out
  std::uint64_t contrary = 0;  // the time of one of the last two again, elsewhere: left out
  // Bees that are known from one report only: where they were at that instant, and no more.
  std::uint64_t heard_once = 0;
  // Pairs of which a conflict was predicted, and neither has begun nor is averted, now.
  std::uint64_t predicted = 0;
  // For how long bees have been unknown in all, removed ones included, where they have been heard
  // of again.
  double unknown_s = 0.0;
};

// A bee that is known, and where it would be.
struct LiveMover {
  PointId id = 0;
  // Flown on straight from its last report, where it moves; otherwise it stands where it was last
  // heard of, which does not say that it stands: it may have gone anywhere since heard_s.
  Mover mover;
  double heard_s = 0.0;  // its last report
  Point heard_at;
  bool stale = false;  // when advance() was last called
  bool moves = false;  // it is not stale, and its velocity is known: given, or of two reports

  friend constexpr bool operator==(const LiveMover&, const LiveMover&) = default;
};

// A bee that was or is unknown for a time: between two reports more than max_age_s apart, or since
// its last one where it is stale.
struct Silence {
  PointId id = 0;
  double unknown_s = 0.0;              // in all, until now
  std::optional<double> since_s = {};  // of the silence that has not ended

  friend constexpr bool operator==(const Silence&, const Silence&) = default;
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

  // Takes note of a report, in any order of bees; of one bee, late, repeated and contrary ones are
  // counted and left out. Errors: kNotFinite, kOutsideDomain (too large for the motion domain, see
  // mover.hpp), kTooManyPoints (a bee beyond max_bees), with the bee in place.record; the report is
  // then left out, and all others count.
  Status update(const Report& report);

  // A bee that is there no longer, of which nothing is kept once the others have been heard of as
  // late as it was, or for max_age_s; unknown ones are no matter. What it was in has *left*.
  void remove(PointId id);

  // What comes next of a bee does not go on from what came before it (its clock has stepped,
  // reports in between cannot be used): it is stale from its last report on, until it is heard of
  // again.
  void lose(PointId id);

  // What has happened since the last call, and what is predicted at `now_s`, by which the age of
  // reports is told: in ascending order of (time, kind, first, second). Errors: kTimeOrder where
  // `now_s` is before that of the last call, kNotFinite, kInvalidThreshold, kInvalidArgument.
  Result<std::vector<SwarmEvent>> advance(double now_s);

  // The last advance(): nothing more will be heard. Pairs that have entered and neither left nor
  // been lost have *ended*. No bee is known afterwards, and times may begin anew; counts go on.
  // Errors: as advance().
  Result<std::vector<SwarmEvent>> finish(double now_s);

  // As finish(), but all bees stay known: times begin anew, and what was `now_s` is `then_s` now.
  // Stale ones stay so. Of others nothing is known between their last reports and the first ones
  // that come now, and nothing is said of that either, unless they do not come for max_age_s: then
  // they are stale. Errors: as advance().
  Result<std::vector<SwarmEvent>> begin_anew(double now_s, double then_s);

  [[nodiscard]] SwarmCounts counts() const;

  // All bees that have not been removed, at `time_s`, in ascending order of ids: stale ones, and
  // those heard of once, too. Heights that are kept apart are left out. None at a time outside the
  // motion domain.
  [[nodiscard]] std::vector<LiveMover> movers(double time_s) const;

  // The bees that have not been removed and were unknown for a time, until `time_s`, in ascending
  // order of ids; staleness is that of the last advance().
  [[nodiscard]] std::vector<Silence> silences(double time_s) const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace beespace
