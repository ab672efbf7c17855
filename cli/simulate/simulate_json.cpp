#include "cli/simulate/simulate_json.hpp"

#include "cli/simulate/simulate_scenarios.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"

#include <beespace/version.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace beespace::cli {
namespace {

std::string or_null(const std::optional<double>& value) {
  return value ? io::exact(*value) : "null";
}

const char* yes_or_no(bool yes) {
  return yes ? "true" : "false";
}

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

// An object, member after member, each on a line of its own.
class JsonObject {
 public:
  explicit JsonObject(std::string_view indent) : indent_(indent) {}

  void add(std::string_view name, std::string_view value) {
    text_.append(text_.empty() ? "{\n" : ",\n").append(indent_);
    text_.append("\"").append(name).append("\": ").append(value);
  }
  void add(std::string_view name, std::uint64_t count) { add(name, std::to_string(count)); }

  [[nodiscard]] std::string closed() const {
    return text_ + "\n" + std::string(indent_.substr(0, indent_.size() - 2)) + "}";
  }

 private:
  std::string_view indent_;
  std::string text_;
};

std::string closest_pair(const SimulatedFlight& flight) {
  const Verdict& verdict = flight.verdict();
  if (!verdict.closest_m) return "null";
  return "{\"first\": " + flight.names().bee_as_json(verdict.closest_pair->first) +
         ", \"second\": " + flight.names().bee_as_json(verdict.closest_pair->second) +
         ", \"step_begins_s\": " + io::exact(verdict.closest_step_s) +
         ", \"distance_m\": " + io::exact(*verdict.closest_m) + "}";
}

std::string nearest_obstacle(const SimulatedFlight& flight) {
  const auto& nearest = flight.watched().nearest;
  if (!nearest) return "null";
  return "{\"bee\": " + flight.names().bee_as_json(nearest->bee) +
         ", \"obstacle\": " + std::to_string(nearest->obstacle) +
         ", \"time_s\": " + io::exact(nearest->time_s) +
         ", \"distance_m\": " + io::exact(nearest->distance_m) + "}";
}

std::string stuck_bees(const SimulatedFlight& flight, const FlightOutcome& outcome) {
  std::string list = "[";
  for (const PointId bee : outcome.stuck) {
    if (list.size() > 1) list += ", ";
    list += flight.names().bee_as_json(bee);
  }
  return list + "]";
}

void add_question(JsonObject& object, const SimulatedFlight& flight) {
  const SimulateRequest& request = flight.request();
  const sim::LoopOptions& options = request.loop;
  const ObstacleMap* map = flight.loop().obstacles();
  const bool own = flight.has_own_limits();
  object.add("scenario", io::json_string(request.scenario));
  object.add("bees", std::uint64_t{flight.loop().movers().size()});
  object.add("spacing_m", request.from_file ? "null" : io::exact(request.spacing_m));
  object.add("seed", request.from_file || request.scenario == kHeadOn
                         ? "null"
                         : std::to_string(request.seed));
  object.add("obstacles", std::uint64_t{map == nullptr ? 0 : map->obstacles().size()});
  object.add("clearance_m", map == nullptr ? "null" : io::exact(options.advice.clearance_m));
  object.add("method", io::json_string(method_name(options.method)));
  object.add("threshold_m", io::exact(options.advice.threshold_m));
  object.add("own_limits", yes_or_no(own));
  object.add("max_speed_mps", own ? "null" : io::exact(options.limits.max_speed_mps));
  object.add("max_acceleration_mps2",
             own || flight.at_once() ? "null" : io::exact(options.limits.max_acceleration_mps2));
  object.add("step_s", io::exact(options.advice.step_s));
}

void add_answer(JsonObject& object, const SimulatedFlight& flight) {
  const FlightFigures& figures = flight.figures();
  const FlightOutcome outcome = flight.outcome();
  object.add("steps", figures.steps);
  object.add("time_s", io::exact(flight.loop().time_s()));
  object.add("all_stand", yes_or_no(figures.landed));
  object.add("loss_count", flight.verdict().losses);
  object.add("steps_with_losses", figures.steps_with_losses);
  object.add("clearance_loss_count", flight.verdict().clearance_losses);
  object.add("breach_count", flight.breaches());
  object.add("uncertified_count", figures.uncertified_pairs);
  object.add("uncertified_at_obstacles_count", figures.uncertified_at_obstacles);
  object.add("closest", closest_pair(flight));
  object.add("nearest_obstacle", nearest_obstacle(flight));
  object.add("arrived", std::uint64_t{flight.loop().arrived()});
  object.add("path_ratio", or_null(outcome.path_ratio));
  object.add("stuck_s", io::exact(outcome.stuck_s));
  object.add("stuck_at_end", stuck_bees(flight, outcome));
  object.add("advice_us", or_null(outcome.advice_us));
}

void add_head(JsonObject& object) {
  object.add("version", io::json_string(version()));
  object.add("command", io::json_string("simulate"));
}

}  // namespace

std::string simulate_json(const SimulatedFlight& flight) {
  JsonObject object("  ");
  add_head(object);
  add_question(object, flight);
  add_answer(object, flight);
  return object.closed() + "\n";
}

std::string run_as_json(const SimulatedFlight& flight) {
  JsonObject object("      ");
  add_question(object, flight);
  add_answer(object, flight);
  return object.closed();
}

std::string sweep_json(const std::vector<std::string>& runs) {
  std::string list;
  for (const std::string& run : runs) list.append(list.empty() ? "[\n    " : ",\n    ").append(run);
  JsonObject object("  ");
  add_head(object);
  object.add("scenario", io::json_string(kDensitySweep));
  object.add("runs", list + "\n  ]");
  return object.closed() + "\n";
}

}  // namespace beespace::cli
