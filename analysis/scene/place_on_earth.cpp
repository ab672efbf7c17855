#include "analysis/scene/place_on_earth.hpp"

#include "io/bytes/number_text.hpp"
#include "io/obstacle_name.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>

namespace beespace::analysis {
namespace {

bool is_near(double x, double y) {
  return std::abs(x) <= kFarthestPlaced_m && std::abs(y) <= kFarthestPlaced_m;
}

bool is_height(double height_m) {
  return height_m >= kLowestHeight_m && height_m <= kGreatestHeight_m;
}

bool is_near(const Point& p) {
  return is_near(p.x, p.y) && is_height(p.z);
}

// As obstacles are given, around x = y = 0.
bool is_near(const Sphere& sphere) {
  const double r = sphere.radius_m;
  return is_near(std::abs(sphere.center.x) + r, std::abs(sphere.center.y) + r);
}
bool is_near(const Box& box) {
  return is_near(box.low.x, box.low.y) && is_near(box.high.x, box.high.y);
}
bool is_near(const Ground&) {
  return true;
}
bool is_near(const UprightCylinder& cylinder) {
  const double r = cylinder.radius_m;
  return is_near(std::abs(cylinder.x) + r, std::abs(cylinder.y) + r);
}
bool is_near(const UprightPrism& prism) {
  return std::all_of(prism.outline.begin(), prism.outline.end(),
                     [](const Corner& corner) { return is_near(corner.x, corner.y); });
}

// Of heights that have an end: where it is.
Heights heights_of(const Sphere& sphere) {
  return {sphere.center.z - sphere.radius_m, sphere.center.z + sphere.radius_m};
}
Heights heights_of(const Box& box) {
  return {box.low.z, box.high.z};
}
Heights heights_of(const Ground&) {
  return {};
}
Heights heights_of(const UprightCylinder& cylinder) {
  return cylinder.heights;
}
Heights heights_of(const UprightPrism& prism) {
  return prism.heights;
}

bool fits(const Obstacle& obstacle, const report::PlacementAxes& axes) {
  const auto has_place = [&](double z) {
    return !std::isfinite(z) || is_height(axes.height_of(z));
  };
  return std::visit(
      [&](const auto& solid) {
        const Heights heights = heights_of(solid);
        return is_near(solid) && has_place(heights.low_m) && has_place(heights.high_m);
      },
      obstacle);
}

Status check_obstacles(const report::SwarmFacts& swarm, const report::PlacementAxes& axes) {
  for (std::size_t i = 0; i < swarm.obstacles.size(); ++i) {
    if (fits(swarm.obstacles[i], axes)) continue;
    return Error{ErrorCode::kOutsideDomain,
                 io::obstacle_name(i, swarm.obstacles[i]) +
                     ", reaches farther than 100 km from the origin, or to no height that there "
                     "is; cut it there, or leave it out",
                 {}};
  }
  return std::monostate{};
}

template <class Visit>
void for_each_place(report::SnapshotFacts& facts, Visit visit) {
  for (Point& place : facts.positions) visit(place);
  if (!facts.ahead) return;
  for (report::ConflictAhead& each : facts.ahead->conflicts) {
    visit(each.first_there);
    visit(each.second_there);
  }
}
template <class Visit>
void for_each_place(report::RecordingFacts& facts, Visit visit) {
  for (Track& track : facts.tracks) {
    for (Fix& fix : track.fixes) visit(fix.position);
  }
}

}  // namespace

std::string placement_text(const report::Placement& placement) {
  return "placed on the Earth at longitude " + io::exact(placement.origin.longitude_deg) +
         ", latitude " + io::exact(placement.origin.latitude_deg) + ", height " +
         io::exact(placement.origin.height_m) + " m, with x towards " +
         io::exact(placement.heading_deg) + " degrees from north and y to its " +
         (placement.y_to_the_right ? "right" : "left") + placement.words;
}

Status place_on_earth(Scene& scene, const report::Placement& placement) {
  if (swarm_of(scene).origin) {
    return Error{ErrorCode::kInvalidArgument,
                 "positions are in degrees, and so are on the Earth already; leave --origin out",
                 {}};
  }
  if (const auto ecef = to_ecef(placement.origin); !ecef) return ecef.error();
  const report::PlacementAxes axes(placement);
  bool near = true;
  std::visit(
      [&](auto& facts) {
        for_each_place(facts, [&](Point& place) {
          place = axes(place);
          near = near && is_near(place);
        });
        facts.swarm.placed = placement;
        facts.swarm.origin = placement.origin;
        facts.swarm.origin->height_m = 0.0;
        facts.swarm.notes.push_back(placement_text(placement));
      },
      scene);
  if (near) return check_obstacles(swarm_of(scene), axes);
  return Error{ErrorCode::kOutsideDomain,
               "a place is farther than 100 km from the origin, or no height that there is; "
               "positions on a map must be metres around --origin",
               {}};
}

}  // namespace beespace::analysis
