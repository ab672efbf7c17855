// The motion of one bee relative to another while both move in straight lines: where, when and how
// close, in doubles. For reports only: encounter.hpp decides whether there is a conflict.
#pragma once

#include <beespace/closest_approach.hpp>

#include <array>
#include <cstddef>

namespace beespace::motion {

// Position r + w t. Positions are subtracted first, so that the distance of the two from the origin
// does not blur later differences.
template <std::size_t Axes>
struct RelativeMotion {
  std::array<double, Axes> r{};
  std::array<double, Axes> w{};
};

struct Nearness {
  double time_s = 0.0;
  double distance_m = 0.0;
};

// When the two are closest within the span (the first such instant), and how close.
template <std::size_t Axes>
Nearness closest_within(const RelativeMotion<Axes>& motion, const TimeSpan& span);

// While they are closer than the threshold within [0, duration]. If rounding yields that they never
// are, the instant at which they nearly are.
template <std::size_t Axes>
TimeSpan time_closer(const RelativeMotion<Axes>& motion, double threshold, double duration);

}  // namespace beespace::motion
