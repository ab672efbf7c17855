// What pages, pictures and map files show of a swarm: what the engine found, and positions in a
// frame to look at. Plain values, put together by what asked the engine.
#pragma once

#include "io/recording/moment_text.hpp"
#include "io/recording/recorded_noun.hpp"
#include "io/recording/show_facts.hpp"
#include "report/fleet_facts.hpp"
#include "report/placement.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/geodesy.hpp>
#include <beespace/nearest.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::report {

// What bees are called: their numbers, where there are no texts.
struct Names {
  std::vector<std::string> texts = {};
  std::vector<PointId> bees = {};  // whose these are, ascending; empty: all bees'
  // What a bee is called from a time on, where that is several names one after the other, as an
  // aircraft is several flights: in ascending order of (bee, since_s).
  struct Called {
    PointId bee = 0;
    double since_s = 0.0;
    std::string text = {};
  };
  std::vector<Called> called = {};

  [[nodiscard]] std::string of(PointId bee) const;
  // The same at that time.
  [[nodiscard]] std::string at(double time_s, PointId bee) const;
};

// How those who made the input speak of heights: the sky's numbers beside metres.
struct HeightWords {
  bool in_feet = false;      // or in flight levels
  bool by_pressure = false;  // of the standard atmosphere, as flight levels are
  bool above_sea = false;    // mean sea level, not the ellipsoid
  bool unstated = false;     // what they are counted from is not said
  bool above_home = false;   // the place of take-off
};

struct SwarmFacts {
  std::string title;   // the file's name
  std::string source;  // what it was read as
  // Where east and north are 0, for geographic input, whose positions are metres east and north
  // along the ground, and heights (EarthFrame); otherwise positions are as given.
  std::optional<GeographicPosition> origin = {};
  // Where positions in metres lie, where the input says so.
  std::optional<Placement> own_place = {};
  // How positions that were in metres came to have an origin.
  std::optional<Placement> placed = {};
  HeightWords heights = {};
  bool aviation = false;  // figures tell distances in nautical miles and feet
  io::RecordedNoun noun = {};
  bool y_is_down = false;  // positions are those of a picture, whose origin is the corner above
  bool flat = false;       // the input has no heights: those of positions are 0, and are not shown
  double threshold_m = 0.0;
  std::string threshold_words = {};  // where it comes from, behind it: ", as the input declares"
  std::optional<double> vertical_m = {};
  bool inclusive = false;
  Names names = {};
  std::vector<std::string> notes = {};  // for the summary
  // To look at, in metres as given; beside an origin only where positions were placed there.
  std::vector<Obstacle> obstacles = {};
};

// How far apart two are horizontally and in height: geographic ones brought to height 0, and in
// their heights.
struct Apart {
  double horizontal_m = 0.0;
  double height_m = 0.0;
};

// Two that come too close after the moment of a snapshot, if all fly straight on.
struct ConflictAhead {
  PointId first = 0;
  PointId second = 0;
  double begins_in_s = 0.0;
  double closest_in_s = 0.0;  // with a vertical threshold: when they are worst
  double closest_m = 0.0;
  std::optional<Apart> apart = {};  // then
  Point first_there = {};           // where they are then, to look at
  Point second_there = {};
};

// What lies ahead of a snapshot that tells velocities.
struct Ahead {
  double horizon_s = 0.0;
  std::uint64_t count = 0;                    // of all that begin after the moment itself
  std::vector<ConflictAhead> conflicts = {};  // the worst first: as many as are told
  bool complete = true;                       // it is known of all how they fly on
};

struct SnapshotFacts {
  SwarmFacts swarm;
  std::string moment = {};          // when it is, where the input says so
  std::optional<Ahead> ahead = {};  // with a moment: nothing where no velocity is known
  std::vector<Point> positions;     // to look at
  std::vector<PointId> at_risk;     // ascending
  std::vector<Nearest> nearest;     // of each bee, at risk or not
  std::uint64_t pair_count = 0;     // of all
  std::uint64_t group_count = 0;    // of all
  std::uint64_t largest_group = 0;
  // Of each of those at risk: the closest of those it is in conflict with.
  std::vector<Nearest> closest_in_conflict = {};
  // Of those in conflict; where none is, of all.
  std::optional<ClosestPair> closest = {};
  // The closest first; all, or as many as can be shown.
  std::vector<Pair> pairs = {};
  std::vector<double> distances_m = {};  // of each of these
  std::vector<Apart> apart = {};         // of each of these, or none
  std::optional<Apart> closest_apart = {};
  std::string unknown = {};  // how many are left out; empty: none
};

// When a bee is in conflict with another.
struct AtRisk {
  PointId bee = 0;
  TimeSpan span;
};

// All conflicts of two together.
struct PairInConflict {
  PointId first = 0;
  PointId second = 0;
  std::uint64_t conflicts = 0;
  double time_s = 0.0;  // in conflict, in all
};

// How far apart the closest two are at a moment; with a vertical threshold, the two that are
// nearest to a conflict: by how far apart they are as shares of both thresholds, the greater one.
struct Separation {
  double time_s = 0.0;
  ClosestPair closest;
  std::optional<Apart> apart = {};  // with a vertical threshold
};

// The way from the first of a pair to the second around a conflict, at each instant at which one of
// them turns; in between it changes evenly.
struct PairWay {
  std::vector<double> times_s = {};
  std::vector<Point> ways = {};  // in metres of any axes; without an origin, z is up
  // With an origin: the same between the places below them at height 0, and up.
  std::vector<Point> ground_ways = {};
  std::vector<double> heights_m = {};
};

// A limit that a drone show declares, and the greatest value of it along the curves of all.
struct DeclaredLimit {
  std::string name;  // "horizontal", as a finding of `beespace verify`
  double most = 0.0;
  double greatest = 0.0;
  PointId bee = 0;
  double time_s = 0.0;
};

// A stretch in which one of them is exceeded.
struct LimitExcess {
  std::uint32_t limit = 0;  // its index
  PointId bee = 0;
  TimeSpan span;
  double greatest = 0.0;
  double time_s = 0.0;
};

struct RecordingFacts {
  SwarmFacts swarm;
  std::vector<Track> tracks;   // to look at
  double bend_m = 0.0;         // how far from their straight lines bees fly as they are looked at
  io::Calendar calendar = {};  // how its times are told
  std::vector<Gap> gaps = {};  // in ascending order of (track, begins_s)
  // Likewise: these, and when a bee is there before its first fix or after its last one.
  std::vector<Gap> unknown_spans = {};
  std::string unknown = {};          // who is unknown for how long, or left out; empty: none
  bool never_known = false;          // some are known nowhere, or two have one id
  bool hidden = false;               // whether conflicts may be hidden by that
  std::uint64_t nowhere_count = 0;   // beside `tracks`: who is known at no time
  bool nothing_compared = false;     // no two are there at the same time
  std::vector<AtRisk> at_risk = {};  // ascending by bee, then time; of a bee none overlap
  // The closest first; all, or as many as can be shown. With a vertical threshold the worst first,
  // by the greater of its shares of both thresholds, and told as closest is when that is the least.
  std::vector<Conflict> conflicts = {};
  std::uint64_t conflict_count = 0;          // of all
  std::uint64_t possible_count = 0;          // of these, not certain
  std::uint64_t standing_count = 0;          // beside these, of two that both stand on the ground
  std::uint64_t low_count = 0;               // likewise, of two that are low: see low_text
  std::string low_text = {};                 // "72 conflicts of two lower than 3 m above where ..."
  std::vector<Conflict> with_standing = {};  // of all: with a drone that stands on the ground
  std::uint64_t pair_count = 0;              // in conflict
  std::vector<PairInConflict> pairs = {};    // all of these, ascending
  std::optional<Conflict> closest = {};  // of the conflicts; where there is none, of all encounters
  bool closest_left_out = false;         // it is one of those that are low
  bool closest_stands = false;           // one of these two is a drone that stands on the ground:
  std::optional<Conflict> closest_in_the_air = {};  // then the same of two in the air
  std::vector<Apart> conflicts_apart = {};          // of each of `conflicts`, when they are closest
  std::optional<Apart> closest_apart = {};
  std::optional<Apart> closest_in_the_air_apart = {};
  // Of the first of `conflicts`, as many as a page can hold; where there is none, of `closest`.
  std::vector<PairWay> pair_ways = {};
  std::vector<Separation> separation = {};
  // When `separation` is not known, as one may be closer in its gap; ascending, none touch.
  std::vector<TimeSpan> separation_open = {};
  io::ShowLimits limits = {};                // of drone shows, as they declare them
  std::vector<io::ShowCue> cues = {};        // likewise
  std::vector<DeclaredLimit> declared = {};  // of `limits`, where a drone flies at all
  std::vector<LimitExcess> excesses = {};    // the greatest first, of each limit
  std::uint64_t excess_count = 0;            // of all
  std::vector<std::string> not_looked_at =
      {};                                // names of limits that the show declares beside them
  std::optional<FleetFacts> fleet = {};  // what its planner said of it, where that is known
};

}  // namespace beespace::report
