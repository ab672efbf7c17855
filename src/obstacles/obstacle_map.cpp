#include "obstacles/obstacle_map.hpp"

#include "obstacles/validate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace beespace {

ObstacleMap::State::State(std::vector<Obstacle> obstacles) : obstacles_(std::move(obstacles)) {
  using obstacles::Extent;
  std::vector<Extent> extents;
  std::vector<ConvexPiece> pieces;
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    solids_.push_back(obstacles::solid_of(obstacles_[i]));
    extents.push_back(extent_of(solids_[i]));
    append_pieces(solids_[i], i, pieces);
  }
  tree_of_solids_ = obstacles::ExtentTree(extents);
  extents.clear();
  for (const ConvexPiece& piece : pieces) extents.push_back(piece.extent());
  tree_of_pieces_ = obstacles::ExtentTree(extents);
  pieces_.reserve(pieces.size());
  for (const std::uint32_t i : tree_of_pieces_.order()) pieces_.push_back(std::move(pieces[i]));
}

std::optional<NearestObstacle> ObstacleMap::State::nearest(const Vector3& place,
                                                           double within) const {
  std::optional<NearestObstacle> best;
  // Inside one obstacle another may be deeper, so all that the place lies in are looked at.
  const auto reach = [&] { return std::max(best ? best->surface.distance_m : within, 0.0); };
  tree_of_solids_.visit_nearest_first(place, reach(), [&](std::uint32_t i) {
    const std::size_t obstacle = tree_of_solids_.order()[i];
    const NearestSurface surface = facing_of(solids_[obstacle], place).surface;
    const double distance = surface.distance_m;
    const bool better =
        !best ? distance <= within
              : distance < best->surface.distance_m ||
                    (distance == best->surface.distance_m && obstacle < best->obstacle);
    if (better) best = {obstacle, surface};
    return reach();
  });
  return best;
}

std::optional<ObstacleContact> ObstacleMap::State::first_contact(const obstacles::Flight& flight,
                                                                 double horizon) const {
  const Vector3 half_way = flight.velocity * (0.5 * horizon);
  const Vector3 middle = flight.from + half_way;
  const double rounding = 0x1p-48 * (length(flight.from) + length(half_way) + flight.radius);
  std::optional<ObstacleContact> first;
  visit_near(middle, length(half_way) + flight.radius + rounding, [&](const ConvexPiece& piece) {
    const auto contact = obstacles::first_contact(piece, flight, first ? first->begins_s : horizon);
    if (!contact) return;
    const bool sooner = !first || *contact < first->begins_s || piece.obstacle() < first->obstacle;
    if (sooner) first = {piece.obstacle(), *contact};
  });
  return first;
}

ObstacleMap::ObstacleMap() : state_(std::make_shared<const State>(std::vector<Obstacle>{})) {
}
ObstacleMap::~ObstacleMap() = default;
ObstacleMap::ObstacleMap(const ObstacleMap&) = default;
ObstacleMap& ObstacleMap::operator=(const ObstacleMap&) = default;

Result<ObstacleMap> ObstacleMap::of(std::vector<Obstacle> obstacles) {
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    auto error = obstacles::check(obstacles[i]);
    if (!error) continue;
    error->location.array = "obstacles";
    error->location.record = i;
    return *std::move(error);
  }
  ObstacleMap map;
  map.state_ = std::make_shared<const State>(std::move(obstacles));
  return map;
}

std::span<const Obstacle> ObstacleMap::obstacles() const {
  return state_->obstacles();
}

Result<std::optional<ObstacleContact>> ObstacleMap::first_contact(const Mover& ball,
                                                                  double radius_m,
                                                                  double horizon_s) const {
  if (auto error = obstacles::check(ball, radius_m, horizon_s)) return *std::move(error);
  return state_->first_contact(
      {core::vector_of(ball.position), core::vector_of(ball.velocity), radius_m}, horizon_s);
}

std::optional<NearestObstacle> ObstacleMap::nearest(const Point& point, double within_m) const {
  for (const double coordinate : {point.x, point.y, point.z}) {
    if (!(std::abs(coordinate) <= kLargestInMotion)) return std::nullopt;
  }
  return state_->nearest(core::vector_of(point), within_m);
}

}  // namespace beespace
