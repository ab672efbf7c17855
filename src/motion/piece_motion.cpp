#include "motion/piece_motion.hpp"

#include "motion/encounter.hpp"

#include <array>

namespace beespace::motion {

namespace {

Axes4 axes_of(const Point& p, double height_m) {
  return {p.x, p.y, p.z, height_m};
}

// Two pieces during the window. With the durations of the pieces multiplied into all lengths,
// nothing is divided:
//   r D E = (q0 - p0) D E + (q1 - q0) (begin - s0) D - (p1 - p0) (begin - t0) E
template <class Number>
std::optional<bool> decide(const Piece& first, const Piece& second, const TimeSpan& window,
                           const Separation& separation) {
  const auto duration = [](const Piece& piece) {
    return piece.instant() ? Number(1.0) : Number(piece.to.time_s) - Number(piece.from.time_s);
  };
  const Number lasts_first = duration(first);
  const Number lasts_second = duration(second);
  const Number both = lasts_first * lasts_second;
  const Number begin = Number(window.begins_s);
  const Number since_first = (begin - Number(first.from.time_s)) * lasts_second;
  const Number since_second = (begin - Number(second.from.time_s)) * lasts_first;
  const Axes4 p0 = axes_of(first.from.position, first.from_height_m);
  const Axes4 p1 = axes_of(first.to.position, first.to_height_m);
  const Axes4 q0 = axes_of(second.from.position, second.from_height_m);
  const Axes4 q1 = axes_of(second.to.position, second.to_height_m);
  std::array<Number, 4> r;
  std::array<Number, 4> w;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const Number move_first = Number(p1[axis]) - Number(p0[axis]);
    const Number move_second = Number(q1[axis]) - Number(q0[axis]);
    r[axis] = (Number(q0[axis]) - Number(p0[axis])) * both +
              (move_second * since_second - move_first * since_first);
    w[axis] = move_second * lasts_first - move_first * lasts_second;
  }
  return comes_close<Number>(r, w, both, {Number(window.ends_s) - begin, Number(1.0)}, separation);
}

}  // namespace

bool in_conflict(const Piece& first, const Piece& second, const TimeSpan& window,
                 const Separation& separation) {
  if (separation.threshold_m <= 0.0 || separation.vertical_m.value_or(1.0) <= 0.0) return false;
  if (const auto sure = decide<BoundedNumber>(first, second, window, separation)) return *sure;
  return *decide<ExactNumber>(first, second, window, separation);
}

RelativeMotion<4> relative_motion(const Piece& first, const Piece& second, double time_s) {
  // The part of the piece that has been flown, as a share, and the time of the whole piece.
  const auto share = [time_s](const Piece& piece) {
    return piece.instant() ? 0.0 : (time_s - piece.from.time_s) / piece.lasts_s();
  };
  const double share_first = share(first);
  const double share_second = share(second);
  const double lasts_first = first.instant() ? 1.0 : first.lasts_s();
  const double lasts_second = second.instant() ? 1.0 : second.lasts_s();
  const Axes4 p0 = axes_of(first.from.position, first.from_height_m);
  const Axes4 p1 = axes_of(first.to.position, first.to_height_m);
  const Axes4 q0 = axes_of(second.from.position, second.from_height_m);
  const Axes4 q1 = axes_of(second.to.position, second.to_height_m);
  RelativeMotion<4> motion;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const double move_first = p1[axis] - p0[axis];
    const double move_second = q1[axis] - q0[axis];
    // The starts first: large numbers cancel there.
    motion.r[axis] =
        (q0[axis] - p0[axis]) + (move_second * share_second - move_first * share_first);
    motion.w[axis] = move_second / lasts_second - move_first / lasts_first;
  }
  return motion;
}

}  // namespace beespace::motion
