// The true flight of bees, and the closest distance of two: written for these tests alone, in long
// doubles, so that it shares no mistake with the tested code.
//
// In a step a bee changes its velocity evenly, from its present one to its target, as near to that
// as its acceleration allows.
#pragma once

#include <array>
#include <cstddef>

namespace beespace::closed_loop {

using Vector = std::array<long double, 3>;

Vector operator+(const Vector& a, const Vector& b);
Vector operator-(const Vector& a, const Vector& b);
Vector operator*(const Vector& a, long double factor);
long double dot(const Vector& a, const Vector& b);
long double length(const Vector& a);

// One step: from `position` and `velocity` at its begin with a constant acceleration.
struct Stretch {
  Vector position{};
  Vector velocity{};
  Vector acceleration{};
  long double lasts_s = 0;

  [[nodiscard]] Vector position_at(long double passed_s) const;
  [[nodiscard]] Vector velocity_at(long double passed_s) const;
};

// The step that aims at a velocity.
Stretch towards(const Vector& position, const Vector& velocity, const Vector& aim,
                long double lasts_s, long double max_acceleration);

// How close two come in a step that both begin together.
long double closest(const Stretch& a, const Stretch& b);

}  // namespace beespace::closed_loop
