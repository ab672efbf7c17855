// What an ObstacleMap holds: obstacles, the convex pieces that they consist of, and trees of both.
#pragma once

#include "obstacles/convex_piece.hpp"
#include "obstacles/extent_tree.hpp"
#include "obstacles/first_contact.hpp"

#include <beespace/obstacle.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace beespace {

class __attribute__((visibility("hidden"))) ObstacleMap::State {
 public:
  using ConvexPiece = obstacles::ConvexPiece;
  using Vector3 = core::Vector3;

  // All of them are good (see validate.hpp).
  explicit State(std::vector<Obstacle> obstacles);

  [[nodiscard]] const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  [[nodiscard]] bool empty() const { return obstacles_.empty(); }
  [[nodiscard]] std::optional<NearestObstacle> nearest(const Vector3& place, double within) const;

  // Of one of them, all its pieces together.
  [[nodiscard]] obstacles::Facing facing(std::size_t obstacle, const Vector3& place) const {
    return facing_of(solids_[obstacle], place);
  }
  [[nodiscard]] std::optional<ObstacleContact> first_contact(const obstacles::Flight& flight,
                                                             double horizon) const;

  // Calls visit(const ConvexPiece&) for all pieces within reach of the center, and perhaps for
  // some that are not; in an order that depends on the map only. Allocates nothing.
  template <class Visit>
  void visit_near(const Vector3& center, double reach_m, Visit&& visit) const {
    tree_of_pieces_.visit_near(center, reach_m, [&](std::uint32_t i) { visit(pieces_[i]); });
  }

 private:
  std::vector<Obstacle> obstacles_;
  std::vector<obstacles::Solid> solids_;  // one for each
  obstacles::ExtentTree tree_of_solids_;
  std::vector<ConvexPiece> pieces_;  // in the order of their tree
  obstacles::ExtentTree tree_of_pieces_;
};

}  // namespace beespace
