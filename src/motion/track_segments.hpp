// Stretches of a track that are known without a gap, and the straight pieces that they are made of.
#pragma once

#include <beespace/find_conflicts.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace beespace::motion {

// Fixes of a track in sequence; a single one exists for an instant.
struct TrackSegment {
  PointId track = 0;
  double tolerance_m = 0.0;
  std::span<const Fix> fixes;
  std::span<const double> heights_m;  // empty, or one for each fix
  bool complete = true;               // no fix will be added to it

  [[nodiscard]] double begins_s() const { return fixes.front().time_s; }
  [[nodiscard]] double ends_s() const { return fixes.back().time_s; }
  // A single fix is a piece.
  [[nodiscard]] std::size_t pieces() const { return fixes.size() > 1 ? fixes.size() - 1 : 1; }
  // A single fix that may still become the beginning of a piece: until then it exists at that
  // instant.
  [[nodiscard]] bool waits() const { return fixes.size() == 1 && !complete; }
};

// From one fix to the next; a single fix is a piece that lasts an instant.
struct Piece {
  const Fix& from;
  const Fix& to;
  double from_height_m = 0.0;
  double to_height_m = 0.0;

  [[nodiscard]] bool instant() const { return &from == &to; }
  [[nodiscard]] double lasts_s() const { return to.time_s - from.time_s; }
};

inline Piece piece_of(const TrackSegment& segment, std::size_t index) {
  const std::size_t next = index + (segment.fixes.size() > 1 ? 1 : 0);
  if (segment.heights_m.empty()) return {segment.fixes[index], segment.fixes[next]};
  return {segment.fixes[index], segment.fixes[next], segment.heights_m[index],
          segment.heights_m[next]};
}

struct TrackSegments {
  std::vector<TrackSegment> segments;  // ascending by track, then by time
  std::vector<Gap> gaps;
};

// Cuts tracks where consecutive fixes are more than max_gap_s apart.
TrackSegments cut_at_gaps(std::span<const Track> tracks, double max_gap_s);

}  // namespace beespace::motion
