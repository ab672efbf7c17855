// Segments of tracks as balls for one step of time: each moves in a straight line through the step,
// and its radius covers the segment's deviation from that line.
#pragma once

#include "base/resources.hpp"
#include "motion/passing/passing_search.hpp"
#include "motion/track_segments.hpp"

#include <beespace/closest_approach.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace beespace::motion {

// An active segment, and its current piece.
struct ActiveSegment {
  std::uint32_t segment;
  std::size_t piece;
};

// The position of the segment at an instant of one of its pieces; rounded.
Point position_on(const Piece& piece, double time_s);

class StepBalls {
 public:
  // For a time span in which all of the active segments exist, at least for an instant. Their
  // pieces end at or after its beginning.
  StepBalls(std::span<const TrackSegment> segments, std::span<const ActiveSegment> active,
            const TimeSpan& time, const core::Resources& with);

  [[nodiscard]] MovingBalls balls() const;

 private:
  [[nodiscard]] PointsView middles() const {
    return std::span<const Point>(middles_.data(), size_);
  }

  // Returns how far it gets from its midpoint.
  double enclose(const TrackSegment& segment, std::size_t piece, const TimeSpan& time,
                 std::size_t ball);

  std::size_t size_;
  core::Buffer<Point> middles_;
  core::Buffer<Move> moves_;
  double reach_m_ = 0.0;
  core::Bounds bounds_;
};

}  // namespace beespace::motion
