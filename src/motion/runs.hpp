// Stretches of a track that are known without a gap, and the straight pieces that they are made of.
#pragma once

#include <beespace/find_conflicts.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace beespace::motion {

// Fixes of a track, one behind the other; a single one is there for an instant.
struct Run {
  PointId track = 0;
  double tolerance_m = 0.0;
  std::span<const Fix> fixes;

  [[nodiscard]] double begins_s() const { return fixes.front().time_s; }
  [[nodiscard]] double ends_s() const { return fixes.back().time_s; }
  [[nodiscard]] std::size_t pieces() const { return fixes.size() > 1 ? fixes.size() - 1 : 1; }
};

// From one fix to the next; a single fix is a piece that stands for an instant.
struct Piece {
  const Fix& from;
  const Fix& to;

  [[nodiscard]] bool instant() const { return &from == &to; }
};

inline Piece piece_of(const Run& run, std::size_t index) {
  return {run.fixes[index], run.fixes[index + (run.fixes.size() > 1 ? 1 : 0)]};
}

struct Runs {
  std::vector<Run> runs;  // ascending by track, then by time
  std::vector<Gap> gaps;
};

// Cuts tracks where two fixes are more than max_gap_s apart.
Runs cut_at_gaps(std::span<const Track> tracks, double max_gap_s);

}  // namespace beespace::motion
