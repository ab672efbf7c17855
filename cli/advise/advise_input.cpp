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

Status load_bees(const AdviseRequest& request, AdviceInput& given) {
  auto plans = io::load_flight_plans(request.input, io::PlanNeed::kGoalsOrPreferred);
  if (!plans) return plans.error();
  if (Status fit = check_limits(request, *plans); !fit) return fit;
  given.movers = movers_of(*plans);
  given.limits = io::limits_of(*plans, request.limits);
  given.own_limits = !given.limits.empty();
  if (!given.own_limits) given.limits = {request.limits};
  given.format_description = std::move(plans->format_description);
  given.units = std::move(plans->units);
  given.notes = std::move(plans->notes);
  given.preferred_given = !plans->preferred.empty();
  if (given.preferred_given) {
    if (!plans->goals.empty())
      given.notes.emplace_back("goals are ignored, as there are preferred velocities");
    given.preferred = std::move(plans->preferred);
  } else {
    for (std::size_t i = 0; i < given.movers.size(); ++i) {
      const FlightLimits& limits = given.limits[given.own_limits ? i : 0];
      const auto velocity = velocity_to_goal(given.movers[i].position, plans->goals[i], limits,
                                             request.advice.step_s);
      if (!velocity) {
        Error error = velocity.error();
        error.location.record = i;
        return error;
      }
      given.preferred.push_back(*velocity);
    }
  }
  if (plans->velocities.empty()) given.notes.emplace_back("no velocities: all bees stand");
  if (plans->has_ids) given.names.ids = std::move(plans->ids);
  return std::monostate{};
}

Status load_obstacles(const std::string& file, AdviceInput& given) {
  auto map = load_obstacle_map(file);
  if (!map) return std::move(map).error();
  given.obstacles = *map;
  given.names.obstacles_file = io::source_name(file);
  return std::monostate{};
}

Status load_intruders(const std::string& file, AdviceInput& given) {
  auto plans = io::load_flight_plans(file, io::PlanNeed::kNothing);
  if (!plans) return plans.error();
  given.intruders = movers_of(*plans);
  if (given.intruders.empty()) {
    given.notes.push_back(io::source_name(file) + " has no intruders");
  } else if (plans->velocities.empty()) {
    given.notes.push_back(io::source_name(file) + " has no velocities: intruders stand");
  }
  for (io::UnitTaken& taken : plans->units) {
    taken.of += " of intruders";
    given.units.push_back(std::move(taken));
  }
  if (plans->has_ids) given.intruder_names.ids = std::move(plans->ids);
  return std::monostate{};
}

}  // namespace

AdviseOptions AdviceInput::options_for(const AdviseRequest& request) const {
  AdviseOptions options = request.advice;
  if (!obstacles.obstacles().empty()) options.obstacles = &obstacles;
  options.intruders = intruders;
  return options;
}

Result<AdviceInput> load_advice_input(const AdviseRequest& request) {
  AdviceInput given;
  if (Status loaded = load_bees(request, given); !loaded) return std::move(loaded).error();
  if (!request.obstacles.empty()) {
    if (Status loaded = load_obstacles(request.obstacles, given); !loaded) {
      return std::move(loaded).error();
    }
  }
  if (!request.intruders.empty()) {
    if (Status loaded = load_intruders(request.intruders, given); !loaded) {
      return std::move(loaded).error();
    }
  }
  return given;
}

}  // namespace beespace::cli
