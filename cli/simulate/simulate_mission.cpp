#include "cli/simulate/simulate_mission.hpp"

#include "analysis/text/unit_notes.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/input/obstacle_file.hpp"
#include "cli/simulate/simulate_scenarios.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/number_text.hpp"
#include "io/load_plans.hpp"

#include <beespace/nearest.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace beespace::cli {
namespace {

// Who is not farther away than rounding allows for is too close.
constexpr double kWithRounding = 1.0 + 1e-7;

// What is wrong with where bees are, blamed on who says so: the file, or the options.
Error misplaced(const SimulateRequest& request, std::string what) {
  if (!request.from_file) return simulate_error(std::move(what));
  return {ErrorCode::kMalformedRecord, std::move(what), {io::source_name(request.scenario)}};
}

// An option that the file makes void is a misunderstanding.
Status check_limits(const SimulateRequest& request, const io::FlightPlans& plans) {
  const auto tells = [](const char* option, const char* what) {
    return simulate_error(std::string(option) + " does not apply: the file tells the greatest " +
                          what + " of each bee; leave it out");
  };
  if (request.speed_given && !plans.max_speeds_mps.empty()) return tells("--speed", "speed");
  if (request.acceleration_given && !plans.max_accelerations_mps2.empty()) {
    return tells("--acceleration", "acceleration");
  }
  return std::monostate{};
}

Result<MissionToFly> mission_of_file(const SimulateRequest& request) {
  auto plans = io::load_flight_plans(request.scenario, io::PlanNeed::kGoals);
  if (!plans) return plans.error();
  if (const Status fit = check_limits(request, *plans); !fit) return fit.error();
  MissionToFly flown;
  flown.mission.limits = io::limits_of(*plans, request.loop.limits);
  flown.mission.starts = std::move(plans->positions);
  flown.mission.goals = std::move(plans->goals);
  if (plans->has_ids) flown.names.ids = std::move(plans->ids);
  flown.notes = std::move(plans->notes);
  for (const io::UnitTaken& taken : plans->units) {
    if (taken.evidence == io::UnitEvidence::kNamed) flown.notes.push_back(analysis::text_of(taken));
  }
  if (!plans->velocities.empty()) {
    flown.notes.emplace_back("the velocities of the file are not used: all bees begin at rest");
  }
  return flown;
}

Status add_obstacles(const std::string& file, MissionToFly& flown) {
  const auto map = load_obstacle_map(file);
  if (!map) return map.error();
  flown.names.obstacles_file = io::source_name(file);
  const auto obstacles = map->obstacles();
  std::copy(obstacles.begin(), obstacles.end(), std::back_inserter(flown.mission.obstacles));
  return std::monostate{};
}

// What is said of bees at their starts, or at their goals: of two, and of one.
struct PlaceWords {
  const char* two;
  const char* one;
};

// Of starts, or of goals. In scenarios nearly never; for two on a sphere they cannot help it.
Status check_apart(const SimulateRequest& request, const FlightNames& names,
                   const std::vector<Point>& places, const PlaceWords& words) {
  if (places.size() < 2) return std::monostate{};
  const double threshold_m = request.loop.advice.threshold_m;
  const auto closest = find_closest_pair(places);
  if (!closest) return closest.error();
  if (!*closest || (*closest)->distance_m >= threshold_m * kWithRounding) return std::monostate{};
  std::string who = "two bees";
  if (request.from_file) {
    who = "the bees '" + names.bee((*closest)->first) + "' and '" + names.bee((*closest)->second) +
          "'";
  }
  return misplaced(request, who + " " + words.two + " " +
                                io::length_below(threshold_m, (*closest)->distance_m) +
                                " apart, and the threshold is " + io::exact(threshold_m) + " m; " +
                                (request.from_file ? "correct the file, or give a smaller "
                                                     "--threshold"
                                                   : "give a larger --spacing"));
}

Status check_clear(const SimulateRequest& request, const FlightNames& names, const ObstacleMap& map,
                   const std::vector<Point>& places, const PlaceWords& words) {
  const double clear_m = request.loop.advice.clearance_m * kWithRounding;
  for (std::size_t bee = 0; bee < places.size(); ++bee) {
    const auto nearest = map.nearest(places[bee], clear_m);
    if (!nearest || nearest->surface.distance_m >= clear_m) continue;
    const double distance_m = nearest->surface.distance_m;
    const std::string obstacle =
        names.obstacle(nearest->obstacle, map.obstacles()[nearest->obstacle]);
    std::string text = "the bee '" + names.bee(static_cast<PointId>(bee)) + "' ";
    text.append(words.one).append(" ");
    if (distance_m < 0.0) {
      text.append("inside ").append(obstacle).append("; move one of the two");
    } else {
      text.append(io::length_below(request.loop.advice.clearance_m, distance_m))
          .append(" from ")
          .append(obstacle);
      text.append(", and the clearance is ").append(io::exact(request.loop.advice.clearance_m));
      text.append(" m; move one of the two, or give another --clearance");
    }
    return misplaced(request, std::move(text));
  }
  return std::monostate{};
}

// Each bee begins and stops clear of all others and of obstacles.
Status check_places(const SimulateRequest& request, const MissionToFly& flown) {
  const auto map = ObstacleMap::of(flown.mission.obstacles);
  if (!map) return map.error();
  const auto check = [&](const std::vector<Point>& places, const PlaceWords& words) {
    Status checked = check_apart(request, flown.names, places, words);
    return checked ? check_clear(request, flown.names, *map, places, words) : checked;
  };
  Status starts = check(flown.mission.starts, {"begin", "begins"});
  return starts ? check(flown.mission.goals, {"want to stop", "wants to stop"}) : starts;
}

}  // namespace

double least_spacing_m(const SimulateRequest& request) {
  const double threshold_m = request.loop.advice.threshold_m;
  if (!request.has_fleet) return threshold_m * kRoom;
  const auto tube = stated_tube(request.fleet);
  const double free_m = std::max(threshold_m, 2.0 * request.fleet.most_radius_m);
  return (free_m + (tube ? 2.0 * tube->radius_m : 0.0)) * kRoom;
}

Result<MissionToFly> mission_to_fly(const SimulateRequest& request) {
  MissionToFly flown;
  if (request.from_file) {
    auto loaded = mission_of_file(request);
    if (!loaded) return loaded.error();
    flown = std::move(loaded).value();
  } else {
    const double clear_m = least_spacing_m(request);
    const double spacing_m = std::max(request.spacing_m, clear_m);
    flown.mission = mission_of(request.scenario, {request.bees, spacing_m, clear_m, request.seed});
    flown.names.scenario_obstacles = flown.mission.obstacles.size();
  }
  if (!request.obstacles.empty()) {
    if (const Status added = add_obstacles(request.obstacles, flown); !added) return added.error();
  }
  if (const Status placed = check_places(request, flown); !placed) return placed.error();
  return flown;
}

}  // namespace beespace::cli
