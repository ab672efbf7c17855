#include "obstacles/first_contact.hpp"

#include "obstacles/validate.hpp"

#include <beespace/obstacle.hpp>

#include <cmath>
#include <vector>

namespace beespace::obstacles {

namespace {

double sum_of(const Vector3& a) {
  return std::abs(a.x) + std::abs(a.y) + std::abs(a.z);
}

}  // namespace

// Newton's method from the left. Along a straight line the distance to a convex set is a convex
// function of time, so the plane at the nearest place, beyond which nothing of the piece is, is
// not reached later than the piece: the ball can be let fly until there, again and again. Whatever
// was rounded in the normal, the plane is put where the piece ends along it.
std::optional<double> first_contact(const ConvexPiece& piece, const Flight& flight,
                                    double horizon) {
  // Distance times slope falls to a quarter at least with each step, so that this many are enough
  // from any distance in the domain down to its rounding.
  constexpr int kMostSteps = 400;
  const double always = sum_of(flight.from) + piece.size() + flight.radius;
  double time = 0.0;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vector3 at = flight.from + flight.velocity * time;
    const Facing facing = piece.facing(at);
    const double rounding =
        0x1p-49 * (always + sum_of(at) + sum_of(vector_of(facing.surface.point)));
    if (facing.surface.distance_m <= flight.radius + 2.0 * rounding) return time;
    const double gap =
        dot(facing.normal, at) - piece.support(facing.normal) - flight.radius - rounding;
    const double closing = -dot(facing.normal, flight.velocity);
    // A slope that rounds to none would not close more than the rounding on any way to the piece.
    if (!(closing > 0.0)) return std::nullopt;
    const double next = time + gap / closing;
    if (!(next <= horizon)) return std::nullopt;
    // Nearer than the numbers can tell.
    if (!(next > time)) return time;
    time = next;
  }
  return time;
}

}  // namespace beespace::obstacles

namespace beespace {

Result<std::optional<double>> first_contact_s(const Obstacle& obstacle, const Mover& ball,
                                              double radius_m, double horizon_s) {
  if (auto error = obstacles::check(obstacle)) return *std::move(error);
  if (auto error = obstacles::check(ball, radius_m, horizon_s)) return *std::move(error);
  std::vector<obstacles::ConvexPiece> pieces;
  append_pieces(obstacles::solid_of(obstacle), 0, pieces);
  const obstacles::Flight flight{core::vector_of(ball.position), core::vector_of(ball.velocity),
                                 radius_m};
  std::optional<double> first;
  for (const obstacles::ConvexPiece& piece : pieces) {
    const auto contact = first_contact(piece, flight, first.value_or(horizon_s));
    if (contact) first = contact;
  }
  return first;
}

}  // namespace beespace
