#include "tests/closed_loop/flown.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace beespace::closed_loop {

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(const Vector& a, long double factor) {
  return {a[0] * factor, a[1] * factor, a[2] * factor};
}
long double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
long double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}

Vector Stretch::position_at(long double passed_s) const {
  return position + velocity * passed_s + acceleration * (passed_s * passed_s / 2);
}

Vector Stretch::velocity_at(long double passed_s) const {
  return velocity + acceleration * passed_s;
}

Stretch towards(const Vector& position, const Vector& velocity, const Vector& aim,
                long double lasts_s, long double max_acceleration) {
  Vector acceleration = (aim - velocity) * (1 / lasts_s);
  const long double asked = length(acceleration);
  if (asked > max_acceleration) acceleration = acceleration * (max_acceleration / asked);
  return {position, velocity, acceleration, lasts_s};
}

namespace {

// A zero of a function that changes its sign, or the nearer end.
template <class Function>
long double zero_between(const Function& f, long double low, long double high) {
  const bool rises = f(low) < 0;
  for (int halvings = 0; halvings < 100; ++halvings) {
    const long double middle = (low + high) / 2;
    ((f(middle) < 0) == rises ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

// The square of the distance is a polynomial of the fourth degree, its slope one of the third, and
// between the zeros of the slope of that, which are a formula's, the slope has one zero at most.
long double closest(const Stretch& a, const Stretch& b) {
  const Vector p = a.position - b.position;
  const Vector v = a.velocity - b.velocity;
  const Vector c = (a.acceleration - b.acceleration) * 0.5L;
  const auto distance = [&](long double t) { return length(p + v * t + c * (t * t)); };
  const auto slope = [&](long double t) { return dot(p + v * t + c * (t * t), v + c * (2 * t)); };
  std::vector<long double> cuts = {0, a.lasts_s};
  // slope' = v.v + 2 p.c + 6 v.c t + 6 c.c t^2
  const long double square = 6 * dot(c, c);
  const long double linear = 6 * dot(v, c);
  const long double constant = dot(v, v) + 2 * dot(p, c);
  const long double below_root = linear * linear - 4 * square * constant;
  if (square > 0 && below_root >= 0) {
    for (const int sign : {-1, 1}) {
      const long double at =
          (-linear + static_cast<long double>(sign) * std::sqrt(below_root)) / (2 * square);
      if (at > 0 && at < a.lasts_s) cuts.push_back(at);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  long double least = distance(0);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    least = std::min(
        {least, distance(cuts[i + 1]), distance(zero_between(slope, cuts[i], cuts[i + 1]))});
  }
  return least;
}

}  // namespace beespace::closed_loop
