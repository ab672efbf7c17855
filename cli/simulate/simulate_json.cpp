#include "cli/simulate/simulate_json.hpp"

#include "cli/simulate/simulate_scenarios.hpp"

#include <beespace/version.hpp>

#include <string_view>

namespace beespace::cli {
namespace {

std::string_view method_name(sim::Method method) {
  switch (method) {
    case sim::Method::kNone:
      return "none";
    case sim::Method::kOrca:
      return "orca";
    case sim::Method::kMvp:
      return "mvp";
    case sim::Method::kCertified:
      break;
  }
  return "certified";
}

void write_closest(io::JsonWriter& json, const SimulatedFlight& flight) {
  const Verdict& verdict = flight.verdict();
  if (!verdict.closest_m) return json.key("closest").null();
  json.begin_object("closest");
  flight.names().write_bee(json.key("first"), verdict.closest_pair->first);
  flight.names().write_bee(json.key("second"), verdict.closest_pair->second);
  json.member("step_begins_s", verdict.closest_step_s).member("distance_m", verdict.closest_m);
  json.end();
}

void write_nearest(io::JsonWriter& json, const SimulatedFlight& flight) {
  const auto& nearest = flight.watched().nearest;
  if (!nearest) return json.key("nearest_obstacle").null();
  json.begin_object("nearest_obstacle");
  flight.names().write_bee(json.key("bee"), nearest->bee);
  json.member("obstacle", nearest->obstacle);
  json.member("time_s", nearest->time_s).member("distance_m", nearest->distance_m);
  json.end();
}

void write_question(io::JsonWriter& json, const SimulatedFlight& flight) {
  const SimulateRequest& request = flight.request();
  const sim::LoopOptions& options = request.loop;
  const ObstacleMap* map = flight.loop().obstacles();
  const bool limits = !flight.has_own_limits();
  const bool random = !request.from_file && request.scenario != kHeadOn;
  json.member("scenario", request.scenario).member("bees", flight.loop().movers().size());
  json.member("spacing_m", io::known_if(!request.from_file, request.spacing_m));
  json.member("seed", io::known_if(random, request.seed));
  json.member("obstacles", map == nullptr ? 0 : map->obstacles().size());
  json.member("clearance_m", io::known_if(map != nullptr, options.advice.clearance_m));
  json.member("method", method_name(options.method));
  json.member("threshold_m", options.advice.threshold_m);
  json.member("own_limits", flight.has_own_limits());
  json.member("max_speed_mps", io::known_if(limits, options.limits.max_speed_mps));
  json.member("max_acceleration_mps2",
              io::known_if(limits && !flight.at_once(), options.limits.max_acceleration_mps2));
  json.member("step_s", options.advice.step_s);
}

void write_answer(io::JsonWriter& json, const SimulatedFlight& flight) {
  const FlightFigures& figures = flight.figures();
  const FlightOutcome outcome = flight.outcome();
  json.member("steps", figures.steps).member("time_s", flight.loop().time_s());
  json.member("all_stand", figures.landed).member("loss_count", flight.verdict().losses);
  json.member("steps_with_losses", figures.steps_with_losses);
  json.member("clearance_loss_count", flight.verdict().clearance_losses);
  json.member("breach_count", flight.breaches());
  json.member("uncertified_count", figures.uncertified_pairs);
  json.member("uncertified_at_obstacles_count", figures.uncertified_at_obstacles);
  write_closest(json, flight);
  write_nearest(json, flight);
  json.member("arrived", flight.loop().arrived()).member("path_ratio", outcome.path_ratio);
  json.member("stuck_s", outcome.stuck_s);
  json.begin_array("stuck_at_end");
  for (const PointId bee : outcome.stuck) flight.names().write_bee(json, bee);
  json.end();
  json.member("advice_us", outcome.advice_us);
}

void begin_document(io::JsonWriter& json) {
  json.begin_object(io::JsonLayout::kLines);
  json.member("version", version()).member("command", "simulate");
}

}  // namespace

std::string simulate_json(const SimulatedFlight& flight) {
  std::string out;
  io::JsonWriter json(out);
  begin_document(json);
  write_question(json, flight);
  write_answer(json, flight);
  json.end();
  return out + '\n';
}

void begin_sweep(io::JsonWriter& json) {
  begin_document(json);
  json.member("scenario", kDensitySweep);
  json.begin_array("runs", io::JsonLayout::kLines);
}

void write_run(io::JsonWriter& json, const SimulatedFlight& flight) {
  json.begin_object(io::JsonLayout::kLines);
  write_question(json, flight);
  write_answer(json, flight);
  json.end();
}

void end_sweep(io::JsonWriter& json) {
  json.end().end();
}

}  // namespace beespace::cli
