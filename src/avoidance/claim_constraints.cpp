// The constraints of two claims on each other, and of fences.
#include "avoidance/constraint_builder.hpp"
#include "avoidance/constraints/hull_obstacle_separation.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::avoidance {

// Whether two agents keep apart whatever both do in this step, and neither presses the other: their
// capsules tell, and the balls around their stops. Most pairs need nothing more. Both find the
// same.
bool ConstraintBuilder::keep_apart_anyhow(PointId one, PointId another) const {
  const auto [bee, other] = std::minmax(one, another);
  const Claims& claims = agents_.claims();
  const Hull first = claims.hull(bee);
  const Hull second = claims.hull(other);
  const Vector3 between = closest_points(first.axis, second.axis).between();
  const double far = length(between);
  if (!(far > 0.0)) return false;
  const Vector3 normal = between * (1.0 / far);
  const auto ends_at = [&](const Hull& hull, PointId of, const Vector3& n) {
    return std::min(dot(n, hull.axis.from) - hull.beside_m,
                    dot(n, hull.axis.at(1.0)) - std::max(hull.beside_m, agents_.strays(of)));
  };
  const double gap_m = ends_at(first, bee, normal) + ends_at(second, other, -normal);
  const double free_m = claims.between(bee, other).along(normal);
  // A little more than is kept, for the rounding of the capsules.
  const double apart_m = agents_.apart_by(free_m, bee, other).kept_m * (1.0 + 1e-6);
  if (gap_m < apart_m) return false;
  return gap_m >= apart_m + kPresses * agents_.apart().kept_m || !(is_idle(bee) || is_idle(other));
}

// The one of the lower id is the first.
HullSeparation ConstraintBuilder::separation_of_claims(PointId bee, PointId other) const {
  const auto [first, second] = std::minmax(bee, other);
  const Claims& claims = agents_.claims();
  const FreeBetween between = claims.between(first, second);
  const double widest_m = between.shape.widest(between.horizontal_m) + between.beyond_m;
  const double spare_m = agents_.apart_by(widest_m, first, second).kept_m - widest_m;
  return separate(claims.hull(first), claims.hull(second), between, planes_.normal(first, second),
                  spare_m);
}

// Whether the remembered plane certifies a pair; then the best one does, too.
bool ConstraintBuilder::is_certified_by_memory(PointId bee, PointId other) const {
  const auto [first, second] = std::minmax(bee, other);
  const Vector3 normal = planes_.normal(first, second);
  if (normal == Vector3{}) return false;
  const Claims& claims = agents_.claims();
  const double gap_m = claims.hull(first).lowest(normal) - claims.hull(second).highest(normal);
  const double free_m = claims.between(first, second).along(normal);
  // The best one is compared with what it keeps itself: with as much left, or more.
  const SeparationMargins margins = agents_.apart_by(free_m, first, second);
  return gap_m >= margins.kept_m + (margins.kept_m - margins.asked_m);
}

bool ConstraintBuilder::is_claim_too_close(PointId bee, PointId other) const {
  const FreeBetween between = agents_.claims().between(bee, other);
  const double widest_m = between.shape.widest(between.horizontal_m) + between.beyond_m;
  const double certified_m = agents_.apart_by(widest_m, bee, other).certified_m;
  if (!agents_.ways_may_be_within(bee, other, certified_m)) return false;
  if (is_certified_by_memory(bee, other) || keep_apart_anyhow(bee, other)) return false;
  const HullSeparation found = separation_of_claims(bee, other);
  return found.plane.gap < agents_.apart_by(found.free_m, bee, other).certified_m;
}

void ConstraintBuilder::look_at_claim(PointId bee, PointId other, Findings& findings) const {
  if (keep_apart_anyhow(bee, other)) return;
  const auto [plane, free_m] = separation_of_claims(bee, other);
  const auto [asked_m, kept_m, certified_m] = agents_.apart_by(free_m, bee, other);
  Constraints& constraints = findings.constraints;
  const bool is_first = bee < other;
  planes_.remember(bee, other, plane.normal);
  const double lean = is_first ? leaves_to(bee, other) : leaves_to(other, bee);
  const HalfSpace side = is_first ? plane.of_first(kept_m, lean) : plane.of_second(kept_m, lean);
  const bool certified = plane.gap >= certified_m;
  findings.pressed = findings.pressed + pressure(other, side.normal, plane.gap - kept_m, certified);
  if (certified && is_kept_anyhow(bee, side)) return;
  constraints.hard.push_back(side);
  if (certified) return;
  findings.certified = false;
  const double share = agents_.claims().holds(other) ? 1.0 : 0.5;
  constraints.separation_requests.push_back(
      {constraints.hard.size() - 1, share * (kept_m - plane.gap)});
  if (is_first) {
    findings.too_close.push_back(
        {{bee, other}, plane.gap - agents_.claims().tubes_m(bee, other), 0.0});
  }
}

void ConstraintBuilder::look_at_fences(PointId bee, Findings& findings) const {
  const SeparationMargins margins = agents_.clearance(bee);
  for (std::size_t k = 0; k < options_.fences.size(); ++k) {
    const Fence& fence = options_.fences[k];
    const Vector3 inward = core::vector_of(fence.inward);
    const double per_length = 1.0 / length(inward);
    const Vector3 normal = inward * per_length;
    const double edge = fence.offset_m * per_length;
    const double gap_m = lowest_of(bee, normal) - edge;
    keep_to(bee, {normal, edge + std::min(margins.kept_m, gap_m)}, gap_m, margins, findings);
    if (gap_m < margins.certified_m) findings.near_fence.push_back({bee, k, gap_m});
  }
}

ObstacleSeparation ConstraintBuilder::separation_of_piece(PointId bee,
                                                          const obstacles::ConvexPiece& piece,
                                                          Findings& findings) const {
  std::vector<Vector3>& remembered = findings.remembered;
  remembered.clear();
  for (const auto& [obstacle, normal] : planes_.walls(bee)) {
    if (obstacle == piece.obstacle()) remembered.push_back(normal);
  }
  const ObstacleSeparation found =
      separate(agents_.claims().hull(bee), piece, remembered, agents_.clearance(bee).kept_m);
  planes_.remember_wall(bee, {piece.obstacle(), found.normal});
  return found;
}

// Between a bee and a ball, around which a sphere is to stay free.
SeparatingPlane ConstraintBuilder::plane_to(PointId bee, const Segment& middle,
                                            double enough_m) const {
  if (!agents_.claims().any()) return separate(agents_.stopping_segment(bee), middle, enough_m);
  const Hull ball{{&middle.from, 1}, middle};
  const FreeBetween between{{}, enough_m, 0.0, options_.planar};
  return separate(agents_.claims().hull(bee), ball, between, {}, 0.0).plane;
}

double ConstraintBuilder::lowest_of(PointId bee, const Vector3& normal) const {
  if (agents_.claims().any()) return agents_.claims().hull(bee).lowest(normal);
  const Segment& way = agents_.stopping_segment(bee);
  return std::min(dot(normal, way.from), dot(normal, way.at(1.0)));
}

}  // namespace beespace::avoidance
