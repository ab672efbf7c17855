// Checks the input of advise() as a whole.
#pragma once

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <span>

namespace beespace::avoidance {

std::optional<Error> check_step(double step_s);
std::optional<Error> check_limits(const FlightLimits& limits);
// Errors of the call as a whole; Intake finds what is wrong with one bee alone.
std::optional<Error> check(const MoversView& movers, std::span<const Velocity> preferred,
                           std::span<const FlightLimits> limits, const AdviseOptions& options);

}  // namespace beespace::avoidance
