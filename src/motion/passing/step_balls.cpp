#include "motion/passing/step_balls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace beespace::motion {

namespace {

Point between(const Point& p, const Point& q, double share) {
  return {p.x + (q.x - p.x) * share, p.y + (q.y - p.y) * share, p.z + (q.z - p.z) * share};
}

double distance_between(const Point& p, const Point& q) {
  const double x = q.x - p.x;
  const double y = q.y - p.y;
  const double z = q.z - p.z;
  return std::sqrt(x * x + y * y + z * z);
}

// Calls visit(time, position) where the segment enters and leaves the time span, and at its fixes
// in between: it is farthest from a straight line at one of them.
template <class Visit>
void for_each_corner(const TrackSegment& segment, std::size_t piece, const TimeSpan& time,
                     Visit&& visit) {
  const double begin = std::max(time.begins_s, segment.begins_s());
  visit(begin, position_on(piece_of(segment, piece), begin));
  for (; piece < segment.pieces(); ++piece) {
    const Piece at = piece_of(segment, piece);
    if (at.to.time_s > time.ends_s) {
      if (at.from.time_s < time.ends_s) visit(time.ends_s, position_on(at, time.ends_s));
      return;
    }
    visit(at.to.time_s, at.to.position);
  }
}

}  // namespace

Point position_on(const Piece& piece, double time_s) {
  if (piece.instant()) return piece.from.position;
  const double share = (time_s - piece.from.time_s) / (piece.to.time_s - piece.from.time_s);
  return between(piece.from.position, piece.to.position, share);
}

StepBalls::StepBalls(std::span<const TrackSegment> segments, std::span<const ActiveSegment> active,
                     const TimeSpan& time, const core::Resources& with)
    : size_(active.size()), middles_(with.memory, size_), moves_(with.memory, size_) {
  core::PerWorker<double> farthest(with);
  with.crew.split(size_, [&](std::size_t begin, std::size_t end, unsigned worker) {
    double most = 0.0;
    for (std::size_t ball = begin; ball < end; ++ball) {
      most =
          std::max(most, enclose(segments[active[ball].segment], active[ball].piece, time, ball));
    }
    farthest[worker].push_back(most);
  });
  for (const double reach : std::move(farthest).joined()) reach_m_ = std::max(reach_m_, reach);
  bounds_ = *core::measure(middles(), with);
}

double StepBalls::enclose(const TrackSegment& segment, std::size_t piece, const TimeSpan& time,
                          std::size_t ball) {
  Point entered;
  Point left;
  Point low;
  Point high;
  bool first = true;
  for_each_corner(segment, piece, time, [&](double, const Point& p) {
    if (first) low = high = entered = p;
    first = false;
    left = p;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  });
  // A mover that is not there all the time, or is faster than a float can hold, stands still at the
  // midpoint of where it is.
  constexpr double kFastest = 0x1p+100;
  const double lasts = time.ends_s - time.begins_s;
  const bool all_the_time = lasts > 0.0 && segment.begins_s() <= time.begins_s &&
                            segment.ends_s() >= time.ends_s &&
                            distance_between(entered, left) / lasts < kFastest;
  const Point middle = all_the_time ? between(entered, left, 0.5) : between(low, high, 0.5);
  Point velocity;  // as rounded to floats
  if (all_the_time) {
    velocity = {static_cast<float>((left.x - entered.x) / lasts),
                static_cast<float>((left.y - entered.y) / lasts),
                static_cast<float>((left.z - entered.z) / lasts)};
  }
  // Where times are large and the step is short, its midpoint is rounded by up to half a last bit
  // of the time: less than this, which also bounds how far the line is moved.
  const double time_blur = 0x1p-52 * std::max(std::abs(time.begins_s), std::abs(time.ends_s));
  const double speed = distance_between({}, velocity);
  double radius = 0.0;
  for_each_corner(segment, piece, time, [&](double at, const Point& p) {
    const double since = at - (time.begins_s + 0.5 * lasts);
    const Point line{middle.x + velocity.x * since, middle.y + velocity.y * since,
                     middle.z + velocity.z * since};
    radius = std::max(radius, distance_between(line, p));
  });
  // Tolerances widen a cylinder in both directions: the sphere around it by up to the root of 2.
  constexpr double kOfCylinders = 1.41422;
  middles_[ball] = middle;
  moves_[ball] = {static_cast<float>(velocity.x), static_cast<float>(velocity.y),
                  static_cast<float>(velocity.z),
                  std::nextafter(static_cast<float>(radius + speed * time_blur +
                                                    kOfCylinders * segment.tolerance_m),
                                 std::numeric_limits<float>::infinity())};
  return speed * (0.5 * lasts) + double{moves_[ball].radius_m};
}

MovingBalls StepBalls::balls() const {
  return {middles(), bounds_, {moves_.data(), size_}, reach_m_};
}

}  // namespace beespace::motion
