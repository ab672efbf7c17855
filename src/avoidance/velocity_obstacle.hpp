// Velocities with which a bee comes too close to another one, if both fly straight on: a cone, cut
// off at the horizon. The way out of it is the shortest change of the velocity between the two.
//
// van den Berg, Guy, Lin, Manocha: Reciprocal n-body collision avoidance (2011), in space.
#pragma once

#include "avoidance/half_spaces.hpp"

#include <cmath>

namespace beespace::avoidance {

struct VelocityObstacle {
  Vector3 place;     // of the other one, from the bee
  Vector3 velocity;  // of the bee, seen from the other one
  double apart;      // to be kept
  double horizon_s;
  double step_s;  // who is too close already shall be out of it by then

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
    // Out of the cone, away from its axis; who is on it turns right.
    const double along = dot(velocity, axis);
    const Vector3 across = velocity - axis * along;
    const double off = length(across);
    const Vector3 outward = off > 1e-9 * length(velocity) ? across * (1.0 / off) : right_of(axis);
    const double cosine = std::sqrt(1.0 - sine * sine);
    return {outward * cosine - axis * sine, along * sine - off * cosine};
  }

  // At right angles to a direction, level; of one that is upright, any.
  static Vector3 right_of(const Vector3& direction) {
    const double level = std::hypot(direction.x, direction.y);
    if (!(level > 1e-6)) return {1.0, 0.0, 0.0};
    return Vector3{direction.y, -direction.x, 0.0} * (1.0 / level);
  }

 private:
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

// What a bee's velocity keeps to that takes a share of the change on itself.
inline HalfSpace half_space_of(const VelocityObstacle& obstacle, const Vector3& velocity,
                               double share) {
  const auto [normal, change] = obstacle.way_out();
  return {normal, dot(normal, velocity) + share * change};
}

}  // namespace beespace::avoidance
