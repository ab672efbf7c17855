// How close two curves of third degree come, the slow way: sampled densely, and refined where a
// sample is below its neighbours, all in long double.
#pragma once

#include <beespace/mover.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace beespace::test {

// One axis of the curve with these places and velocities at its ends, at a share of its time.
inline long double hermite(double p, double v, double q, double w, double lasts_s, long double u) {
  const auto longer = [](double number) { return static_cast<long double>(number); };
  const long double rest = 1.0L - u;
  const long double third = longer(lasts_s) / 3.0L;
  const long double b = longer(p) + longer(v) * third;
  const long double c = longer(q) - longer(w) * third;
  return rest * rest * rest * longer(p) + 3.0L * rest * rest * u * b + 3.0L * rest * u * u * c +
         u * u * u * longer(q);
}

inline std::array<long double, 3> place_at(const Mover& from, const Mover& to, double lasts_s,
                                           long double u) {
  const auto& [p, v] = from;
  const auto& [q, w] = to;
  return {hermite(p.x, v.x, q.x, w.x, lasts_s, u), hermite(p.y, v.y, q.y, w.y, lasts_s, u),
          hermite(p.z, v.z, q.z, w.z, lasts_s, u)};
}

// The least of a smooth function of [0, 1].
template <class Function>
long double least_of(const Function& f, int samples = 400) {
  const auto at = [&](int i) {
    return static_cast<long double>(i) / static_cast<long double>(samples);
  };
  long double least = std::min(f(0.0L), f(1.0L));
  for (int i = 0; i <= samples; ++i) {
    const long double here = f(at(i));
    if (i > 0 && f(at(i - 1)) < here) continue;
    if (i < samples && f(at(i + 1)) < here) continue;
    // Thirds: around a sample that is below both its neighbours there is one least place.
    long double low = at(std::max(0, i - 1));
    long double high = at(std::min(samples, i + 1));
    for (int halving = 0; halving < 100; ++halving) {
      const long double third = (high - low) / 3.0L;
      if (f(low + third) < f(high - third)) {
        high -= third;
      } else {
        low += third;
      }
    }
    least = std::min(least, f(0.5L * (low + high)));
  }
  return least;
}

// Of two movers in a step.
inline double oracle_closest(const std::array<Mover, 2>& from, const std::array<Mover, 2>& to,
                             double lasts_s) {
  const auto distance = [&](long double u) {
    const auto a = place_at(from[0], to[0], lasts_s, u);
    const auto b = place_at(from[1], to[1], lasts_s, u);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  return static_cast<double>(least_of(distance));
}

}  // namespace beespace::test
