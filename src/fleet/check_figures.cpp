#include "fleet/check_figures.hpp"

#include <beespace/mover.hpp>

#include <cmath>
#include <cstdio>
#include <utility>

namespace beespace::fleet {

namespace {

// The most ticks after which a command takes effect: its states end there (Command::kMostStates).
constexpr int kLongestDelay = 32;

std::optional<Error> check_number(const char* name, double value) {
  if (value >= 0.0 && value <= kLargestInMotion) return std::nullopt;
  return refused(std::string(name) + " is " + number(value) +
                 "; give a finite number, zero or more");
}

std::optional<Error> check_numbers(const FleetFigures& figures) {
  struct Named {
    const char* name;
    double value;
  };
  for (const Named& one :
       {Named{"report_error_m", figures.report_error_m},
        Named{"report_age_s", figures.report_age_s},
        Named{"sensing_error_m", figures.sensing_error_m},
        Named{"loop_period_s", figures.loop_period_s}, Named{"loop_delay_s", figures.loop_delay_s},
        Named{"deviation_mps", figures.deviation_mps},
        Named{"clock_error_s", figures.clock_error_s},
        Named{"correction_mps2", figures.correction_mps2},
        Named{"correction_mps", figures.correction_mps}}) {
    if (auto error = check_number(one.name, one.value)) return error;
  }
  return std::nullopt;
}

std::optional<Error> check_link(const LinkFigures& link) {
  if (!(link.period_s >= kSmallestInMotion && link.period_s <= kLargestInMotion)) {
    return refused("period_s is " + number(link.period_s) + "; give a finite time above zero");
  }
  if (link.command_delay < 1 || link.command_delay > kLongestDelay) {
    return refused("command_delay is " + std::to_string(link.command_delay) +
                   " ticks; give a number from 1 to " + std::to_string(kLongestDelay));
  }
  if (link.longest_loss >= 0) return std::nullopt;
  return refused("longest_loss is " + std::to_string(link.longest_loss) +
                 "; give the number of messages, zero or more");
}

std::optional<Error> check_limits(const FlightLimits& limits) {
  if (auto error = check_number("max_speed_mps", limits.max_speed_mps)) return error;
  const double most = limits.max_acceleration_mps2;
  const bool none = std::isinf(most) && most > 0.0;
  if (none || (most >= kSmallestInMotion && most <= kLargestInMotion)) return std::nullopt;
  return refused("max_acceleration_mps2 is " + number(most) +
                 "; give one above zero, or infinity for none");
}

// What is kept for corrections leaves something for the plan.
std::optional<Error> check_reserves(const FleetFigures& figures, const FlightLimits& limits) {
  if (figures.correction_mps > 0.0 && figures.correction_mps >= limits.max_speed_mps) {
    return refused("correction_mps " + number(figures.correction_mps) +
                   " must be below max_speed_mps, which is " + number(limits.max_speed_mps) +
                   ": nothing would be left for the plan; keep less, or fly in less wind");
  }
  if (figures.correction_mps2 >= limits.max_acceleration_mps2) {
    return refused("correction_mps2 " + number(figures.correction_mps2) +
                   " must be below max_acceleration_mps2, which is " +
                   number(limits.max_acceleration_mps2) +
                   ": nothing would be left for the plan; keep less");
  }
  return std::nullopt;
}

// Without a report, or with a command that did not come, nothing is corrected: the agent drifts
// for as long, and no bound of its deviation is known any more.
std::optional<Error> check_losses(const FleetFigures& figures, const LinkFigures& link) {
  if (figures.loop != LoopPlace::kGround || link.longest_loss == 0) return std::nullopt;
  return refused("longest_loss is " + std::to_string(link.longest_loss) +
                 ", and the loop is closed on the ground, where corrections are lost with the "
                 "commands: it must be 0; send each message several times in a period, choose a "
                 "period in which one surely arrives (" +
                 number(link.period_s * (link.longest_loss + 1.0)) +
                 " s?), or let the agents hold their paths on board");
}

}  // namespace

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

Error refused(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message), {}};
}

std::optional<Error> check_figures(const FleetFigures& figures, const LinkFigures& link,
                                   const FlightLimits& limits) {
  if (figures.loop != LoopPlace::kOnboard && figures.loop != LoopPlace::kGround) {
    return refused("loop is number " + std::to_string(static_cast<int>(figures.loop)) +
                   ", which is none; give one of LoopPlace");
  }
  if (auto error = check_numbers(figures)) return error;
  if (auto error = check_link(link)) return error;
  if (auto error = check_limits(limits)) return error;
  if (auto error = check_reserves(figures, limits)) return error;
  return check_losses(figures, link);
}

}  // namespace beespace::fleet
