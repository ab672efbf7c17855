#include "cli/simulate/simulated_flight.hpp"

#include "cli/console/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::cli {
namespace {

// Who is slower than this share of its greatest speed stands: the rest of the way is crept.
constexpr double kStands = 0.01;

// Who has been stuck for so long is worth a word.
constexpr double kStuck_s = 1.0;

}  // namespace

SimulatedFlight::SimulatedFlight(const SimulateRequest& request, MissionToFly mission,
                                 io::AtomicOutput* output)
    : request_(request),
      limits_(mission.mission.limits),
      names_(std::move(mission.names)),
      notes_(std::move(mission.notes)),
      loop_(std::move(mission.mission), request.loop),
      verifier_(verify_options()),
      watch_(limits_, request.loop.advice),
      output_(output) {
  if (output == nullptr) return;
  // Velocities that jump at each fix say nothing of how a bee flies between two.
  writer_.emplace(*output, request.format, names_.ids, !at_once());
}

// Limits that each has of its own are for the watch.
VerifyOptions SimulatedFlight::verify_options() const {
  const AdviseOptions& advice = request_.loop.advice;
  VerifyOptions options;
  options.threshold_m = advice.threshold_m;
  options.obstacles = loop_.obstacles();
  options.clearance_m = advice.clearance_m;
  options.straight = at_once();
  options.threads = advice.threads;
  if (has_own_limits()) return options;
  options.max_speed_mps = request_.loop.limits.max_speed_mps;
  options.max_acceleration_mps2 = request_.loop.limits.max_acceleration_mps2;
  return options;
}

bool SimulatedFlight::at_once() const {
  return std::isinf(limits_.empty() ? request_.loop.limits.max_acceleration_mps2
                                    : limits_.front().max_acceleration_mps2);
}

Status SimulatedFlight::fly(ProgressBar& progress) {
  progress.enter_stage("flying");
  Stopwatch total;
  if (Status seen = see(); !seen) return seen;
  while (figures_.steps < request_.most_steps && !figures_.landed) {
    if (output_ != nullptr && output_->failed()) break;
    if (Status flown = loop_.step(); !flown) return flown;
    ++figures_.steps;
    figures_.uncertified_pairs += loop_.advised().too_close.size();
    figures_.uncertified_at_obstacles += loop_.advised().near_obstacle.size();
    if (Status seen = see(); !seen) return seen;
    progress.set_share(share_done());
  }
  figures_.total_s = total.lap();
  return writer_ ? writer_->finish() : Status(std::monostate());
}

Status SimulatedFlight::see() {
  const std::uint64_t losses = verdict().losses;
  if (Status seen = verifier_.add(loop_.time_s(), loop_.movers()); !seen) return seen;
  if (verdict().losses > losses) ++figures_.steps_with_losses;
  watch_.see(loop_);
  if (writer_) writer_->add(loop_.time_s(), loop_.movers());
  figures_.landed = have_landed();
  return std::monostate{};
}

bool SimulatedFlight::have_landed() const {
  const std::vector<Mover>& movers = loop_.movers();
  if (loop_.arrived() < movers.size()) return false;
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    const FlightLimits& limits = limits_.empty() ? request_.loop.limits : limits_[bee];
    const double most = kStands * limits.max_speed_mps;
    const Velocity& v = movers[bee].velocity;
    if (v.x * v.x + v.y * v.y + v.z * v.z > most * most) return false;
  }
  return true;
}

// It ends with the last step, or when all have arrived.
double SimulatedFlight::share_done() const {
  const auto share = [](std::uint64_t some, std::uint64_t all) {
    return static_cast<double>(some) / static_cast<double>(all);
  };
  return std::max(share(figures_.steps, request_.most_steps),
                  share(loop_.arrived(), loop_.movers().size()));
}

bool SimulatedFlight::holds() const {
  return verdict().holds() && watched().breaches == 0;
}

FlightOutcome SimulatedFlight::outcome() const {
  FlightOutcome outcome;
  double ratios = 0.0;
  std::size_t flown = 0;
  for (const sim::Flight& flight : loop_.flights()) {
    outcome.stuck_s += flight.stuck_s;
    // Who begins at its goal has no way to fly.
    if (!flight.arrived_s || !(*flight.arrived_s > 0.0)) continue;
    ratios += flight.flown_m / flight.shortest_m;
    ++flown;
  }
  const auto bees = static_cast<double>(loop_.flights().size());
  outcome.stuck_s /= bees;
  if (flown > 0) outcome.path_ratio = ratios / static_cast<double>(flown);
  if (figures_.steps > 0 && loop_.advising_s() > 0.0) {
    outcome.advice_us = loop_.advising_s() / bees / static_cast<double>(figures_.steps) * 1e6;
  }
  outcome.stuck = stuck();
  if (!outcome.stuck.empty()) outcome.longest_stuck_s = stuck_for(outcome.stuck.front());
  return outcome;
}

double SimulatedFlight::stuck_for(PointId bee) const {
  const auto& since_s = loop_.flights()[bee].stuck_since_s;
  return since_s ? loop_.time_s() - *since_s : 0.0;
}

std::vector<PointId> SimulatedFlight::stuck() const {
  std::vector<PointId> bees;
  for (PointId bee = 0; bee < loop_.flights().size(); ++bee) {
    if (stuck_for(bee) >= kStuck_s) bees.push_back(bee);
  }
  std::stable_sort(bees.begin(), bees.end(),
                   [this](PointId a, PointId b) { return stuck_for(a) > stuck_for(b); });
  return bees;
}

}  // namespace beespace::cli
