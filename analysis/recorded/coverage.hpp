// Of how much of a recording it is known where its bees were: what an all-clear is about.
//
// Records that were left out since their place, height or time is missing or bad may be of bees
// that are not known at all (see io::MissingRecords).
//
// A bee is unknown in its gaps (see gaps.hpp), before its first fix and after its last one, from
// the beginning of the whole recording to its end. A drone of a show is where the plan says, and
// before and after on the ground, if it begins and ends there: otherwise it is in the air, and it
// is not known where. What is recorded with heights may be cut off in the air, too: where its fixes
// begin or end above the lowest place of all ends, or moving there; in degrees, where they begin
// later or end earlier by more than a gap. In metres and in a plane, what is seen from above comes
// and goes at the border of where all are, and who comes or goes in the midst of it was lost; so
// was, in degrees without heights, who moves there then, and, where all heights are 0, who begins
// or ends while it moves. Between two fixes it is unknown, too, where two records or more without a
// place are between them, unless it is asked how long a gap is. In a plane it is there, and it
// is not known where, while it has records without a place. An aircraft that says to be on the
// ground before or after is known from there on, and so is a drone that says that it has landed,
// unless it is never seen in the air itself while others fly (see airborne.hpp).
//
// Who asks about a cut of a sector (io::Recording::sector) says that before its first fix and after
// its last one a bee is outside: that hides nothing, and is counted only.
#pragma once

#include "analysis/recorded/gaps.hpp"
#include "io/recording/recorded_noun.hpp"
#include "io/recording/recording.hpp"

#include <beespace/find_conflicts.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {

inline double length_of(const Gap& gap) {
  return gap.ends_s - gap.begins_s;
}

struct Coverage {
  MaxGap max_gap;
  std::uint64_t gaps = 0;
  std::size_t bees_with_gaps = 0;
  double in_gaps_s = 0.0;    // summed over the bees
  std::vector<Gap> longest;  // of the gaps, at most kMostNamed
  // Who is heard of so seldom that as a rule its fixes, or bursts of them, are farther apart than
  // max_gap.
  std::vector<PointId> slow = {};
  double slowest_interval_s = 0.0;  // of these, the longest one
  bool bursts = false;              // some of these have several fixes at a time
  // A --max-gap that joins their fixes; of aircraft no more than that takes, as these fly straight
  // on where they report seldom, and a lost signal is to stay unknown.
  std::optional<double> joins_slow_s = {};
  bool of_aircraft = false;
  std::size_t bees_partly =
      0;  // whose first fix is later, or whose last is earlier, than of others
  std::size_t bees_cut_off = 0;   // of these: in the air then, or on their way in a plane
  std::size_t bees_unplaced = 0;  // of these: there then, in records without a place
  // Of these: never in the air in their own records, and not known while others fly.
  std::vector<PointId> unseen = {};
  // Recorded while no other is, though others are at the same time: compared with none.
  std::vector<PointId> alone = {};
  // As animals over years, and aircraft that pass. Logs and tables of drones that fly together are
  // of one time, or a clock is wrong.
  bool alone_is_known = true;
  std::optional<double> alone_begins_s =
      {};                           // of drones: how much later they begin than the others
  std::optional<Gap> bridged = {};  // the longest interval that was joined, where that is unusual
  bool in_a_plane = false;
  bool sector = false;  // before and after, those partly known are outside, and not asked about
  // Each bee is known for an instant, while time goes on: that of two bees at one is chance.
  bool instants_only = false;
  double outside_s = 0.0;  // before the first and after the last fix, summed over the bees
  // Of the times before and after in which some are there: the longest, at most kMostNamed.
  std::vector<Gap> longest_outside = {};
  io::MissingRecords missing;
  // Whose places are written so coarsely that two may be too close after all (see
  // coarse_places.hpp), and how far apart two that can be written are, at most.
  std::size_t coarse = 0;
  double coarse_m = 0.0;
  // Or the column by which they are off: half of the places of one of them by that much, or more.
  std::string coarse_by = {};
  std::size_t begins_in_air = 0;   // drones that fly when the recording begins
  std::string heights = {};        // who is kept apart by heights alone, which say little
  std::string whole_seconds = {};  // what is to be said of times that may be cut off

  static constexpr std::size_t kMostNamed = 3;

  // Whether it is known all the time where all bees were.
  [[nodiscard]] bool complete() const {
    return !may_hide_conflicts() && (bees_partly == 0 || sector);
  }
  // Whether a drone is that should have been with others.
  [[nodiscard]] bool compared_with_none() const { return !alone_is_known && !alone.empty(); }
  // Whether a bee was there, but it is not known where.
  [[nodiscard]] bool may_hide_conflicts() const {
    return gaps > 0 || !missing.none() || bees_cut_off > 0 || bees_unplaced > 0 || instants_only ||
           !unseen.empty() || compared_with_none() || coarse > 0 || !heights.empty();
  }
};

// `gaps` are those that max_gap makes: in ascending order of (track, begins_s).
Coverage coverage_of(const io::Recording& recording, const std::vector<Gap>& gaps,
                     const MaxGap& max_gap);
// The same of a recording that has the ends of its bees only, and `intervals` by bee.
Coverage coverage_of(const io::Recording& recording, const std::vector<Gap>& gaps,
                     const MaxGap& max_gap, const std::vector<BeeInterval>& intervals);

// For how long it is unknown of each bee where it was: in gaps, where it jumps or has records
// without a place, and before its first fix and after its last one. `gaps` as above.
std::vector<double> unknown_times_s(const io::Recording& recording, const std::vector<Gap>& gaps,
                                    const MaxGap& max_gap);

// When that is, in ascending order of (track, begins_s); none of a bee overlap.
std::vector<Gap> all_unknown_spans(const io::Recording& recording, const std::vector<Gap>& gaps,
                                   const MaxGap& max_gap);

// When a bee is there and it is not known where, so that conflicts may be hidden: in its gaps,
// where it jumps, and before its first fix and after its last one if it is in the air or on its way
// then, or has records without a place. In ascending order of (track, begins_s). `gaps` as above.
std::vector<Gap> unknown_spans(const io::Recording& recording, const std::vector<Gap>& gaps,
                               const MaxGap& max_gap);

// "72 bees before the first or after the last fix are outside the sector"; nothing where none is,
// or where it is not asked so.
std::string sector_text(const Coverage& coverage, const io::RecordedNoun& noun = {});

// "12 bees unknown for 3 h 20 min in all, 5 known for a part of the time only"; nothing where it is
// complete. With the recording the few are named that begin or end in the air.
std::string unknown_text(const Coverage& coverage, const io::Recording* recording = nullptr,
                         const io::RecordedNoun& noun = {});

// "1 bee is known nowhere, 6 records were left out"; nothing where none is missing.
std::string missing_text(const io::MissingRecords& missing, const io::RecordedNoun& noun = {});

// "a1b2c3 (UAL123) from 12.50 s for 3 min 20 s".
std::string gap_text(const Gap& gap, const io::Recording& recording);

// "3 is recorded while no other is: compared with none"; of drones also by how much it is apart
// from the others, and what to do about it. Nothing where there is none.
std::string alone_text(const Coverage& coverage, const io::Recording& recording);

// "3 from 20:00:33 for 5 s"; nothing where none is longer than is usual.
std::string bridged_text(const Coverage& coverage, const io::Recording& recording);

// "d2 has a fix every 2 s, which is more than the max gap, and is hardly ever known: --max-gap 10
// joins such fixes by straight lines"; nothing where there is none.
std::string slow_text(const Coverage& coverage, const io::Recording& recording);

}  // namespace beespace::analysis
