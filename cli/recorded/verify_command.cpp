#include "cli/recorded/verify_command.hpp"

#include "analysis/recorded/common_times.hpp"
#include "analysis/recorded/gaps.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/input/obstacle_file.hpp"
#include "cli/output/output_file.hpp"
#include "cli/recorded/flight_check.hpp"
#include "cli/recorded/verify_findings.hpp"
#include "cli/recorded/verify_steps.hpp"
#include "io/bytes/number_text.hpp"
#include "io/load_recording.hpp"

#include <beespace/verify.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kVerify = "verify";
// Where neither an option nor the input says what is too close.
constexpr double kDefaultVerified_m = 5.0;

// How bees fly from fix to fix, in words; sets `check.straight` where there is no other way.
Result<std::string> settle_motion(const io::Recording& recording, bool accelerations,
                                  VerifyOptions& check) {
  if (check.straight) return std::string("straight lines from fix to fix (--straight)");
  const auto missing = analysis::missing_velocity(recording);
  if (!missing) {
    return std::string("curves from fix to fix, with the velocities at both: evenly accelerated");
  }
  const io::RecordedBee& bee = recording.bees[missing->bee];
  if (accelerations) {
    return Error{ErrorCode::kMissingColumn,
                 "--max-acceleration needs velocities, and bee '" + bee.id + "' has none at " +
                     io::exact(bee.fixes[missing->fix].time_s) +
                     " s; give velocities (columns vx, vy, vz; or ve, vn, vu beside degrees), or "
                     "leave the option out",
                 {}};
  }
  check.straight = true;
  std::size_t fixes = 0;
  for (const io::RecordedBee& any : recording.bees) fixes += any.fixes.size();
  if (missing->count == fixes) {
    return std::string("straight lines from fix to fix: there are no velocities");
  }
  return "straight lines from fix to fix: " +
         red(io::grouped(missing->count) + " of " + io::grouped(fixes) + " fixes have no velocity");
}

// Obstacles are upright: they make no sense beside degrees.
Status check_frame(const io::Recording& recording, const std::string& obstacles) {
  if (obstacles.empty() || recording.frame == io::Frame::kMetres) return std::monostate{};
  return Error{ErrorCode::kUnknownFrame,
               "obstacles are in metres, and the flight is in degrees; give the flight in metres, "
               "or leave --obstacles out",
               {}};
}

}  // namespace

Result<ExitCode> run_verify(const VerifyRequest& request) {
  const MovingRequest& moving = request.moving;
  std::vector<std::string> inputs = moving.inputs;
  inputs.push_back(request.obstacles);
  auto output = open_output(kVerify, moving.output, inputs, moving.form.packing);
  if (!output) return std::move(output).error();
  const auto obstacles = request.obstacles.empty() ? Result<ObstacleMap>(ObstacleMap())
                                                   : load_obstacle_map(request.obstacles);
  if (!obstacles) return obstacles.error();
  ProgressBar progress(!moving.quiet);
  Stopwatch watch;
  io::RecordingOptions load = moving.load;
  load.progress = &progress.reading();
  const auto recording = io::load_recording(moving.inputs, load);
  if (!recording) return recording.error();
  if (Status flight = check_flight(*recording, moving.inputs.front()); !flight) {
    return flight.error();
  }
  if (Status good = check_frame(*recording, request.obstacles); !good) return good.error();
  const auto times_s = analysis::common_times(*recording);
  if (!times_s) return times_s.error();
  VerifyOptions check = request.check;
  const bool accelerations =
      request.check.max_acceleration_mps2 < VerifyOptions{}.max_acceleration_mps2;
  const auto motion = settle_motion(*recording, accelerations, check);
  if (!motion) return motion.error();
  check.threshold_m =
      moving.threshold_m.value_or(recording->declared_threshold_m.value_or(kDefaultVerified_m));
  if (!request.obstacles.empty()) check.obstacles = &*obstacles;
  const double read_s = watch.lap();

  progress.enter_stage("checking");
  const analysis::MaxGap max_gap = analysis::max_gap_of(*recording, request.max_gap_s);
  const auto verdict = verify_steps(*recording, *times_s, check, max_gap.seconds, progress);
  if (!verdict) return verdict.error();
  const analysis::Coverage coverage = analysis::coverage_of(
      *recording, gaps_of_all(*recording, *times_s, max_gap.seconds), max_gap);
  const Verification verification{*recording, *times_s, check,  *verdict,
                                  coverage,   *motion,  read_s, watch.lap()};
  const auto head = [&](io::JsonWriter& json) { write_verdict(json, verification, moving); };
  write_answer(finding_rows(verification), moving, head, "findings", *output);
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  progress.finish();
  if (!moving.quiet) say(verify_summary(verification, moving));
  return verification.holds() ? ExitCode::kFine : ExitCode::kRiskFound;
}

}  // namespace beespace::cli
