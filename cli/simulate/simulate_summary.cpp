#include "cli/simulate/simulate_summary.hpp"

#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::cli {
namespace {

std::string times(std::uint64_t count, const char* one, const char* several) {
  return io::grouped(count) + " " + (count == 1 ? one : several);
}

std::string scenario_text(const SimulateRequest& request) {
  if (request.from_file) return printable(io::source_name(request.scenario));
  const std::string spacing = io::exact(request.spacing_m) + " m";
  if (request.scenario == "head-on") return "head-on, from " + spacing + " apart";
  return request.scenario + ", about " + spacing + " apart, seed " + std::to_string(request.seed);
}

std::string method_text(sim::Method method) {
  switch (method) {
    case sim::Method::kNone:
      return "none: each bee as it likes";
    case sim::Method::kOrca:
      return "orca: optimal reciprocal collision avoidance, which promises nothing";
    case sim::Method::kMvp:
      return "mvp: modified voltage potential, which promises nothing";
    case sim::Method::kCertified:
      break;
  }
  return "certified";
}

std::string limits_text(const FlightLimits& limits) {
  const std::string text = io::exact(limits.max_speed_mps) + " m/s";
  if (std::isinf(limits.max_acceleration_mps2)) return text + ", velocities change at once";
  return text + ", " + io::exact(limits.max_acceleration_mps2) + " m/s^2";
}

std::string threshold_text(const SimulateRequest& request) {
  return separation_text(request.loop.advice.threshold_m, std::nullopt, false);
}

void append_obstacles(std::string& out, const SimulatedFlight& flight) {
  const ObstacleMap* map = flight.loop().obstacles();
  if (map == nullptr) return;
  append_summary_line(out, "obstacles",
                      io::grouped(std::uint64_t{map->obstacles().size()}) + ", clearance " +
                          io::exact(flight.request().loop.advice.clearance_m) + " m");
}

std::string flown_text(const SimulatedFlight& flight) {
  const FlightFigures& figures = flight.figures();
  const std::string text = times(figures.steps, "step", "steps") + " of " +
                           io::exact(flight.request().loop.advice.step_s) + " s (" +
                           io::grouped(flight.loop().time_s(), 2) + " s)";
  return text + (figures.landed ? ", until all had arrived" : ", the most (--steps)");
}

std::string losses_text(const SimulatedFlight& flight) {
  const std::uint64_t losses = flight.verdict().losses;
  if (losses == 0) return bold("none");
  return red(times(losses, "loss", "losses")) + " of separation, a pair a step; in " +
         io::grouped(flight.figures().steps_with_losses) + " of " +
         times(flight.figures().steps, "step", "steps");
}

std::string closest_text(const SimulatedFlight& flight) {
  const Verdict& verdict = flight.verdict();
  if (!verdict.closest_m) {
    return "no two came closer than " + io::exact(2.0 * flight.request().loop.advice.threshold_m) +
           " m";
  }
  return flight.names().bee(verdict.closest_pair->first) + " and " +
         flight.names().bee(verdict.closest_pair->second) + ", " +
         io::length_below(flight.request().loop.advice.threshold_m, *verdict.closest_m) +
         " apart in the step from " + io::grouped(verdict.closest_step_s, 2) + " s";
}

// How near to obstacles, and how often too near.
void append_nearness(std::string& out, const SimulatedFlight& flight) {
  const ObstacleMap* map = flight.loop().obstacles();
  if (map == nullptr) return;
  const WatchFigures& watched = flight.watched();
  const std::uint64_t losses = flight.verdict().clearance_losses;
  append_summary_line(
      out, "clearance",
      losses == 0 ? bold("kept") : red(times(losses, "loss", "losses")) + ", a bee a step");
  std::string text = "none came closer than " +
                     io::exact(2.0 * flight.request().loop.advice.clearance_m) +
                     " m to any obstacle";
  if (watched.nearest) {
    const auto& [bee, obstacle, distance_m, time_s] = *watched.nearest;
    text =
        flight.names().bee(bee) + ", " +
        (distance_m < 0.0
             ? io::length(-distance_m) + " inside "
             : io::length_below(flight.request().loop.advice.clearance_m, distance_m) + " from ") +
        flight.names().obstacle(obstacle, map->obstacles()[obstacle]) + ", at " +
        io::grouped(time_s, 2) + " s";
  }
  append_summary_line(out, "nearest", text);
}

void append_uncertified(std::string& out, const FlightFigures& figures) {
  if (figures.uncertified_pairs > 0) {
    append_summary_line(out, "uncertain",
                        red(times(figures.uncertified_pairs, "pair", "pairs")) +
                            " not certified, counted anew in each step");
  }
  if (figures.uncertified_at_obstacles > 0) {
    append_summary_line(out, "uncertain",
                        red(times(figures.uncertified_at_obstacles, "bee", "bees")) +
                            " near obstacles not certified, counted anew in each step");
  }
}

std::string arrived_text(const sim::ClosedLoop& loop) {
  const auto bees = static_cast<double>(loop.movers().size());
  return io::grouped(std::uint64_t{loop.arrived()}) + " (" +
         io::percentage(static_cast<double>(loop.arrived()) / bees) + ")";
}

std::string stuck_text(const SimulatedFlight& flight, const FlightOutcome& outcome) {
  std::string text = io::grouped(outcome.stuck_s, 2) + " s a bee";
  if (outcome.stuck.empty()) return text;
  text += "; at the end " + red(io::grouped(std::uint64_t{outcome.stuck.size()})) + " for up to " +
          io::grouped(outcome.longest_stuck_s, 2) + " s: ";
  constexpr std::size_t kShown = 5;
  const std::size_t shown = std::min(kShown, outcome.stuck.size());
  for (std::size_t i = 0; i < shown; ++i) {
    text += (i > 0 ? ", " : "") + flight.names().bee(outcome.stuck[i]);
  }
  return text + (outcome.stuck.size() > shown ? ", ..." : "");
}

std::string limits_line(const SimulatedFlight& flight) {
  if (flight.has_own_limits()) return "of the file, each bee its own";
  return limits_text(flight.request().loop.limits);
}

// Columns of the sweep, each as wide as its name and two blanks.
constexpr std::string_view kColumns[] = {"spacing",    "losses",  "closest",        "arrived",
                                         "path ratio", "stuck s", "us a bee a step"};

std::string row_of(const std::vector<std::string>& cells) {
  constexpr std::size_t kNarrowest = 8;
  std::string row;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t width = std::max(kColumns[i].size(), kNarrowest) + 2;
    row += std::string(width - std::min(width, cells[i].size()), ' ') + cells[i];
  }
  return row + '\n';
}

}  // namespace

std::string simulate_summary(const SimulatedFlight& flight) {
  const SimulateRequest& request = flight.request();
  const FlightOutcome outcome = flight.outcome();
  std::string out;
  append_summary_line(out, "scenario", scenario_text(request));
  append_summary_line(out, "bees", io::grouped(std::uint64_t{flight.loop().movers().size()}));
  append_obstacles(out, flight);
  append_summary_line(out, "method", method_text(request.loop.method));
  append_summary_line(out, "threshold", threshold_text(request));
  append_summary_line(out, "limits", limits_line(flight));
  append_summary_line(out, "flown", flown_text(flight));
  append_summary_line(out, "losses", losses_text(flight));
  append_summary_line(out, "closest", closest_text(flight));
  append_nearness(out, flight);
  if (flight.breaches() > 0) {
    append_summary_line(out, "breaches",
                        red(times(flight.breaches(), "breach", "breaches")) + " of the limits");
  }
  append_uncertified(out, flight.figures());
  append_summary_line(out, "arrived", arrived_text(flight.loop()));
  append_summary_line(out, "path ratio",
                      outcome.path_ratio ? io::grouped(*outcome.path_ratio, 3) +
                                               " (flown to shortest, of those that arrived)"
                                         : "none: no bee has flown and arrived");
  append_summary_line(out, "stuck", stuck_text(flight, outcome));
  std::string time = "in all " + io::duration(flight.figures().total_s);
  if (outcome.advice_us) {
    time.insert(0, "advice " + io::grouped(*outcome.advice_us, 2) + " us a bee a step, ");
  }
  append_summary_line(out, "time", time);
  for (const std::string& note : flight.notes()) append_summary_line(out, "note", printable(note));
  return out;
}

std::string sweep_head(const SimulateRequest& request) {
  std::string out;
  append_summary_line(
      out, "scenario",
      "random swaps, closer and closer together, seed " + std::to_string(request.seed));
  append_summary_line(out, "bees", io::grouped(std::uint64_t{request.bees}));
  append_summary_line(out, "method", method_text(request.loop.method));
  append_summary_line(out, "threshold", threshold_text(request));
  append_summary_line(out, "limits", limits_text(request.loop.limits));
  return out + '\n' + row_of({std::begin(kColumns), std::end(kColumns)});
}

std::string sweep_row(const SimulatedFlight& flight) {
  const FlightOutcome outcome = flight.outcome();
  const Verdict& verdict = flight.verdict();
  const sim::ClosedLoop& loop = flight.loop();
  const double arrived =
      static_cast<double>(loop.arrived()) / static_cast<double>(loop.movers().size());
  return row_of(
      {io::exact(flight.request().spacing_m) + " m", io::grouped(verdict.losses),
       verdict.closest_m
           ? io::length_below(flight.request().loop.advice.threshold_m, *verdict.closest_m)
           : "-",
       io::percentage(arrived), outcome.path_ratio ? io::grouped(*outcome.path_ratio, 3) : "-",
       io::grouped(outcome.stuck_s, 2),
       outcome.advice_us ? io::grouped(*outcome.advice_us, 2) : "-"});
}

}  // namespace beespace::cli
