#include "cli/recorded/replay_command.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/recorded/above_fl410.hpp"
#include "analysis/recorded/all_conflicts.hpp"
#include "analysis/recorded/coarse_places.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/kept_by_height.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/low_conflicts.hpp"
#include "analysis/recorded/tracks.hpp"
#include "analysis/recorded/velocity_curves.hpp"
#include "analysis/text/bee_name.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/coverage_output.hpp"
#include "cli/output/output_file.hpp"
#include "cli/recorded/flight_check.hpp"
#include "cli/recorded/replay_answer.hpp"
#include "cli/recorded/replay_events.hpp"
#include "cli/recorded/replay_rows.hpp"
#include "cli/recorded/replay_summary.hpp"
#include "io/bytes/atomic_output.hpp"
#include "io/bytes/number_text.hpp"
#include "io/load_recording.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kReplay = "replay";

// A show: no drone is out of sight in it.
bool is_plan(const io::Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return bee.path.has_value(); });
}

// Events are lines of JSON, as `watch` prints them, unless another form is asked for. A bee is
// silent where every report has a gap of the recording; `watch` cannot know what is typical of
// reports to come.
Status write_events(const ReplayRequest& request, const analysis::Findings& findings,
                    double threshold_m, const JsonHead& head, io::AtomicOutput& output) {
  // A show is a plan: what lies ahead need not be guessed.
  const bool plan = is_plan(findings.recording);
  const double max_age_s = std::min(findings.coverage.max_gap.seconds, kLargestInMotion);
  const analysis::Geometry geometry =
      analysis::geometry_for(findings.recording, request.moving.vertical);
  const SwarmOptions options{
      .threshold_m = threshold_m,
      .vertical_m = vertical_in(geometry, request.moving.vertical, findings.recording.height_unit),
      .heights_apart = heights_apart(geometry),
      .leave_factor = request.live.leave_factor,
      .horizon_s = plan ? 0.0 : request.live.horizon_s,
      .max_age_s = max_age_s,
      .threads = request.moving.threads,
      .height_unit_m = height_unit_m(geometry, findings.recording.height_unit),
      .max_agents = std::max(SwarmOptions{}.max_agents, findings.tracks.size())};
  const auto events =
      events_of(findings.recording, findings.tracks, geometry, options,
                {request.live.look_every_s, default_max_skew_s(max_age_s)}, findings.with_standing);
  if (!events) return events.error();
  if (request.moving.form.form == Form::kText) {
    output.write(events->lines);
  } else {
    write_answer(events->rows, request.moving, head, "events", output);
  }
  return std::monostate{};
}

// Rows of --report separation are kept until all are there.
Status check_every(const ReplayRequest& request, const std::vector<Track>& tracks) {
  constexpr double kMostRows = 10'000'000;
  const auto time = analysis::time_of(tracks);
  if (request.report != "separation" || !time) return std::monostate{};
  if ((time->ends_s - time->begins_s) / request.every_s <= kMostRows) return std::monostate{};
  return usage_error(kReplay, "--every " + io::exact(request.every_s) + " is more than " +
                                  io::grouped(static_cast<std::uint64_t>(kMostRows)) +
                                  " rows for this recording; look less often");
}

// Without those of pairs that are in conflict anyway; both are in the order of the pairs.
std::vector<Conflict> of_other_pairs(std::vector<Conflict> some,
                                     const std::vector<Conflict>& conflicts) {
  const auto by_pair = [](const Conflict& a, const Conflict& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  };
  std::erase_if(some, [&](const Conflict& one) {
    return std::binary_search(conflicts.begin(), conflicts.end(), one, by_pair);
  });
  return some;
}

}  // namespace

Result<ExitCode> run_replay(const ReplayRequest& request) {
  const MovingRequest& moving = request.moving;
  auto output = open_output(kReplay, moving.output, moving.inputs, moving.form.packing);
  if (!output) return std::move(output).error();
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
  const analysis::Geometry geometry = analysis::geometry_for(*recording, moving.vertical);
  auto tracks = tracks_of(*recording, geometry, request.tolerance_m);
  if (!tracks) return tracks.error();
  const analysis::MaxGap max_gap = analysis::max_gap_of(*recording, request.max_gap_s);
  analysis::keep_paths_whole(*recording, max_gap.seconds, *tracks);
  if (Status few = check_every(request, *tracks); !few) return few.error();
  const double read_s = watch.lap();

  progress.enter_stage("searching");
  const double threshold_m = moving.threshold_m.value_or(
      analysis::default_threshold(*recording, kDefaultThreshold_m).metres);
  const ConflictOptions options{
      .threshold_m = threshold_m,
      .vertical_m = vertical_in(geometry, moving.vertical, recording->height_unit),
      .inclusive = moving.inclusive,
      .max_gap_s = max_gap.seconds,
      .threads = moving.threads,
      .max_results = moving.max_results,
      .height_unit_m = height_unit_m(geometry, recording->height_unit)};
  auto found = analysis::all_conflicts(*recording, *tracks, geometry, options, request.straight);
  if (!found) return in_words_of_the_command(found.error(), moving);
  analysis::LowConflicts low;
  if (moving.ignore_below_m) {
    low = analysis::leave_out_low(*recording, *moving.ignore_below_m, found->recorded.conflicts);
    analysis::leave_out_too(low, found->with_standing);
  } else if (!moving.quiet) {
    low.would_leave_out =
        analysis::would_leave_out_low(*recording, threshold_m, found->recorded.conflicts);
  }
  const double search_s = watch.lap();

  const bool apart = heights_apart(geometry);
  const auto in_space =
      apart ? tracks_of(*recording, analysis::Geometry::kSpace, request.tolerance_m) : tracks;
  if (!in_space) return in_space.error();
  analysis::Coverage coverage = analysis::coverage_of(*recording, found->recorded.gaps, max_gap);
  analysis::judge_places(
      *recording, analysis::coarse_question(options, found->recorded.conflicts, found->closest),
      coverage);
  analysis::Findings findings{*recording,
                              *tracks,
                              *in_space,
                              found->recorded,
                              found->closest,
                              coverage,
                              analysis::has_encounters(*found, *recording, *in_space, options)};
  findings.with_standing = std::move(found->with_standing);
  findings.low = std::move(low);
  findings.closest_in_the_air = found->closest_in_the_air;
  findings.curves = &found->curves;
  findings.chords = found->chords;
  findings.arcs = &found->arcs;
  auto above = analysis::closer_above_fl410(*recording, *tracks, moving.vertical, options);
  if (!above) return in_words_of_the_command(above.error(), moving);
  findings.above_fl410 = of_other_pairs(*std::move(above), found->recorded.conflicts);
  auto kept = analysis::kept_by_height(*recording, options, request.tolerance_m,
                                       found->recorded.conflicts, findings.low.left_out);
  if (!kept) return in_words_of_the_command(kept.error(), moving);
  findings.kept_by_height = *std::move(kept);
  const bool of_drones = recording->show || recording->of_drones || recording->called_drones;
  if (request.report == "bees" && of_drones && !moving.vertical) {
    auto each = analysis::closest_of_each_flying(*recording, *tracks, threshold_m, max_gap.seconds,
                                                 moving.threads);
    if (!each) return each.error();
    findings.closest_of_each = *std::move(each);
  }
  Distances distances = distances_of(moving, *recording, threshold_m);
  if (moving.vertical) {
    distances.apart = analysis::apart_along(*tracks, found->curves, found->arcs,
                                            height_unit_m(geometry, recording->height_unit));
    distances.worst = analysis::worst_along(*tracks, found->curves, found->arcs,
                                            height_unit_m(geometry, recording->height_unit),
                                            {threshold_m, *moving.vertical_m});
    // Along curves heights are not straight in time, too.
    distances.least_height = [along_lines = analysis::least_height_of(
                                  *tracks, height_unit_m(geometry, recording->height_unit)),
                              curved = !found->curves.tracks.empty()](const Conflict& conflict) {
      return curved && !conflict.certain ? std::nullopt : along_lines(conflict);
    };
  }
  progress.enter_stage("writing");
  const JsonHead head = [&](io::JsonWriter& json) {
    write_findings(json, findings, request, threshold_m, distances);
  };
  if (request.report == "events") {
    const Status done = write_events(request, findings, threshold_m, head, *output);
    if (!done) return done.error();
  } else {
    write_answer(rows_of(request, findings, distances), moving, head, request.report.c_str(),
                 *output);
  }
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  progress.finish();
  if (!moving.quiet) {
    say(replay_summary(findings, moving, {threshold_m, read_s, search_s}, distances));
  }
  const bool risk = moving.fail_on_risk && findings.is_risky();
  return risk ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace beespace::cli
