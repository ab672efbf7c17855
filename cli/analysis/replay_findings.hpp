// What a recording holds, put together for people: whole tracks, their conflicts, and what follows
// from these for pairs, bees and moments.
#pragma once

#include "cli/analysis/coverage.hpp"
#include "cli/output/rows.hpp"
#include "io/recording/recording.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/track.hpp>

#include <optional>
#include <vector>

namespace beespace::cli {

struct Findings {
  const io::Recording& recording;
  const std::vector<Track>& tracks;
  const std::vector<Track>& in_space;  // the same; differs where heights are apart from positions
  const RecordedConflicts& recorded;
  const std::optional<Conflict>& closest;  // of all encounters, conflict or not
  const Coverage& coverage;
  bool anybody_meets;  // some two are there at the same time
};

// When the first bee appears and the last one vanishes; nothing where nobody does.
std::optional<TimeSpan> time_of(const std::vector<Track>& tracks);

// The pairs in conflict, the closest first: each with all its conflicts together.
struct PairInConflict {
  Conflict closest;
  std::size_t conflicts = 0;
  double time_s = 0.0;
};
std::vector<PairInConflict> pairs_in_conflict(const std::vector<Conflict>& conflicts);

// A row a bee: its id, its conflicts, how long it was in conflict (with however many at a time),
// how close it came to another one in a conflict, and with whom; and how long it is unknown.
Rows bee_rows(const Findings& findings);

// How far apart the closest two are of those that are known, at one moment after the other.
struct Moment {
  double time_s;
  double distance_m;  // infinite where there are fewer than two
  PointId first;
  PointId second;
  std::uint64_t unknown;  // bees
};
std::vector<Moment> separation_over_time(const Findings& findings, double every_s);
Rows separation_rows(const std::vector<Moment>& moments, const io::Recording& recording);

}  // namespace beespace::cli
