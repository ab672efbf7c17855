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
std::optional<Error> check(const MoversView& movers, std::span<const Velocity> preferred,
                           std::span<const FlightLimits> limits, const AdviseOptions& options);

}  // namespace beespace::avoidance
