// Pairs that come closer than the threshold over ground, and are kept apart by their heights alone:
// of animals, whose heights by satellites are off by tens of metres, and of what drives or swims,
// these say little. Of aircraft and drones that is how they fly.
#pragma once

#include "analysis/recorded/coverage.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {

struct KeptByHeight {
  std::uint64_t pairs = 0;
  bool more = false;  // so many were counted, and there are others
  // Of these: of animals, by what wrote the input, or of two that drive or swim, by their own word:
  // their heights say little.
  std::uint64_t unsure = 0;
  bool of_animals = false;
  std::uint64_t longer = 0;  // likewise: of pairs in conflict, which are so for longer over ground
  // Of the latter that for which it makes the greatest difference.
  struct Longer {
    PointId first = 0;
    PointId second = 0;
    double over_ground_s = 0.0;
    double in_space_s = 0.0;
    [[nodiscard]] double by_s() const { return over_ground_s - in_space_s; }
  };
  std::optional<Longer> longest = {};
  std::optional<Conflict> closest = {};  // over ground
  double vertical_m = 0.0;               // a vertical threshold with which all of them count
};

// Nothing where it was not looked at: without heights, of shows, which are planned so, with a
// vertical threshold, and in metres where there are conflicts. `options` are those with which
// `conflicts` were found; `low` are those that are left out as both are low, which no height keeps
// apart. Errors: those of find_conflicts() and of the conversion.
Result<std::optional<KeptByHeight>> kept_by_height(const io::Recording& recording,
                                                   const ConflictOptions& options,
                                                   double tolerance_m,
                                                   const std::vector<Conflict>& conflicts,
                                                   const std::vector<Conflict>& low = {});

// "2 pairs come closer than 50 m over ground, and only their heights keep them apart (a and b: 10.2
// m at ...): --vertical 100 counts them"; nothing where none is.
std::string kept_by_height_text(const KeptByHeight& kept, const io::Recording& recording,
                                double threshold_m);

// What keeps a verdict from being an all-clear: those whose heights say little; nothing where there
// are none.
std::string unsure_heights_text(const KeptByHeight& kept);

// Of flights that were verified: keeps those of animals, rovers and boats from holding where
// heights alone do (Coverage::heights). The rest as above.
Status judge_heights(const io::Recording& recording, const ConflictOptions& options,
                     const std::vector<Conflict>& conflicts, const std::vector<Conflict>& low,
                     Coverage& coverage);

}  // namespace beespace::analysis
