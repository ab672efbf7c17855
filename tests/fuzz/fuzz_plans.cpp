// Fuzzes what missions and advice are read from: tables of flight plans, and obstacles in JSON.
//
// The first byte chooses which, the rest is the input. Beyond the sanitizers, it checks what must
// hold for any input: a table tells of every bee what it has columns for, all numbers are in the
// motion domain, limits are above zero and ids differ; obstacles have finite numbers.
#include "io/frames/track_domain.hpp"
#include "io/load_obstacles.hpp"
#include "io/load_plans.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <unordered_set>
#include <variant>
#include <vector>

namespace beespace::io {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

template <class Vector>
void check_vectors(const std::vector<Vector>& vectors, std::size_t bees) {
  require(vectors.empty() || vectors.size() == bees);
  for (const Vector& v : vectors) {
    require(in_motion_domain(v.x) && in_motion_domain(v.y) && in_motion_domain(v.z));
  }
}

void check_limits(const std::vector<double>& limits, std::size_t bees) {
  require(limits.empty() || limits.size() == bees);
  for (const double limit : limits) require(limit > 0.0 && in_motion_domain(limit));
}

void check_plans(const FlightPlans& plans, PlanNeed need) {
  const std::size_t bees = plans.ids.size();
  require(bees > 0 && plans.positions.size() == bees);
  require(!plans.goals.empty() ||
          (need == PlanNeed::kGoalsOrPreferred && !plans.preferred.empty()));
  check_vectors(plans.positions, bees);
  check_vectors(plans.velocities, bees);
  check_vectors(plans.goals, bees);
  check_vectors(plans.preferred, bees);
  check_limits(plans.max_speeds_mps, bees);
  check_limits(plans.max_accelerations_mps2, bees);
  const std::unordered_set<std::string> ids(plans.ids.begin(), plans.ids.end());
  require(ids.size() == bees);
}

void check_obstacle(const Obstacle& obstacle) {
  if (const auto* sphere = std::get_if<Sphere>(&obstacle)) {
    require(in_motion_domain(sphere->center.x) && in_motion_domain(sphere->radius_m));
  } else if (const auto* box = std::get_if<Box>(&obstacle)) {
    require(in_motion_domain(box->low.z) && in_motion_domain(box->high.x));
  } else if (const auto* cylinder = std::get_if<UprightCylinder>(&obstacle)) {
    require(in_motion_domain(cylinder->x) && in_motion_domain(cylinder->y));
    require(!std::isnan(cylinder->heights.low_m) && !std::isnan(cylinder->heights.high_m));
  } else if (const auto* prism = std::get_if<UprightPrism>(&obstacle)) {
    for (const Corner& corner : prism->outline) {
      require(in_motion_domain(corner.x) && in_motion_domain(corner.y));
    }
  }
}

}  // namespace
}  // namespace beespace::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beespace::io;
  if (size == 0) return 0;
  const std::string_view content(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 3 == 2) {
    const auto obstacles = load_obstacles_from_memory(content, "fuzz");
    if (!obstacles) return 0;
    for (const beespace::Obstacle& obstacle : *obstacles) check_obstacle(obstacle);
    return 0;
  }
  const PlanNeed need = data[0] % 3 == 1 ? PlanNeed::kGoalsOrPreferred : PlanNeed::kGoals;
  const auto plans = load_flight_plans_from_memory(content, "fuzz", need);
  if (plans) check_plans(*plans, need);
  return 0;
}
