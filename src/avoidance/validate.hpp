// Whether a question about what bees shall do makes sense.
#pragma once

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <span>

namespace beespace::avoidance {

std::optional<Error> check_step(double step_s);
std::optional<Error> check_limits(const FlightLimits& limits);
// Of the question as a whole; what is wrong with one bee alone is found by Intake.
std::optional<Error> check(const MoversView& movers, std::span<const Velocity> preferred,
                           std::span<const FlightLimits> limits, const AdviseOptions& options);

}  // namespace beespace::avoidance
