#include "cli/simulate/fleet_flight.hpp"

#include "cli/console/progress_bar.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/swarm_output.hpp"
#include "cli/simulate/fleet_log_writer.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_writer.hpp"
#include "sim/fleet_loop.hpp"

#include <beespace/version.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

// True flights, instant after instant, and nominal ones and what is said, tick after tick.
class Recording {
 public:
  Recording(const SimulateRequest& request, const FlightNames& names, const FleetOutputs& to) {
    if (to.truth != nullptr) truth_.emplace(*to.truth, request.format, names.ids, true);
    if (to.nominal != nullptr) {
      nominal_.emplace(*to.nominal, request.nominal_format, names.ids, true);
    }
    if (to.log != nullptr) log_.emplace(*to.log, names);
  }

  void add(const sim::FleetLoop& loop) {
    if (log_) log_->add(loop);
    const auto instants = static_cast<std::size_t>(loop.options().instants);
    const double period_s = loop.options().link.period_s;
    const double begins_s = loop.time_s() - period_s;
    for (std::size_t k = 0; truth_ && k < instants; ++k) {
      std::vector<Mover> movers;
      // Intruders come first.
      for (std::size_t agent = 0; agent < loop.joined().size(); ++agent) {
        const std::size_t body = loop.options().intruders + agent;
        const sim::Stretch& s = loop.stretches()[body * instants + k];
        movers.push_back({sim::point_of(s.position), sim::velocity_of(s.velocity)});
      }
      const double share = static_cast<double>(k) / static_cast<double>(instants);
      truth_->add(begins_s + period_s * share, movers, loop.joined());
    }
    if (!nominal_) return;
    std::vector<Mover> movers;
    std::vector<std::size_t> who;
    for (const AgentGuidance& told : loop.guidance().agents) {
      movers.push_back(told.nominal);
      who.push_back(static_cast<std::size_t>(told.agent));
    }
    nominal_->add(begins_s, movers, who);
  }

  Status finish() {
    if (truth_) {
      if (Status written = truth_->finish(); !written) return written;
    }
    if (nominal_) {
      if (Status written = nominal_->finish(); !written) return written;
    }
    return log_ ? log_->finish() : Status(std::monostate());
  }

 private:
  std::optional<FlightWriter> truth_;
  std::optional<FlightWriter> nominal_;
  std::optional<FleetLogWriter> log_;
};

bool holds(const sim::FleetLoop& loop) {
  const sim::FleetTally& tally = loop.tally();
  // A true loss is a risk, by the fault of whom it may be.
  return tally.losses == 0 && tally.losses_out == 0 && tally.losses_to_intruders == 0 &&
         tally.clearance_losses == 0 && tally.clearance_losses_out == 0 &&
         loop.verdict().fence_losses == 0 && tally.false_namings == 0 &&
         loop.verdict().heights_left == 0;
}

std::string contracts_text(const sim::FleetLoop& loop, const FlightNames& names) {
  const sim::FleetTally& tally = loop.tally();
  std::string text = io::grouped(tally.named) + " out";
  if (tally.false_namings > 0) text += red(" (falsely: " + io::grouped(tally.false_namings) + ")");
  std::size_t said = 0;
  for (std::size_t agent = 0; agent < loop.agents().size(); ++agent) {
    if (!loop.agents()[agent].named_s || said == 5) continue;
    text += (said++ == 0 ? ": " : ", ") + names.bee(static_cast<PointId>(agent)) + " at " +
            io::grouped(*loop.agents()[agent].named_s, 1) + " s";
  }
  if (tally.named > said) text += ", ...";
  return text + "; doubted at some time " + io::grouped(tally.doubted);
}

std::string closest_text(const sim::FleetLoop& loop) {
  const auto& verdict = loop.verdict();
  if (!verdict.closest_m) return "no two came near each other";
  return io::length_below(loop.options().threshold_m, *verdict.closest_m) +
         " apart in the step from " + io::grouped(verdict.closest_s, 2) + " s";
}

std::string losses_text(const sim::FleetLoop& loop) {
  const sim::FleetTally& tally = loop.tally();
  const bool others = tally.losses_out > 0 || tally.losses_to_intruders > 0;
  std::string text =
      tally.losses == 0 ? bold("none") : red(io::grouped(tally.losses)) + ", a pair a step";
  if (others) text += tally.losses == 0 ? " of those that keep their contracts" : ", of such bees";
  if (tally.losses_out > 0) {
    text += "; " + red(io::grouped(tally.losses_out)) + " of bees out of theirs";
  }
  if (tally.losses_to_intruders > 0) {
    text += "; " + red(io::grouped(tally.losses_to_intruders)) + " to intruders";
  }
  if (loop.joined().size() < loop.agents().size()) {
    text += ", of " + io::grouped(std::uint64_t{loop.joined().size()}) + " that flew";
  }
  return text;
}

std::string clearance_text(const sim::FleetTally& tally) {
  std::string text = bold("none");
  if (tally.clearance_losses > 0) {
    text = red(io::grouped(tally.clearance_losses)) +
           (tally.clearance_losses == 1 ? " bee" : " bees") + ", a step each";
  }
  if (tally.clearance_losses_out == 0) return text;
  if (tally.clearance_losses == 0) text += " of those that keep their contracts";
  return text + "; " + red(io::grouped(tally.clearance_losses_out)) + " of bees out of theirs";
}

// Who could not join, by the first that is in the way.
struct NotJoined {
  std::uint64_t beyond_fences = 0;
  std::uint64_t near_obstacles = 0;
  std::uint64_t near_claims = 0;
  std::uint64_t not_asked = 0;
};

NotJoined count_not_joined(const sim::FleetLoop& loop) {
  NotJoined count;
  for (const sim::FleetAgent& agent : loop.agents()) {
    if (agent.truth) continue;
    if (!agent.refused) {
      ++count.not_asked;
    } else if (!agent.refused->fences.empty()) {
      ++count.beyond_fences;
    } else if (!agent.refused->obstacles.empty()) {
      ++count.near_obstacles;
    } else {
      ++count.near_claims;
    }
  }
  return count;
}

std::string not_joined_text(const sim::FleetLoop& loop) {
  const NotJoined count = count_not_joined(loop);
  std::string text = red(io::grouped(std::uint64_t{loop.agents().size() - loop.joined().size()}));
  const char* between = ": ";
  const auto add = [&](std::uint64_t bees, const char* why) {
    if (bees == 0) return;
    text += between + io::grouped(bees) + why;
    between = ", ";
  };
  add(count.beyond_fences, " beyond a fence, or too close to it");
  add(count.near_obstacles, " too close to obstacles");
  add(count.near_claims, " too close to claims of others");
  add(count.not_asked, " had not asked yet");
  return text;
}

std::string fleet_scenario_text(const SimulateRequest& request) {
  std::string text = printable(request.scenario);
  if (!request.from_file) {
    const double spacing_m = std::max(request.spacing_m, least_spacing_m(request));
    text += ", about " + io::exact(std::round(spacing_m * 1e3) / 1e3) + " m apart";
  }
  return text + ", seed " + std::to_string(request.seed);
}

// All that a flight is repeated with, beside what the other lines say.
std::string errors_text(const sim::FleetOptions& fleet) {
  const sim::DisturbanceBounds& wind = fleet.errors.disturbance;
  std::string text = "noise " + io::exact(fleet.errors.report_error_m) + " m" +
                     (wind.kind == sim::ErrorKind::kAdversarial ? " (adversarial)" : "") +
                     ", gusts " + io::exact(wind.gust_mps) + " m/s, drift " +
                     io::exact(wind.drift_mps) + " m/s";
  if (fleet.errors.clock.bound_s > 0.0) {
    text += ", clocks " + io::exact(fleet.errors.clock.bound_s) + " s off";
  }
  return text;
}

std::string messages_text(const sim::FleetOptions& fleet) {
  std::string text = "taken after " + std::to_string(fleet.link.command_delay) +
                     " steps, latency " + std::to_string(fleet.commands.least_latency) + ", loss " +
                     io::percentage(fleet.commands.loss);
  if (fleet.commands.loss > 0.0) {
    text += ", at most " + std::to_string(fleet.link.longest_loss) + " in a row";
  }
  return text;
}

// But the roots by which bees join, which may be taken a little later.
bool all_came_too_late(const sim::FleetLoop& loop) {
  const sim::FleetTally& tally = loop.tally();
  return tally.replies_taken <= loop.joined().size() && tally.replies_too_late > 0;
}

constexpr const char* kTooLateNote =
    "commands come too late for all; give a greater --command-delay";

double guiding_us(const sim::FleetLoop& loop) {
  const auto guided = static_cast<double>(std::max<std::uint64_t>(1, loop.tally().guided));
  return 1e6 * loop.tally().guiding_s / guided;
}

std::string fleet_summary(const SimulateRequest& request, const sim::FleetLoop& loop,
                          const MissionToFly& flown) {
  const sim::FleetOptions& fleet = loop.options();
  const auto bees = static_cast<double>(loop.agents().size());
  const Tube& tube = loop.tube();
  std::string out;
  append_summary_line(out, "scenario", fleet_scenario_text(request));
  append_summary_line(out, "bees", io::grouped(std::uint64_t{loop.agents().size()}));
  append_summary_line(out, "loop", fleet.place == LoopPlace::kOnboard ? "onboard" : "ground");
  append_summary_line(out, "errors", errors_text(fleet));
  append_summary_line(out, "commands", messages_text(fleet));
  append_summary_line(out, "tube",
                      io::length(tube.radius_m) + ", planned with " +
                          io::exact(tube.planned.max_speed_mps) + " m/s, " +
                          io::exact(tube.planned.max_acceleration_mps2) + " m/s^2");
  append_summary_line(out, "threshold",
                      io::exact(fleet.threshold_m) + " m; between nominal places " +
                          io::length(fleet.threshold_m + 2.0 * tube.radius_m));
  const std::size_t obstacles = loop.obstacles().obstacles().size();
  if (obstacles > 0) {
    append_summary_line(out, "obstacles",
                        io::grouped(std::uint64_t{obstacles}) + ", clearance " +
                            io::exact(fleet.clearance_m) + " m");
  }
  append_summary_line(
      out, "flown",
      io::grouped(loop.time_s(), 2) + " s in steps of " + io::exact(fleet.link.period_s) + " s");
  append_summary_line(out, "losses", losses_text(loop));
  append_summary_line(out, "closest", closest_text(loop));
  if (obstacles > 0) append_summary_line(out, "clearance", clearance_text(loop.tally()));
  if (!fleet.fences.empty()) {
    append_summary_line(out, "fences",
                        loop.verdict().fence_losses == 0
                            ? bold("kept")
                            : red(io::grouped(loop.verdict().fence_losses)) + ", a bee a step");
  }
  append_summary_line(out, "arrived",
                      io::grouped(std::uint64_t{loop.arrived()}) + " (" +
                          io::percentage(static_cast<double>(loop.arrived()) / bees) + ")");
  if (loop.joined().size() < loop.agents().size()) {
    append_summary_line(out, "not joined", not_joined_text(loop));
  }
  append_summary_line(out, "contracts", contracts_text(loop, flown.names));
  append_summary_line(out, "time",
                      "guidance " + io::grouped(guiding_us(loop), 2) + " us a bee a step");
  if (all_came_too_late(loop)) append_summary_line(out, "note", kTooLateNote);
  for (const std::string& note : flown.notes) append_summary_line(out, "note", printable(note));
  return out;
}

std::string fleet_json(const SimulateRequest& request, const sim::FleetLoop& loop,
                       const MissionToFly& flown) {
  const sim::FleetTally& tally = loop.tally();
  std::string out;
  io::JsonWriter json(out);
  json.begin_object(io::JsonLayout::kLines);
  json.member("version", version()).member("command", "simulate");
  json.member("scenario", request.scenario).member("bees", loop.agents().size());
  json.member("seed", request.seed).member("threshold_m", loop.options().threshold_m);
  json.member("tube_m", loop.tube().radius_m);
  json.member("nominal_threshold_m", loop.options().threshold_m + 2.0 * loop.tube().radius_m);
  json.member("planned_speed_mps", loop.tube().planned.max_speed_mps);
  json.member("planned_acceleration_mps2", loop.tube().planned.max_acceleration_mps2);
  json.member("step_s", loop.options().link.period_s);
  json.member("command_delay", loop.options().link.command_delay);
  json.member("time_s", loop.time_s()).member("arrived", loop.arrived());
  json.member("loss_count", tally.losses).member("out_loss_count", tally.losses_out);
  json.member("intruder_loss_count", tally.losses_to_intruders);
  json.member("fence_loss_count", loop.verdict().fence_losses);
  json.member("obstacles", loop.obstacles().obstacles().size());
  json.member("clearance_loss_count", tally.clearance_losses);
  json.member("out_clearance_loss_count", tally.clearance_losses_out);
  json.member("joined_count", loop.joined().size());
  json.member("not_joined_count", loop.agents().size() - loop.joined().size());
  json.member("closest_m", loop.verdict().closest_m);
  json.member("false_naming_count", tally.false_namings);
  json.begin_array("out");
  for (std::size_t agent = 0; agent < loop.agents().size(); ++agent) {
    const auto& named_s = loop.agents()[agent].named_s;
    if (!named_s) continue;
    json.begin_object();
    flown.names.write_bee(json.key("bee"), static_cast<PointId>(agent));
    json.member("time_s", *named_s).end();
  }
  json.end();
  json.member("doubted_count", tally.doubted).member("commands", tally.commands);
  json.member("guidance_us", guiding_us(loop));
  json.end();
  return out + '\n';
}

// The figures of an error of the library, with the options that they come from.
std::string with_options(std::string message) {
  constexpr std::pair<std::string_view, std::string_view> kFigures[] = {
      {"deviation_mps", "--drift, --gust and --clock-error"},
      {"correction_mps2", "--reserve"},
      {"correction_mps", "--reserve"},
      {"clock_error_s", "--clock-error"},
      {"max_acceleration_mps2", "--acceleration"},
      {"max_speed_mps", "--speed"}};
  for (const auto& [figure, options] : kFigures) {
    std::size_t at = message.find(figure);
    // Of "correction_mps2" the begin is the name of another figure.
    while (at != std::string::npos && message.compare(at + figure.size(), 1, "2") == 0) {
      at = message.find(figure, at + 1);
    }
    if (at == std::string::npos) continue;
    message.insert(at + figure.size(), " (" + std::string(options) + ")");
  }
  return message;
}

Status fly_loop(const SimulateRequest& request, sim::FleetLoop& loop, Recording& recording) {
  ProgressBar progress(!request.quiet);
  progress.enter_stage("flying");
  for (std::uint64_t step = 0; step < request.most_steps; ++step) {
    if (loop.arrived() == loop.agents().size()) break;
    if (Status flown = loop.step(); !flown) return flown;
    recording.add(loop);
    progress.set_share(static_cast<double>(step) / static_cast<double>(request.most_steps));
  }
  progress.finish();
  return recording.finish();
}

}  // namespace

Result<ExitCode> fly_fleet(const SimulateRequest& request, MissionToFly mission,
                           const FleetOutputs& outputs) {
  if (!mission.mission.limits.empty()) {
    return simulate_error(
        "a fleet that is flown by commands has one limit for all; leave the "
        "columns of limits out");
  }
  if (request.fleet.planar) {
    for (auto* places : {&mission.mission.starts, &mission.mission.goals}) {
      for (Point& place : *places) place.z = 0.0;
    }
  }
  auto made = sim::FleetLoop::make(mission.mission, request.fleet);
  if (!made) return simulate_error(with_options(made.error().message));
  sim::FleetLoop& loop = **made;
  Recording recording(request, mission.names, outputs);
  const Status flown = fly_loop(request, loop, recording);
  for (const io::AtomicOutput* output : {outputs.truth, outputs.nominal, outputs.log}) {
    if (!flown && output != nullptr && output->pipe_closed()) return ExitCode::kPipeClosed;
  }
  if (!flown) return flown.error();
  if (request.json) {
    const ExitCode written = print(fleet_json(request, loop, mission));
    if (written != ExitCode::kFine) return written;
  }
  if (!request.quiet) say(fleet_summary(request, loop, mission));
  return request.fail_on_risk && !holds(loop) ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace beespace::cli
