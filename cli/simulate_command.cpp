#include "cli/simulate_command.hpp"

#include "cli/failure.hpp"
#include "cli/progress_bar.hpp"
#include "cli/simulate_request.hpp"
#include "cli/simulate_summary.hpp"
#include "cli/standard_output.hpp"
#include "cli/stopwatch.hpp"
#include "cli/swarm_output.hpp"
#include "cli/terminal.hpp"
#include "io/atomic_output.hpp"
#include "sim/closed_loop.hpp"

#include <beespace/verify.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace beespace::cli {
namespace {

// Who is slower than this share of its greatest speed stands: the rest of the way is crept.
constexpr double kStands = 0.01;

bool have_landed(const sim::ClosedLoop& loop, const FlightLimits& limits) {
  if (loop.arrived() < loop.movers().size()) return false;
  const double most = kStands * limits.max_speed_mps;
  return std::all_of(loop.movers().begin(), loop.movers().end(), [most](const Mover& mover) {
    const Velocity& v = mover.velocity;
    return v.x * v.x + v.y * v.y + v.z * v.z <= most * most;
  });
}

VerifyOptions verify_options(const SimulateRequest& request) {
  VerifyOptions options;
  options.threshold_m = request.loop.advice.threshold_m;
  options.max_speed_mps = request.loop.limits.max_speed_mps;
  options.max_acceleration_mps2 = request.loop.limits.max_acceleration_mps2;
  options.straight = request.at_once();
  options.threads = request.loop.advice.threads;
  return options;
}

// What flies, who watches it, and who writes it down.
class Simulation {
 public:
  Simulation(const SimulateRequest& request, scenes::Mission mission, io::AtomicOutput* output)
      : request_(request),
        loop_(std::move(mission), request.loop),
        verifier_(verify_options(request)),
        output_(output) {
    if (output == nullptr) return;
    // Velocities that jump at each fix say nothing of how a bee flies between two.
    writer_.emplace(*output, request.format, !request.at_once());
  }

  // To the end, or until the output takes no more.
  Status fly(ProgressBar& progress) {
    progress.enter_stage("flying");
    Stopwatch total;
    if (Status seen = see(); !seen) return seen;
    figures_.landed = have_landed(loop_, request_.loop.limits);
    while (figures_.steps < request_.most_steps && !figures_.landed) {
      if (output_ != nullptr && output_->failed()) break;
      if (Status flown = loop_.step(); !flown) return flown;
      ++figures_.steps;
      figures_.uncertified += loop_.advised().too_close.size();
      if (Status seen = see(); !seen) return seen;
      figures_.landed = have_landed(loop_, request_.loop.limits);
      progress.set_share(share_done());
    }
    figures_.total_s = total.lap();
    return writer_ ? writer_->finish() : Status(std::monostate());
  }

  [[nodiscard]] const sim::ClosedLoop& loop() const { return loop_; }
  [[nodiscard]] const Verdict& verdict() const { return verifier_.verdict(); }
  [[nodiscard]] const FlightFigures& figures() const { return figures_; }

 private:
  Status see() {
    const std::uint64_t losses = verdict().losses;
    if (Status seen = verifier_.add(loop_.time_s(), loop_.movers()); !seen) return seen;
    if (verdict().losses > losses) ++figures_.steps_with_losses;
    if (writer_) writer_->add(loop_.time_s(), loop_.movers());
    return std::monostate{};
  }

  // It ends with the last step, or when all have arrived.
  [[nodiscard]] double share_done() const {
    const auto share = [](std::uint64_t some, std::uint64_t all) {
      return static_cast<double>(some) / static_cast<double>(all);
    };
    return std::max(share(figures_.steps, request_.most_steps),
                    share(loop_.arrived(), request_.bees));
  }

  const SimulateRequest& request_;
  sim::ClosedLoop loop_;
  Verifier verifier_;
  io::AtomicOutput* output_;
  std::optional<FlightWriter> writer_;
  FlightFigures figures_;
};

Result<ExitCode> simulate(const SimulateRequest& request) {
  std::optional<io::AtomicOutput> output;
  if (!request.output.empty()) {
    auto opened = io::AtomicOutput::open(request.output);
    if (!opened) return std::move(opened).error();
    output.emplace(std::move(opened).value());
  }
  ProgressBar progress(!request.quiet);
  auto mission = mission_of(request);
  if (!mission) return std::move(mission).error();
  Simulation simulation(request, std::move(mission).value(), output ? &*output : nullptr);
  const Status flown = simulation.fly(progress);
  if (!flown && output && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!flown) return flown.error();
  progress.finish();
  const auto& verdict = simulation.verdict();
  if (request.json) {
    const ExitCode written =
        print(simulate_json(request, simulation.loop(), verdict, simulation.figures()));
    if (written != ExitCode::kFine) return written;
  }
  if (!request.quiet) {
    say(simulate_summary(request, simulation.loop(), verdict, simulation.figures()));
  }
  return request.fail_on_risk && !verdict.holds() ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace

ExitCode run_simulate(const SimulateOptions& options) {
  const auto request = simulate_request(options);
  if (!request) return fail(request.error(), options.json);
  const auto code = simulate(*request);
  return code ? *code : fail(code.error(), options.json);
}

}  // namespace beespace::cli
