// A velocity obstacle: the velocities with which a bee comes too close to another one if both fly
// straight on. It is a cone, cut off at the horizon. The way out is the smallest change of the
// relative velocity that leaves it.
//
// van den Berg, Guy, Lin, Manocha: Reciprocal n-body collision avoidance (2011), in space.
#pragma once

#include "avoidance/constraints/half_spaces.hpp"
#include "avoidance/constraints/sideways.hpp"

#include <cmath>

namespace beespace::avoidance {

struct VelocityObstacle {
  Vector3 place;     // of the other one, from the bee
  Vector3 velocity;  // of the bee, seen from the other one
  double apart;      // to be kept
  double horizon_s;
  double step_s;  // an agent that is too close already shall be out of it by then

  struct WayOut {
    Vector3 normal;
    double change;  // along the normal; below zero: that much is free
  };
  [[nodiscard]] WayOut way_out() const {
    const double distance = length(place);
    if (distance <= apart) return out_of_ball(step_s);
    const Vector3 axis = place * (1.0 / distance);
    const Vector3 from_cut = velocity - place * (1.0 / horizon_s);
    const double behind = dot(from_cut, axis);
    const double sine = apart / distance;
    if (behind < 0.0 && behind * behind > sine * sine * dot(from_cut, from_cut)) {
      return out_of_ball(horizon_s);
    }
    // Out of the cone, away from its axis; a velocity on the axis turns right.
    const Vector3 across = velocity - axis * dot(velocity, axis);
    const double off = length(across);
    return out_of_cone(axis, off > 1e-9 * length(velocity) ? across * (1.0 / off) : right_of(axis));
  }

  // The same with a greatest speed: where it is too low, another way out of the cone may do. An
  // agent with the velocity `own` then crosses in front of the other one, above it, below it, or
  // behind it.
  [[nodiscard]] WayOut way_out_within(const Vector3& own, double max_speed) const {
    constexpr double kEase = 0.9;  // an agent that barely can gets there too late
    const WayOut shortest = way_out();
    const auto is_able = [&](const WayOut& way) {
      return dot(way.normal, own) + way.change <= kEase * max_speed;
    };
    const double distance = length(place);
    if (is_able(shortest) || distance <= apart) return shortest;
    const Vector3 axis = place * (1.0 / distance);
    const Vector3 across = shortest.normal - axis * dot(shortest.normal, axis);
    const double far = length(across);
    if (!(far > 0.0)) return shortest;
    const Vector3 outward = across * (1.0 / far);
    const Vector3 beside = cross(axis, outward);
    WayOut best = shortest;
    bool found = false;
    for (const Vector3& other : {beside, -beside, -outward}) {
      const WayOut way = out_of_cone(axis, other);
      if (!is_able(way) || (found && way.change >= best.change)) continue;
      best = way;
      found = true;
    }
    return best;
  }

  // For two that are too close: straight away from each other, fast enough to be apart after a
  // step. The nearer the two are, the more the cone's way out agrees with it; ways out of the ball
  // of the step may lead through its centre.
  [[nodiscard]] WayOut away() const {
    const double distance = length(place);
    const Vector3 axis = distance > 0.0 ? place * (1.0 / distance) : Vector3{-1.0, 0.0, 0.0};
    return {-axis, dot(velocity, axis) + (apart - distance) / step_s};
  }
  [[nodiscard]] bool is_too_close() const { return length(place) <= apart; }

 private:
  // Through the side of the cone in a direction at right angles to its axis.
  [[nodiscard]] WayOut out_of_cone(const Vector3& axis, const Vector3& outward) const {
    const double sine = apart / length(place);
    const double cosine = std::sqrt(1.0 - sine * sine);
    return {outward * cosine - axis * sine,
            dot(velocity, axis) * sine - dot(velocity, outward) * cosine};
  }

  [[nodiscard]] WayOut out_of_ball(double within_s) const {
    const Vector3 from_middle = velocity - place * (1.0 / within_s);
    const double off = length(from_middle);
    const double radius = apart / within_s;
    if (off > 1e-9 * radius) return {from_middle * (1.0 / off), radius - off};
    const double distance = length(place);
    const Vector3 away = distance > 0.0 ? place * (-1.0 / distance) : Vector3{1.0, 0.0, 0.0};
    return {away, radius};
  }
};

// The half-space of velocities for a bee that takes a share of the change on itself.
inline HalfSpace half_space_of(const VelocityObstacle::WayOut& out, const Vector3& velocity,
                               double share) {
  return {out.normal, dot(out.normal, velocity) + share * out.change};
}

}  // namespace beespace::avoidance
