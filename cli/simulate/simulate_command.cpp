#include "cli/console/progress_bar.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/output_form.hpp"
#include "cli/simulate/fleet_flight.hpp"
#include "cli/simulate/simulate_json.hpp"
#include "cli/simulate/simulate_mission.hpp"
#include "cli/simulate/simulate_request.hpp"
#include "cli/simulate/simulate_scenarios.hpp"
#include "cli/simulate/simulate_summary.hpp"
#include "cli/simulate/simulated_flight.hpp"
#include "io/bytes/atomic_output.hpp"

#include <optional>
#include <string>
#include <utility>

namespace beespace::cli {
namespace {

// Nothing where there is no name.
Result<std::optional<io::AtomicOutput>> open_beside(const SimulateRequest& request,
                                                    const std::string& name, io::Packing packing) {
  std::optional<io::AtomicOutput> output;
  if (name.empty()) return output;
  auto opened = open_output("simulate", name, {request.output}, packing);
  if (!opened) return std::move(opened).error();
  output.emplace(std::move(opened).value());
  return output;
}

Result<ExitCode> simulate_fleet(const SimulateRequest& request, MissionToFly mission,
                                io::AtomicOutput* truth) {
  auto nominal = open_beside(request, request.nominal, request.nominal_format.packing());
  if (!nominal) return std::move(nominal).error();
  const bool packed = file_ending(request.fleet_log).compressed;
  auto log =
      open_beside(request, request.fleet_log, packed ? io::Packing::kGzip : io::Packing::kPlain);
  if (!log) return std::move(log).error();
  return fly_fleet(request, std::move(mission),
                   {truth, *nominal ? &**nominal : nullptr, *log ? &**log : nullptr});
}

Result<ExitCode> simulate(const SimulateRequest& request) {
  std::optional<io::AtomicOutput> output;
  if (!request.output.empty()) {
    auto opened =
        open_output("simulate", request.output,
                    {request.from_file ? request.scenario : std::string(), request.obstacles},
                    request.format.packing());
    if (!opened) return std::move(opened).error();
    output.emplace(std::move(opened).value());
  }
  ProgressBar progress(!request.quiet);
  auto mission = mission_to_fly(request);
  if (!mission) return std::move(mission).error();
  if (request.has_fleet) {
    return simulate_fleet(request, std::move(mission).value(), output ? &*output : nullptr);
  }
  SimulatedFlight flight(request, std::move(mission).value(), output ? &*output : nullptr);
  const Status flown = flight.fly(progress);
  if (!flown && output && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!flown) return flown.error();
  progress.finish();
  if (request.json) {
    const ExitCode written = print(simulate_json(flight));
    if (written != ExitCode::kFine) return written;
  }
  if (!request.quiet) say(simulate_summary(flight));
  return request.fail_on_risk && !flight.holds() ? ExitCode::kRiskFound : ExitCode::kFine;
}

// Random swaps, one after the other, closer and closer together: whether all hold.
Result<bool> fly_sweep(const SimulateRequest& request, io::JsonWriter& json) {
  constexpr double kSpacings[] = {3.0, 2.5, 2.0, 1.75, 1.5};  // in thresholds
  bool all_hold = true;
  for (const double spacing : kSpacings) {
    SimulateRequest swap = request;
    swap.scenario = "random-swap";
    swap.spacing_m = spacing * request.loop.advice.threshold_m;
    ProgressBar progress(!request.quiet);
    auto mission = mission_to_fly(swap);
    if (!mission) return std::move(mission).error();
    SimulatedFlight flight(swap, std::move(mission).value(), nullptr);
    if (const Status flown = flight.fly(progress); !flown) return flown.error();
    progress.finish();
    all_hold = all_hold && flight.holds();
    write_run(json, flight);
    if (!request.quiet) say(sweep_row(flight));
  }
  return all_hold;
}

Result<ExitCode> sweep(const SimulateRequest& request) {
  if (!request.quiet) say(sweep_head(request));
  std::string document;
  io::JsonWriter json(document);
  begin_sweep(json);
  const auto all_hold = fly_sweep(request, json);
  end_sweep(json);
  if (!all_hold) return all_hold.error();
  if (request.json) {
    const ExitCode written = print(document + '\n');
    if (written != ExitCode::kFine) return written;
  }
  return request.fail_on_risk && !*all_hold ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace

Result<ExitCode> run_simulate(const SimulateRequest& request) {
  return request.scenario == kDensitySweep ? sweep(request) : simulate(request);
}

}  // namespace beespace::cli
