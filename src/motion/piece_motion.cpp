#include "motion/piece_motion.hpp"

#include "motion/encounter.hpp"

#include <array>

namespace beespace::motion {

namespace {

using Coordinates = std::array<double, 3>;

Coordinates coordinates(const Point& p) {
  return {p.x, p.y, p.z};
}

// Two pieces from `begin` to `end`. With the durations of the pieces multiplied into all lengths,
// nothing is divided:
//   r D E = (q0 - p0) D E + (q1 - q0) (begin - s0) D - (p1 - p0) (begin - t0) E
template <class Number>
Passage<Number> passage_of(const Piece& first, const Piece& second, const TimeSpan& window,
                           double threshold) {
  const auto duration = [](const Piece& piece) {
    return piece.instant() ? Number(1.0) : Number(piece.to.time_s) - Number(piece.from.time_s);
  };
  const Number lasts_first = duration(first);
  const Number lasts_second = duration(second);
  const Number both = lasts_first * lasts_second;
  const Number since_first = (Number(window.begins_s) - Number(first.from.time_s)) * lasts_second;
  const Number since_second = (Number(window.begins_s) - Number(second.from.time_s)) * lasts_first;
  const Coordinates p0 = coordinates(first.from.position);
  const Coordinates p1 = coordinates(first.to.position);
  const Coordinates q0 = coordinates(second.from.position);
  const Coordinates q1 = coordinates(second.to.position);
  Passage<Number> passage;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Number move_first = Number(p1[axis]) - Number(p0[axis]);
    const Number move_second = Number(q1[axis]) - Number(q0[axis]);
    passage.r[axis] = (Number(q0[axis]) - Number(p0[axis])) * both +
                      (move_second * since_second - move_first * since_first);
    passage.w[axis] = move_second * lasts_first - move_first * lasts_second;
  }
  passage.threshold = Number(threshold) * both;
  passage.duration = {Number(window.ends_s) - Number(window.begins_s), Number(1.0)};
  return passage;
}

template <class Number>
std::optional<bool> decide(const Piece& first, const Piece& second, const TimeSpan& window,
                           const Separation& separation) {
  Passage<Number> passage =
      passage_of<Number>(first, second, window, separation.threshold_m);
  if (!separation.vertical_m) return comes_close(passage, separation.inclusive);
  const Passage<Number> upright =
      passage_of<Number>(first, second, window, *separation.vertical_m);
  const HeightPassage<Number> height{passage.r[2], passage.w[2], upright.threshold};
  passage.r[2] = Number(0.0);
  passage.w[2] = Number(0.0);
  return comes_close(passage, height, separation.inclusive);
}

}  // namespace

bool in_conflict(const Piece& first, const Piece& second, const TimeSpan& window,
                 const Separation& separation) {
  if (separation.threshold_m <= 0.0 || separation.vertical_m.value_or(1.0) <= 0.0) return false;
  if (const auto sure = decide<BoundedNumber>(first, second, window, separation)) return *sure;
  return *decide<ExactNumber>(first, second, window, separation);
}

RelativeMotion<3> relative_motion(const Piece& first, const Piece& second, double time_s) {
  // What has been moved of the piece so far, as a share, and the time it takes as a whole.
  const auto share = [time_s](const Piece& piece) {
    if (piece.instant()) return 0.0;
    return (time_s - piece.from.time_s) / (piece.to.time_s - piece.from.time_s);
  };
  const double share_first = share(first);
  const double share_second = share(second);
  const double lasts_first = first.instant() ? 1.0 : first.to.time_s - first.from.time_s;
  const double lasts_second = second.instant() ? 1.0 : second.to.time_s - second.from.time_s;
  const Coordinates p0 = coordinates(first.from.position);
  const Coordinates p1 = coordinates(first.to.position);
  const Coordinates q0 = coordinates(second.from.position);
  const Coordinates q1 = coordinates(second.to.position);
  RelativeMotion<3> motion;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double move_first = p1[axis] - p0[axis];
    const double move_second = q1[axis] - q0[axis];
    // The starts first: they are where large numbers cancel.
    motion.r[axis] =
        (q0[axis] - p0[axis]) + (move_second * share_second - move_first * share_first);
    motion.w[axis] = move_second / lasts_second - move_first / lasts_first;
  }
  return motion;
}

}  // namespace beespace::motion
