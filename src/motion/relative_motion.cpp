#include "motion/relative_motion.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::motion {

namespace {

template <std::size_t Axes>
double dot(const std::array<double, Axes>& a, const std::array<double, Axes>& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < Axes; ++axis) sum += a[axis] * b[axis];
  return sum;
}

// |r x w|^2, or what corresponds to it with other than three axes: |r|^2 |w|^2 - (r w)^2 without
// the cancellation.
template <std::size_t Axes>
double squared_cross(const std::array<double, Axes>& r, const std::array<double, Axes>& w) {
  double sum = 0.0;
  for (std::size_t i = 0; i < Axes; ++i) {
    for (std::size_t k = i + 1; k < Axes; ++k) {
      const double part = r[i] * w[k] - r[k] * w[i];
      sum += part * part;
    }
  }
  return sum;
}

}  // namespace

template <std::size_t Axes>
Nearness closest_within(const RelativeMotion<Axes>& motion, const TimeSpan& span) {
  const auto& [r, w] = motion;
  const double a = dot(w, w);
  const double b = dot(r, w);
  const double lowest = a > 0.0 ? -b / a : span.begins_s;
  if (lowest > span.begins_s && lowest < span.ends_s) {
    return {lowest, std::sqrt(squared_cross(r, w) / a)};
  }
  const double time = lowest >= span.ends_s ? span.ends_s : span.begins_s;
  std::array<double, Axes> at = r;
  for (std::size_t axis = 0; axis < Axes; ++axis) at[axis] += w[axis] * time;
  return {time, std::sqrt(dot(at, at))};
}

// Roots of a t^2 + 2 b t + c, in the form without cancellation.
template <std::size_t Axes>
TimeSpan time_closer(const RelativeMotion<Axes>& motion, double threshold, double duration) {
  const auto& [r, w] = motion;
  const double a = dot(w, w);
  const double b = dot(r, w);
  const double distance = std::sqrt(dot(r, r));
  const double c = (distance - threshold) * (distance + threshold);
  const double root = std::sqrt(std::max(0.0, a * (threshold * threshold) - squared_cross(r, w)));
  if (root == 0.0 && a > 0.0) {  // an instant of contact
    const double contact = std::clamp(-b / a, 0.0, duration);
    return {contact, contact};
  }
  double begins = 0.0;
  double ends = duration;
  if (b <= 0.0) {
    const double q = root - b;
    if (q > 0.0) {  // a > 0 as well
      begins = c / q;
      ends = q / a;
    } else if (a > 0.0) {
      ends = 0.0;  // touching now
    }
  } else {
    ends = c / (-b - root);  // already moving apart
  }
  begins = std::clamp(begins, 0.0, duration);
  return {begins, std::clamp(ends, begins, duration)};
}

template Nearness closest_within(const RelativeMotion<4>&, const TimeSpan&);
template TimeSpan time_closer(const RelativeMotion<1>&, double, double);
template TimeSpan time_closer(const RelativeMotion<4>&, double, double);

}  // namespace beespace::motion
