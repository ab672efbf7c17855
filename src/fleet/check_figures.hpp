// Whether figures of a fleet can be: each alone, and all together.
#pragma once

#include <beespace/advise.hpp>
#include <beespace/fleet.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <string>

namespace beespace::fleet {

// A number as a person reads it: with nine digits at most.
std::string number(double value);

Error refused(std::string message);

std::optional<Error> check_figures(const FleetFigures& figures, const LinkFigures& link,
                                   const FlightLimits& limits);

}  // namespace beespace::fleet
