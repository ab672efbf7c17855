#include "cli/recorded/verify_command.hpp"

#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/recorded/coarse_places.hpp"
#include "analysis/recorded/common_times.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/recorded/earth_flights.hpp"
#include "analysis/recorded/gaps.hpp"
#include "analysis/recorded/kept_by_height.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/verify_paths.hpp"
#include "analysis/text/unit_notes.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/input/obstacle_file.hpp"
#include "cli/output/output_file.hpp"
#include "cli/recorded/flight_check.hpp"
#include "cli/recorded/path_findings.hpp"
#include "cli/recorded/path_summary.hpp"
#include "cli/recorded/verify_findings.hpp"
#include "cli/recorded/verify_steps.hpp"
#include "io/bytes/number_text.hpp"
#include "io/load_recording.hpp"

#include <beespace/verify.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
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

// Commits what was written, and says what was found.
Result<ExitCode> conclude(io::AtomicOutput& output, ProgressBar& progress, bool quiet, bool holds,
                          const std::function<std::string()>& summary) {
  const Status written = output.commit();
  if (!written && output.pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  progress.finish();
  if (!quiet) say(summary());
  return holds ? ExitCode::kFine : ExitCode::kRiskFound;
}

bool has_curves(const io::Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return bee.path.has_value(); });
}

// Bees with fixes at times of their own, of which each has more than one; in degrees, some has.
bool goes_along_curves(const io::Recording& recording) {
  const auto flies = [](const io::RecordedBee& bee) { return bee.fixes.size() > 1; };
  const auto& bees = recording.bees;
  return recording.frame == io::Frame::kMetres ? std::all_of(bees.begin(), bees.end(), flies)
                                               : std::any_of(bees.begin(), bees.end(), flies);
}

// Of what only curves can be checked for.
bool asks_of_curves(const AskedLimits& limits) {
  return std::any_of(kPathLimitWords.begin(), kPathLimitWords.end(), [&](const auto& words) {
    return words.limit != PathLimit::kSpeed && words.limit != PathLimit::kAcceleration &&
           limits[static_cast<std::size_t>(words.limit)];
  });
}

// Of NED tables z counts downward: no limit of height would ever be exceeded.
Status check_upward(const io::Recording& recording) {
  double lowest_m = std::numeric_limits<double>::infinity();
  double highest_m = -lowest_m;
  for (const io::RecordedBee& bee : recording.bees) {
    for (const Fix& fix : bee.fixes) {
      lowest_m = std::min(lowest_m, fix.position.z);
      highest_m = std::max(highest_m, fix.position.z);
    }
  }
  // What an estimator says of who stands at the origin wavers by less.
  constexpr double kWavers_m = 1.0;
  if (!(lowest_m < -2.0 * kWavers_m && highest_m < kWavers_m)) return std::monostate{};
  return Error{ErrorCode::kInvalidArgument,
               "no z is above " + io::exact(kWavers_m) + " m, and the least is " +
                   io::exact(std::ceil(lowest_m * 10.0) / 10.0) +
                   " m: if z counts downward, as in NED, --max-height would hold whatever is "
                   "flown; turn the sign of that column, and of its velocity, in the table",
               {}};
}

// What autopilots log counts above the sea, and a limit of height is meant above the ground: one
// below which no drone ever is was meant so.
Status check_height_limit(const io::Recording& recording, std::optional<double> most_m) {
  const bool above_sea = recording.heights == io::HeightDatum::kMeanSeaLevel ||
                         recording.heights == io::HeightDatum::kEllipsoid;
  if (!most_m) return std::monostate{};
  if (recording.frame == io::Frame::kMetres && !recording.show) return check_upward(recording);
  if (!recording.of_drones || !above_sea) return std::monostate{};
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const io::RecordedBee& bee : recording.bees) {
    for (const Fix& fix : bee.fixes) lowest_m = std::min(lowest_m, fix.position.z);
  }
  if (lowest_m <= *most_m) return std::monostate{};
  const double ground_m = std::floor(lowest_m * 10.0) / 10.0;
  return Error{ErrorCode::kInvalidArgument,
               "heights here count " + std::string(analysis::datum_text(recording.heights)) +
                   ", and none is below " + io::exact(ground_m) +
                   " m, so --max-height would be exceeded even on the ground; for " +
                   io::exact(*most_m) + " m above that say --max-height " +
                   io::exact(ground_m + *most_m) + "m",
               {}};
}

Status check_curves(const io::Recording& recording, const VerifyRequest& request) {
  if (request.check.straight && has_curves(recording)) {
    return Error{ErrorCode::kInvalidArgument,
                 "drones of a show fly along their curves; leave --straight out",
                 {}};
  }
  for (const PathLimit limit : {PathLimit::kClimb, PathLimit::kDescent, PathLimit::kHeight}) {
    const auto which = static_cast<std::size_t>(limit);
    if (!recording.flat || !request.limits[which]) continue;
    return Error{ErrorCode::kMissingColumn,
                 std::string("the input has no heights, and so nothing is known of what ") +
                     kPathLimitWords[which].option + " limits; leave it out",
                 {}};
  }
  return check_height_limit(recording,
                            request.limits[static_cast<std::size_t>(PathLimit::kHeight)]);
}

// Some formats of shows have places alone, others curves between them.
std::string motion_of_show(const io::Recording& recording) {
  const bool bends =
      std::any_of(recording.bees.begin(), recording.bees.end(), [](const io::RecordedBee& bee) {
        if (!bee.path) return false;
        const auto& pieces = bee.path->pieces;
        return std::any_of(pieces.begin(), pieces.end(),
                           [](const BezierPiece& piece) { return piece.control_count > 0; });
      });
  return bends ? "along the curves of the show" : "along the straight lines of the show";
}

// Of flights in degrees; sets `check.straight` where there is no other way.
std::string motion_on_earth(const io::Recording& recording, VerifyOptions& check) {
  if (check.straight) return "straight lines from fix to fix (--straight)";
  check.straight = !analysis::logs_velocities(recording);
  return check.straight
             ? "straight lines from fix to fix: there are no velocities; accelerations are those "
               "of the turns at fixes"
             : "straight lines from fix to fix, and curves with the velocities; accelerations are "
               "those of the velocities";
}

// Of limits that need not be looked at: they must be those of this show, so that a mistyped one is
// none.
Status check_skipped(const io::Recording& recording, const std::vector<std::string>& skipped) {
  const std::vector<std::string> known = analysis::skippable_limits(recording);
  for (const std::string& name : skipped) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    return usage_error(kVerify, "--skip-limits names '" + name +
                                    "', but of limits that are not looked at the input declares " +
                                    (known.empty() ? "none" : joined(known, ", ") + " alone"));
  }
  return std::monostate{};
}

// Between fixes in straight lines nothing is known of accelerations. A show that is one is flown
// so.
bool needs_velocities(const VerifyRequest& request) {
  return request.check.max_acceleration_mps2 < VerifyOptions{}.max_acceleration_mps2;
}

// Along curves, each bee with times of its own.
Result<ExitCode> verify_along_curves(const VerifyRequest& request, const io::Recording& recording,
                                     const ObstacleMap& obstacles, io::AtomicOutput& output,
                                     ProgressBar& progress, Stopwatch& watch) {
  const MovingRequest& moving = request.moving;
  VerifyOptions check = request.check;
  if (Status good = check_curves(recording, request); !good) return good.error();
  const bool curves = has_curves(recording);
  const bool on_earth = recording.frame == io::Frame::kWgs84;
  auto motion = curves ? Result<std::string>(motion_of_show(recording))
                : on_earth
                    ? Result<std::string>(motion_on_earth(recording, check))
                    : settle_motion(recording, !recording.show && needs_velocities(request), check);
  if (!motion) return motion.error();
  const analysis::MaxGap max_gap = analysis::max_gap_of(recording, request.max_gap_s);
  const SettledLimits limits = settle_limits(request.limits, recording.show);
  analysis::PathQuestion question;
  question.with_velocities = !curves && !check.straight;
  question.threshold_m = moving.threshold_m.value_or(
      analysis::default_threshold(recording, kDefaultVerified_m).metres);
  question.vertical = moving.vertical;
  question.ignore_below_m = moving.ignore_below_m;
  question.max_gap_s = max_gap.seconds;
  if (!request.obstacles.empty()) question.obstacles = &obstacles;
  question.clearance_m = check.clearance_m;
  question.limits = limits.limits;
  question.skipped_limits = request.skipped_limits;
  question.threads = moving.threads;
  const double read_s = watch.lap();

  progress.enter_stage("checking");
  const auto verdict = analysis::verify_paths(
      recording, question, [&progress](double share) { progress.set_share(share); });
  if (!verdict) return verdict.error();
  analysis::Coverage coverage = analysis::coverage_of(recording, verdict->gaps, max_gap);
  analysis::judge_places(recording, analysis::coarse_question(*verdict, question), coverage);
  if (!question.vertical) {
    const Status good = analysis::judge_heights(recording,
                                                {.threshold_m = question.threshold_m,
                                                 .max_gap_s = question.max_gap_s,
                                                 .threads = question.threads,
                                                 .stop = question.stop},
                                                verdict->losses, verdict->low.left_out, coverage);
    if (!good) return good.error();
  }
  const PathFindings findings{recording, question,           limits, *verdict,
                              coverage,  *std::move(motion), read_s, watch.lap()};
  const auto head = [&](io::JsonWriter& json) { write_verdict(json, findings, moving); };
  write_answer(finding_rows(findings), moving, head, "findings", output);
  return conclude(output, progress, moving.quiet, findings.holds(),
                  [&] { return verify_summary(findings, moving); });
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
  if (auto doubt = analysis::doubt_of_scale(*recording, load.frame, moving.threshold)) {
    return *std::move(doubt);
  }
  if (auto needed = analysis::threshold_needed(*recording, moving.threshold, moving.vertical)) {
    return *std::move(needed);
  }
  if (Status flight = check_flight(*recording, moving); !flight) {
    return flight.error();
  }
  if (Status good = check_frame(*recording, request.obstacles); !good) return good.error();
  if (Status good = check_skipped(*recording, request.skipped_limits); !good) return good.error();
  const bool asked = has_curves(*recording) || recording->show || moving.vertical ||
                     moving.ignore_below_m || asks_of_curves(request.limits);
  const auto times_s = asked ? Result<std::vector<double>>(std::vector<double>())
                             : analysis::common_times(*recording);
  // In steps nothing is known of who stands on the ground, and logs are judged as by `replay`.
  const bool lands = recording->bees.size() > 1 &&
                     (recording->of_drones || analysis::says_who_has_landed(*recording));
  if (asked || ((!times_s || lands) && goes_along_curves(*recording))) {
    return verify_along_curves(request, *recording, *obstacles, *output, progress, watch);
  }
  if (!times_s) return times_s.error();
  VerifyOptions check = request.check;
  const auto motion = settle_motion(*recording, needs_velocities(request), check);
  if (!motion) return motion.error();
  check.threshold_m = moving.threshold_m.value_or(
      analysis::default_threshold(*recording, kDefaultVerified_m).metres);
  if (!request.obstacles.empty()) check.obstacles = &*obstacles;
  const double read_s = watch.lap();

  progress.enter_stage("checking");
  const analysis::MaxGap max_gap = analysis::max_gap_of(*recording, request.max_gap_s);
  const auto verdict = verify_steps(*recording, *times_s, check, max_gap.seconds, progress);
  if (!verdict) return verdict.error();
  analysis::Coverage coverage = analysis::coverage_of(
      *recording, gaps_of_all(*recording, *times_s, max_gap.seconds), max_gap);
  analysis::judge_places(*recording, {check.threshold_m, verdict->losses > 0, verdict->closest_m},
                         coverage);
  if (verdict->losses == 0) {
    const Status good = analysis::judge_heights(
        *recording,
        {.threshold_m = check.threshold_m, .max_gap_s = max_gap.seconds, .threads = moving.threads},
        {}, {}, coverage);
    if (!good) return good.error();
  }
  const Verification verification{*recording, *times_s, check,  *verdict,
                                  coverage,   *motion,  read_s, watch.lap()};
  const auto head = [&](io::JsonWriter& json) { write_verdict(json, verification, moving); };
  write_answer(finding_rows(verification), moving, head, "findings", *output);
  return conclude(*output, progress, moving.quiet, verification.holds(),
                  [&] { return verify_summary(verification, moving); });
}

}  // namespace beespace::cli
