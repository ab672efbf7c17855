// Two bees in relative motion: are they in conflict at some instant?
//
// Written once for two kinds of numbers: a BoundedNumber nearly always gives a sign, and fast; an
// ExactNumber always does. Only signs are computed: no division, no root.
#pragma once

#include "exact/bounded_number.hpp"
#include "exact/exact_number.hpp"
#include "motion/separation.hpp"

#include <array>
#include <optional>

namespace beespace::motion {

template <class Number>
using Vector3 = std::array<Number, 3>;

template <class Number>
Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Number squared_cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  const Vector3<Number> cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                              a[0] * b[1] - a[1] * b[0]};
  return dot(cross, cross);
}

// numerator / denominator seconds; the denominator is above zero.
template <class Number>
struct Ratio {
  Number numerator;
  Number denominator;
};

// One mover is at r + w t relative to the other, for t from 0 to `duration`.
template <class Number>
struct Passage {
  Vector3<Number> r;
  Vector3<Number> w;
  Number threshold;
  Ratio<Number> duration;
};

// The relative motion in height, where that counts. Then r and w are horizontal.
template <class Number>
struct HeightPassage {
  Number z;
  Number climb;
  Number threshold;
};

// Signs that may be unknown: a comparison with zero is then neither true nor false.
class Sign {
 public:
  Sign(std::optional<int> sign) : sign_(sign) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] bool unknown() const { return !sign_.has_value(); }
  [[nodiscard]] bool negative() const { return *sign_ < 0; }
  [[nodiscard]] bool positive() const { return *sign_ > 0; }
  [[nodiscard]] bool zero() const { return *sign_ == 0; }
  // Below the threshold; or at it, if the query is inclusive.
  [[nodiscard]] bool below(bool inclusive) const { return inclusive ? *sign_ <= 0 : *sign_ < 0; }

 private:
  std::optional<int> sign_;
};

// |r + w t| < threshold for some t in [0, duration]; nothing where a sign that matters is unknown.
//
// The squared distance less X^2 is a t^2 + 2 b t + c. It is below zero somewhere when it is at the
// start (c), or when it falls there (b < 0), reaches below zero at all (D = b^2 - a c > 0) and does
// so in time: its lowest point lies before the end (a T + b >= 0), or its end is below zero.
// D is computed as a X^2 - |r x w|^2, which cancels less.
template <class Number>
std::optional<bool> comes_close(const Passage<Number>& p, bool inclusive) {
  const Number squared_threshold = p.threshold * p.threshold;
  const Number c = dot(p.r, p.r) - squared_threshold;
  const Sign now = c.sign();
  if (now.unknown()) return std::nullopt;
  if (now.below(inclusive)) return true;

  const Number b = dot(p.r, p.w);
  const Sign approaching = b.sign();
  if (approaching.unknown()) return std::nullopt;
  if (!approaching.negative()) return false;

  const Number a = dot(p.w, p.w);
  const Sign misses = (squared_cross(p.r, p.w) - a * squared_threshold).sign();
  if (misses.unknown()) return std::nullopt;
  if (!misses.below(inclusive)) return false;

  const auto& [numerator, denominator] = p.duration;
  const Number slope = a * numerator + b * denominator;
  const Sign receding = slope.sign();
  if (receding.unknown()) return std::nullopt;
  if (!receding.negative()) return true;

  const Number end = (slope + b * denominator) * numerator + c * denominator * denominator;
  const Sign then = end.sign();
  if (then.unknown()) return std::nullopt;
  return then.below(inclusive);
}

// The same while |z + climb t| < threshold in height as well: finds the time in which that holds, a
// stretch of [0, duration] with rational ends, and decides the above for it.
//
// Heights are close in an open interval of time, but the query may be about a closed one: a pair
// that is close at an end of it is close shortly before or after as well, as long as it has a
// length, which it has unless the duration is 0.
template <class Number>
std::optional<bool> comes_close(Passage<Number> p, HeightPassage<Number> h, bool inclusive) {
  const Sign climbing = h.climb.sign();
  if (climbing.unknown()) return std::nullopt;
  if (climbing.negative()) {
    h.z = -h.z;
    h.climb = -h.climb;
  }
  // The climb until it leaves the height, and until it enters.
  const Number until_leaving = h.threshold - h.z;
  const Number until_entering = -h.threshold - h.z;
  const Sign left = (-until_leaving).sign();
  if (left.unknown()) return std::nullopt;
  if (!left.below(inclusive)) return false;

  const auto [numerator, denominator] = p.duration;
  const Number climbs = numerator * h.climb;
  const Sign enters = (until_entering * denominator - climbs).sign();
  if (enters.unknown()) return std::nullopt;
  if (!enters.below(inclusive)) return false;
  if (climbing.zero()) return comes_close(p, inclusive);

  const Sign leaves_late = (until_leaving * denominator - climbs).sign();
  const Sign enters_later = until_entering.sign();
  if (leaves_late.unknown() || enters_later.unknown()) return std::nullopt;
  Ratio<Number> end = p.duration;
  if (leaves_late.negative()) end = {until_leaving, h.climb};
  if (!enters_later.positive()) {
    p.duration = end;
    return comes_close(p, inclusive);
  }
  // From the time of entering on; lengths and times are multiplied by the climb.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p.r[axis] = p.r[axis] * h.climb + p.w[axis] * until_entering;
    p.w[axis] = p.w[axis] * h.climb;
  }
  p.threshold = p.threshold * h.climb;
  p.duration = {end.numerator * h.climb - until_entering * end.denominator,
                end.denominator * h.climb};
  return comes_close(p, inclusive);
}

// Either of the above, by the separation, for motion on four axes. Lengths are those of the
// separation times `scale`.
template <class Number>
std::optional<bool> comes_close(const std::array<Number, 4>& r, const std::array<Number, 4>& w,
                                const Number& scale, const Ratio<Number>& duration,
                                const Separation& separation) {
  Passage<Number> passage{
      {r[0], r[1], r[2]}, {w[0], w[1], w[2]}, Number(separation.threshold_m) * scale, duration};
  if (!separation.vertical_m) return comes_close(passage, separation.inclusive);
  const std::size_t up = separation.vertical_axis();
  if (up < 3) passage.r[up] = passage.w[up] = Number(0.0);
  const HeightPassage<Number> height{r[up], w[up], Number(*separation.vertical_m) * scale};
  return comes_close(passage, height, separation.inclusive);
}

}  // namespace beespace::motion
