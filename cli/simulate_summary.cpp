#include "cli/simulate_summary.hpp"

#include "cli/json_text.hpp"
#include "cli/number_text.hpp"
#include "cli/summary_line.hpp"
#include "cli/terminal.hpp"

#include <beespace/version.hpp>

#include <cstddef>
#include <optional>

namespace beespace::cli {
namespace {

// Of all bees together.
struct Outcome {
  std::optional<double> path_ratio;  // of those that have flown and arrived: the mean
  double stuck_s = 0.0;              // the mean
  std::optional<double> advice_us;   // a bee a step
};

Outcome outcome_of(const sim::ClosedLoop& loop, const FlightFigures& figures) {
  Outcome outcome;
  double ratios = 0.0;
  std::size_t flown = 0;
  for (const sim::Flight& flight : loop.flights()) {
    outcome.stuck_s += flight.stuck_s;
    // Who begins at its goal has no way to fly.
    if (!flight.arrived_s || !(*flight.arrived_s > 0.0)) continue;
    ratios += flight.flown_m / flight.shortest_m;
    ++flown;
  }
  const auto bees = static_cast<double>(loop.flights().size());
  outcome.stuck_s /= bees;
  if (flown > 0) outcome.path_ratio = ratios / static_cast<double>(flown);
  if (figures.steps > 0 && loop.advising_s() > 0.0) {
    outcome.advice_us = loop.advising_s() / bees / static_cast<double>(figures.steps) * 1e6;
  }
  return outcome;
}

std::string times(std::uint64_t count, const char* one, const char* several) {
  return grouped(count) + " " + (count == 1 ? one : several);
}

std::string scenario_text(const SimulateRequest& request) {
  const std::string spacing = exact(request.spacing_m) + " m";
  if (request.scenario == "head-on") return "head-on, from " + spacing + " apart";
  return request.scenario + ", about " + spacing + " apart, seed " + std::to_string(request.seed);
}

std::string limits_text(const SimulateRequest& request) {
  const FlightLimits& limits = request.loop.limits;
  std::string text = exact(limits.max_speed_mps) + " m/s";
  if (request.at_once()) return text + ", velocities change at once";
  return text + ", " + exact(limits.max_acceleration_mps2) + " m/s^2";
}

std::string flown_text(const SimulateRequest& request, const sim::ClosedLoop& loop,
                       const FlightFigures& figures) {
  std::string text = times(figures.steps, "step", "steps") + " of " +
                     exact(request.loop.advice.step_s) + " s (" + grouped(loop.time_s(), 2) + " s)";
  return text + (figures.landed ? ", until all had arrived" : ", the most (--steps)");
}

std::string losses_text(const Verdict& verdict, const FlightFigures& figures) {
  if (verdict.losses == 0) return bold("none");
  return red(times(verdict.losses, "loss", "losses")) + " of separation, a pair a step; in " +
         grouped(figures.steps_with_losses) + " of " + times(figures.steps, "step", "steps");
}

std::string closest_text(const SimulateRequest& request, const Verdict& verdict) {
  if (!verdict.closest_m) {
    return "nobody came closer than " + exact(2.0 * request.loop.advice.threshold_m) +
           " m to anybody";
  }
  return std::to_string(verdict.closest_pair->first) + " and " +
         std::to_string(verdict.closest_pair->second) + ", " + length(*verdict.closest_m) +
         " apart in the step from " + grouped(verdict.closest_step_s, 2) + " s";
}

}  // namespace

std::string simulate_summary(const SimulateRequest& request, const sim::ClosedLoop& loop,
                             const Verdict& verdict, const FlightFigures& figures) {
  const Outcome outcome = outcome_of(loop, figures);
  const bool certified = request.loop.method == sim::Method::kCertified;
  std::string out;
  append_summary_line(out, "scenario", scenario_text(request));
  append_summary_line(out, "bees", grouped(request.bees));
  append_summary_line(out, "method", certified ? "certified" : "none: everybody as it likes");
  append_summary_line(out, "threshold",
                      separation_text(request.loop.advice.threshold_m, std::nullopt, false));
  append_summary_line(out, "limits", limits_text(request));
  append_summary_line(out, "flown", flown_text(request, loop, figures));
  append_summary_line(out, "losses", losses_text(verdict, figures));
  append_summary_line(out, "closest", closest_text(request, verdict));
  if (verdict.breaches > 0) {
    append_summary_line(out, "breaches",
                        red(times(verdict.breaches, "breach", "breaches")) + " of the limits");
  }
  if (figures.uncertified > 0) {
    append_summary_line(out, "uncertain",
                        red(times(figures.uncertified, "pair", "pairs")) +
                            " not certified, counted anew in each step");
  }
  append_summary_line(
      out, "arrived",
      grouped(loop.arrived()) + " (" +
          percentage(static_cast<double>(loop.arrived()) / static_cast<double>(request.bees)) +
          ")");
  append_summary_line(out, "path ratio",
                      outcome.path_ratio ? grouped(*outcome.path_ratio, 3) +
                                               " (flown to shortest, of those that arrived)"
                                         : "none: nobody has flown and arrived");
  append_summary_line(out, "stuck", grouped(outcome.stuck_s, 2) + " s a bee");
  std::string time = "in all " + duration(figures.total_s);
  if (outcome.advice_us) {
    time.insert(0, "advice " + grouped(*outcome.advice_us, 2) + " us a bee a step, ");
  }
  append_summary_line(out, "time", time);
  return out;
}

std::string simulate_json(const SimulateRequest& request, const sim::ClosedLoop& loop,
                          const Verdict& verdict, const FlightFigures& figures) {
  const Outcome outcome = outcome_of(loop, figures);
  const auto number = [](const std::optional<double>& value) {
    return value ? exact(*value) : std::string("null");
  };
  const sim::LoopOptions& options = request.loop;
  const bool certified = options.method == sim::Method::kCertified;
  std::string out = "{\n  \"version\": " + json_string(version());
  const auto member = [&out](const char* name, const std::string& value) {
    out += ",\n  \"";
    out += name;
    out += "\": " + value;
  };
  member("command", "\"simulate\"");
  member("scenario", json_string(request.scenario));
  member("bees", std::to_string(request.bees));
  member("spacing_m", exact(request.spacing_m));
  member("seed", request.scenario == "head-on" ? "null" : std::to_string(request.seed));
  member("method", certified ? "\"certified\"" : "\"none\"");
  member("threshold_m", exact(options.advice.threshold_m));
  member("max_speed_mps", exact(options.limits.max_speed_mps));
  member("max_acceleration_mps2",
         request.at_once() ? "null" : exact(options.limits.max_acceleration_mps2));
  member("step_s", exact(options.advice.step_s));
  member("steps", std::to_string(figures.steps));
  member("time_s", exact(loop.time_s()));
  member("all_stand", figures.landed ? "true" : "false");
  member("loss_count", std::to_string(verdict.losses));
  member("steps_with_losses", std::to_string(figures.steps_with_losses));
  member("breach_count", std::to_string(verdict.breaches));
  member("uncertified_count", std::to_string(figures.uncertified));
  std::string closest = "null";
  if (verdict.closest_m) {
    closest = "{\"first\": " + std::to_string(verdict.closest_pair->first) +
              ", \"second\": " + std::to_string(verdict.closest_pair->second) +
              ", \"step_begins_s\": " + exact(verdict.closest_step_s) +
              ", \"distance_m\": " + exact(*verdict.closest_m) + "}";
  }
  member("closest", closest);
  member("arrived", std::to_string(loop.arrived()));
  member("path_ratio", number(outcome.path_ratio));
  member("stuck_s", exact(outcome.stuck_s));
  member("advice_us", number(outcome.advice_us));
  return out + "\n}\n";
}

}  // namespace beespace::cli
