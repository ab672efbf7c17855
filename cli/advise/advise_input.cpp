#include "cli/advise/advise_input.hpp"

#include "cli/input/obstacle_file.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/load_plans.hpp"

#include <cstddef>
#include <utility>

namespace beespace::cli {
namespace {

// Without velocities all bees stand.
std::vector<Mover> movers_of(const io::FlightPlans& plans) {
  std::vector<Mover> movers(plans.positions.size());
  for (std::size_t i = 0; i < movers.size(); ++i) {
    movers[i].position = plans.positions[i];
    if (!plans.velocities.empty()) movers[i].velocity = plans.velocities[i];
  }
  return movers;
}

// An option that the file makes void is a misunderstanding.
Status check_limits(const AdviseRequest& request, const io::FlightPlans& plans) {
  const auto tells = [](const char* option, const char* what) {
    return advise_error(std::string(option) + " does not apply: the file tells the greatest " +
                        what + " of each bee; leave it out");
  };
  if (request.speed_given && !plans.max_speeds_mps.empty()) return tells("--speed", "speed");
  if (request.acceleration_given && !plans.max_accelerations_mps2.empty()) {
    return tells("--acceleration", "acceleration");
  }
  return std::monostate{};
}

Status load_bees(const AdviseRequest& request, Situation& situation) {
  auto plans = io::load_flight_plans(request.input, io::PlanNeed::kGoalsOrPreferred);
  if (!plans) return plans.error();
  if (Status fit = check_limits(request, *plans); !fit) return fit;
  situation.movers = movers_of(*plans);
  situation.limits = io::limits_of(*plans, request.limits);
  situation.own_limits = !situation.limits.empty();
  if (!situation.own_limits) situation.limits = {request.limits};
  situation.format_description = std::move(plans->format_description);
  situation.units = std::move(plans->units);
  situation.notes = std::move(plans->notes);
  situation.wishes = !plans->preferred.empty();
  if (situation.wishes) {
    if (!plans->goals.empty())
      situation.notes.emplace_back("goals are ignored, as there are preferred velocities");
    situation.preferred = std::move(plans->preferred);
  } else {
    for (std::size_t i = 0; i < situation.movers.size(); ++i) {
      const FlightLimits& limits = situation.limits[situation.own_limits ? i : 0];
      const auto wish = velocity_to_goal(situation.movers[i].position, plans->goals[i], limits,
                                         request.advice.step_s);
      if (!wish) {
        Error error = wish.error();
        error.location.record = i;
        return error;
      }
      situation.preferred.push_back(*wish);
    }
  }
  if (plans->velocities.empty()) situation.notes.emplace_back("no velocities: all bees stand");
  if (plans->has_ids) situation.names.ids = std::move(plans->ids);
  return std::monostate{};
}

Status load_obstacles(const std::string& file, Situation& situation) {
  auto map = load_obstacle_map(file);
  if (!map) return std::move(map).error();
  situation.obstacles = *map;
  situation.names.obstacles_file = io::source_name(file);
  return std::monostate{};
}

Status load_intruders(const std::string& file, Situation& situation) {
  auto plans = io::load_flight_plans(file, io::PlanNeed::kNothing);
  if (!plans) return plans.error();
  situation.intruders = movers_of(*plans);
  if (situation.intruders.empty()) {
    situation.notes.push_back(io::source_name(file) + " has no intruders");
  } else if (plans->velocities.empty()) {
    situation.notes.push_back(io::source_name(file) + " has no velocities: intruders stand");
  }
  for (io::UnitTaken& taken : plans->units) {
    taken.of += " of intruders";
    situation.units.push_back(std::move(taken));
  }
  if (plans->has_ids) situation.intruder_names.ids = std::move(plans->ids);
  return std::monostate{};
}

}  // namespace

AdviseOptions Situation::options_for(const AdviseRequest& request) const {
  AdviseOptions options = request.advice;
  if (!obstacles.obstacles().empty()) options.obstacles = &obstacles;
  options.intruders = intruders;
  return options;
}

Result<Situation> load_situation(const AdviseRequest& request) {
  Situation situation;
  if (Status loaded = load_bees(request, situation); !loaded) return std::move(loaded).error();
  if (!request.obstacles.empty()) {
    if (Status loaded = load_obstacles(request.obstacles, situation); !loaded) {
      return std::move(loaded).error();
    }
  }
  if (!request.intruders.empty()) {
    if (Status loaded = load_intruders(request.intruders, situation); !loaded) {
      return std::move(loaded).error();
    }
  }
  return situation;
}

}  // namespace beespace::cli
