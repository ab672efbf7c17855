// Builds the constraints on one bee in a step, from other bees, obstacles, fences, intruders, and
// bees of which only a ball is known.
#pragma once

#include "avoidance/agent_states.hpp"
#include "avoidance/constraints/constraints.hpp"
#include "avoidance/constraints/hull_separation.hpp"
#include "avoidance/constraints/obstacle_separation.hpp"
#include "avoidance/constraints/separating_plane.hpp"
#include "avoidance/remembered_planes.hpp"
#include "avoidance/vicinity.hpp"

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace beespace::avoidance {

class ConstraintBuilder {
 public:
  // `near` has all bees that may meet each other; `too_close` has the marks of mark_too_close()
  // of all bees before any constraints are built. All of these outlive this object.
  ConstraintBuilder(const AgentStates& agents, const Vicinity& near,
                    std::span<const char> too_close, std::span<const Velocity> preferred,
                    const RememberedPlanes& planes, const AdviseOptions& options)
      : agents_(agents),
        near_(near),
        too_close_(too_close),
        preferred_(preferred),
        planes_(planes),
        options_(options) {}

  // Marks a bee and those of higher ids that are too close to each other, or will be when they
  // brake. Of several bees at the same time, too.
  void mark_too_close(PointId bee, std::span<char> marks) const;

  // The results, for one bee after the other.
  struct Findings {
    Constraints constraints;  // of the last one
    Vector3 pressed;          // where others press it, if it is idle
    bool certified;           // of other bees and obstacles
    double clear_of_unknown_s;
    std::vector<std::size_t> inside;  // obstacles that it lies in, ascending
    std::vector<Vector3> remembered;  // normals of one obstacle
    std::vector<TooClose> too_close;  // of all so far
    std::vector<NearObstacle> near_obstacle;
    std::vector<NearFence> near_fence;
    std::vector<NearUnknown> near_unknown;
  };
  void look_at(PointId bee, Findings& findings) const;

  // Whether a bee is at its goal.
  [[nodiscard]] bool is_idle(PointId bee) const { return agents_.is_idle(bee); }
  // Whether an intruder that flies straight on may come too close to a bee within the horizon.
  [[nodiscard]] bool may_come_close(PointId bee, std::size_t k) const;
  // How much more than the threshold is kept from an intruder.
  [[nodiscard]] double intruder_margin_m(std::size_t k) const;

 private:
  [[nodiscard]] SeparatingPlane plane_between(PointId bee, PointId other) const;
  void look_at_bees(PointId bee, Findings& findings) const;
  void look_at_bee(PointId bee, PointId other, Findings& findings) const;
  [[nodiscard]] bool keep_apart_anyhow(PointId one, PointId another) const;
  [[nodiscard]] HullSeparation separation_of_claims(PointId bee, PointId other) const;
  [[nodiscard]] bool is_certified_by_memory(PointId bee, PointId other) const;
  [[nodiscard]] bool is_too_close(PointId bee, PointId other) const;
  [[nodiscard]] bool is_claim_too_close(PointId bee, PointId other) const;
  void look_at_claim(PointId bee, PointId other, Findings& findings) const;
  void look_at_obstacles(PointId bee, Findings& findings) const;
  void look_at_fences(PointId bee, Findings& findings) const;
  [[nodiscard]] double lowest_of(PointId bee, const Vector3& normal) const;
  [[nodiscard]] ObstacleSeparation separation_of_piece(PointId bee,
                                                       const obstacles::ConvexPiece& piece,
                                                       Findings& findings) const;
  void keep_clear(PointId bee, std::size_t obstacle, const ObstacleSeparation& plane,
                  Findings& findings) const;
  void look_at_intruders(PointId bee, Findings& findings) const;
  void look_at_unknown(PointId bee, Findings& findings) const;
  void keep_clear_of_ball(PointId bee, std::size_t unknown, double later_m,
                          Findings& findings) const;
  // Adds a half-space of something that does not move, so that the margin is kept from it.
  void keep_to(PointId bee, const HalfSpace& side, double gap_m, const SeparationMargins& margins,
               Findings& findings) const;
  // Whether no horizontal velocity makes a difference for it, and there are no others.
  [[nodiscard]] bool is_out_of_plane(const HalfSpace& side) const {
    return options_.planar && side.normal.x == 0.0 && side.normal.y == 0.0;
  }
  [[nodiscard]] SeparatingPlane plane_to(PointId bee, const Segment& middle, double enough_m) const;
  [[nodiscard]] bool is_kept_anyhow(PointId bee, const HalfSpace& side) const;
  [[nodiscard]] double leaves_to(PointId first, PointId second) const;
  [[nodiscard]] Vector3 pressure(PointId other, const Vector3& away, double free_m,
                                 bool certified) const;

  const AgentStates& agents_;
  const Vicinity& near_;
  std::span<const char> too_close_;
  std::span<const Velocity> preferred_;
  const RememberedPlanes& planes_;
  const AdviseOptions& options_;
};

}  // namespace beespace::avoidance
