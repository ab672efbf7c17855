// What `beespace advise` advises about: agents, obstacles and intruders.
#pragma once

#include "cli/advise/advise_request.hpp"
#include "cli/input/flight_names.hpp"
#include "io/load_points.hpp"

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

struct AdviceInput {
  std::vector<Mover> movers;
  std::vector<Velocity> preferred;
  std::vector<FlightLimits> limits;  // one for each, or one for all
  bool own_limits = false;           // as the file gives them
  bool preferred_given = false;      // preferred are those of the file, not ways to goals
  ObstacleMap obstacles;
  std::vector<Mover> intruders;
  FlightNames names;  // of bees and obstacles
  FlightNames intruder_names;
  std::string format_description;
  std::vector<io::UnitTaken> units;  // of bees, then of intruders
  std::vector<std::string> notes;

  // Those of the request, with obstacles and intruders; it refers into this.
  [[nodiscard]] AdviseOptions options_for(const AdviseRequest& request) const;
};

// Errors: those of the readers, with their places; kInvalidArgument for options that the file
// overrides.
Result<AdviceInput> load_advice_input(const AdviseRequest& request);

}  // namespace beespace::cli
