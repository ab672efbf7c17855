#include "cli/recorded/predict_command.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/recorded/above_fl410.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/created_flights.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/last_climb.hpp"
#include "analysis/recorded/last_snapshot.hpp"
#include "analysis/recorded/usual_horizon.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/recipe_text.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/coverage_output.hpp"
#include "cli/output/output_file.hpp"
#include "io/bytes/number_text.hpp"
#include "io/load_recording.hpp"
#include "io/recording/moment_text.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/predict_conflicts.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kPredict = "predict";

// Those of the horizon, and of the bees that are known for the present moment only those of now:
// between movers and snapshot.present().
Result<std::vector<Conflict>> conflicts_of(const analysis::Snapshot& snapshot,
                                           const PredictOptions& options) {
  auto conflicts = predict_conflicts(snapshot.view(), options);
  if (!conflicts || snapshot.unmoving.empty()) return conflicts;
  PredictOptions now = options;
  now.horizon_s = 0.0;
  const auto present = predict_conflicts(snapshot.present().view(), now);
  if (!present) return present.error();
  for (const Conflict& conflict : *present) {
    // The second one is the later: where it is a mover both are.
    if (conflict.second >= snapshot.movers.size()) conflicts->push_back(conflict);
  }
  if (conflicts->size() > options.max_results) {
    return Error{ErrorCode::kTooManyResults, "there are too many conflicts", {}};
  }
  return conflicts;
}

// The same of aircraft that are created one after the other, from the first on.
Result<std::vector<Conflict>> conflicts_of(const std::vector<Track>& flights,
                                           const PredictOptions& options) {
  auto found = find_conflicts(flights, {.threshold_m = options.threshold_m,
                                        .vertical_m = options.vertical_m,
                                        .inclusive = options.inclusive,
                                        .threads = options.threads,
                                        .max_results = options.max_results,
                                        .height_unit_m = options.height_unit_m});
  if (!found) return std::move(found).error();
  return std::move(found->conflicts);
}

// Conflicts name bees of the recording, and times are those of its clock.
void translate(std::vector<Conflict>& conflicts, const analysis::Snapshot& snapshot) {
  const std::vector<std::uint32_t> bees = snapshot.present().bees;
  for (Conflict& conflict : conflicts) {
    const PointId first = bees[conflict.first];
    const PointId second = bees[conflict.second];
    conflict.first = std::min(first, second);
    conflict.second = std::max(first, second);
    conflict.begins_s += snapshot.time_s;
    conflict.closest_s += snapshot.time_s;
    conflict.ends_s += snapshot.time_s;
  }
  std::sort(conflicts.begin(), conflicts.end(), [](const Conflict& a, const Conflict& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
}

struct Prediction {
  const io::Recording& recording;
  const analysis::Snapshot& snapshot;
  double threshold_m;
  const std::vector<Conflict>& conflicts;
  const Distances& distances;
  std::optional<double> looked_since_s;  // where that is before now
  double horizon_s;
  // Of a recording: since when it lasts, of which only what lies behind its end is looked at.
  std::optional<double> recorded_since_s;

  // Whether there are two, as far as they are known.
  [[nodiscard]] bool compares() const {
    return snapshot.movers.size() + snapshot.unmoving.size() > 1;
  }
  // Whether it is known of every bee where it goes, and all of the time was looked at.
  [[nodiscard]] bool complete() const { return bees_are_known() && !snapshot.passed_over_since_s; }
  [[nodiscard]] bool bees_are_known() const {
    return snapshot.stale == 0 && snapshot.unmoving.empty() && recording.missing.none();
  }
};

// Whom the conflicts do not cover.
std::string unknown_text(const Prediction& prediction) {
  std::string text;
  const auto append = [&text](const std::string& more) {
    if (!text.empty() && !more.empty()) text += ", ";
    text += more;
  };
  if (const std::uint64_t count = prediction.snapshot.unmoving.size(); count > 0) {
    append(io::grouped(count) + (count == 1 ? " bee is" : " bees are") + " checked for now only");
  }
  if (const std::uint64_t count = prediction.snapshot.stale; count > 0) {
    append(io::grouped(count) + (count == 1 ? " bee is" : " bees are") + " left out");
  }
  append(analysis::missing_text(prediction.recording.missing));
  append(analysis::passed_over_text(prediction.snapshot, prediction.recording));
  return text;
}

// What is said is not of the recording itself.
std::string after_the_end(const Prediction& prediction) {
  return prediction.recorded_since_s ? " after the end of the recording" : "";
}

std::string found_line(const Prediction& prediction) {
  if (!prediction.compares()) {
    return red("nothing to compare") + ": fewer than two bees are known now" +
           (prediction.complete() ? "" : "; " + unknown_text(prediction));
  }
  if (prediction.conflicts.empty()) {
    if (prediction.complete()) return bold("none" + after_the_end(prediction));
    const std::string found =
        prediction.bees_are_known()
            ? "none from " + io::moment_text(prediction.snapshot.time_s, prediction.recording) +
                  " on"
            : "none of those that are known" + after_the_end(prediction);
    return bold(found) + "; " + unknown_text(prediction);
  }
  std::vector<PointId> bees;
  for (const Conflict& conflict : prediction.conflicts) {
    bees.push_back(conflict.first);
    bees.push_back(conflict.second);
  }
  std::sort(bees.begin(), bees.end());
  bees.erase(std::unique(bees.begin(), bees.end()), bees.end());
  return red(io::grouped(prediction.conflicts.size()) + ", of " + io::grouped(bees.size()) +
             " bees" + (prediction.recorded_since_s ? "," : "") + after_the_end(prediction)) +
         (prediction.complete() ? "" : "; " + unknown_text(prediction));
}

// Who is not known to go anywhere, and why.
void append_unmoving(std::string& out, const analysis::Snapshot& snapshot, double max_age_s) {
  const auto say_of = [&out](std::uint64_t count, const std::string& why) {
    if (count == 0) return;
    append_summary_line(
        out, "unknown",
        red(io::grouped(count) + " checked for now only") + ", where last heard of: " + why);
  };
  say_of(snapshot.unmoving.size() - snapshot.climbless - snapshot.level_only,
         "neither a velocity (speed, direction and climb) nor two fixes, at most " +
             io::exact(max_age_s) + " s apart, tell how fast they go");
  say_of(snapshot.level_only,
         "speed and direction are there, but no climb rate (baro_rate or geom_rate of "
         "aircraft.json, a column of a table), which one fix alone does not tell");
  say_of(snapshot.climbless, "neither a climb rate nor " + io::exact(analysis::kShortestClimb_s) +
                                 " s of heights, which go in steps, tell how fast they climb");
}

// Whose velocity is not the one of the last fix, and what it is of.
void append_estimates(std::string& out, const analysis::Snapshot& snapshot) {
  const auto say_of = [&out](std::uint64_t count, const std::string& what) {
    if (count > 0) append_summary_line(out, "note", io::grouped(count) + " without a " + what);
  };
  say_of(snapshot.estimated, "velocity: it is that of the last two fixes");
  say_of(snapshot.climbs.earlier, "climb rate: it is the last one known, " +
                                      io::exact(analysis::kClimbLasts_s) + " s before at most");
  say_of(snapshot.climbs.heights, "climb rate: it is that of the heights of up to " +
                                      io::exact(analysis::kLongestClimb_s) +
                                      " s, or of the last two where these are farther apart");
  say_of(snapshot.climbs.two_fixes, "climb rate: it is that of the last two fixes");
}

// Who was last heard of before now. Aircraft of a scenario are not heard of but created.
void append_ages(std::string& out, const Prediction& prediction, const PredictRequest& request) {
  const analysis::Snapshot& snapshot = prediction.snapshot;
  const bool created = prediction.recording.flies_on;
  if (snapshot.brought_forward > 0) {
    std::string text = io::grouped(snapshot.brought_forward);
    text += created ? " created before now" : " last heard of before now";
    text += snapshot.brought_forward == 1 ? " was" : " were";
    text += created ? " let fly on as created, for up to " : " brought forward, by up to ";
    text += io::grouped(snapshot.oldest_s, 2) + " s";
    if (created && prediction.looked_since_s) {
      text += "; conflicts are looked for from " +
              io::moment_text(*prediction.looked_since_s, prediction.recording) + " on";
    } else if (created) {
      text +=
          "; conflicts before now are not looked for: replay the log of the simulation (CRELOG)";
    }
    append_summary_line(out, "note", text);
  }
  if (snapshot.on_ground > 0) {
    append_summary_line(out, "landed",
                        io::grouped(snapshot.on_ground) +
                            " on the ground, as they say themselves: not compared with flyers");
  }
  if (snapshot.stale == 0) return;
  const std::string age = io::exact(request.max_age_s) + " s";
  append_summary_line(out, "stale",
                      red(io::grouped(snapshot.stale) + " left out") +
                          (created ? ", created more than " + age +
                                         " before now (--max-age), of which it is not known how "
                                         "they fly from there"
                                   : ", not heard of for " + age + " (--max-age)"));
}

// Since when a recording lasts; nothing of what is one moment, or begins where aircraft do.
std::optional<double> recorded_since(const io::Recording& recording) {
  if (recording.flies_on) return std::nullopt;
  std::optional<double> first_s;
  bool moves = false;
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.fixes.empty()) continue;
    const double of_this_s = bee.fixes.front().time_s;
    first_s = std::min(first_s.value_or(of_this_s), of_this_s);
    moves = moves || bee.fixes.size() > 1;
  }
  return moves ? first_s : std::nullopt;
}

// Of a recording, of which only what lies ahead of its end is looked at.
void append_passed(std::string& out, const Prediction& prediction, const PredictRequest& request) {
  if (!prediction.recorded_since_s) return;
  std::string text = "this is a recording of ";
  text += io::duration(prediction.snapshot.time_s - *prediction.recorded_since_s);
  text += ": only what lies ahead of its end is looked at; for the rest ask 'beespace replay";
  for (const std::string& input : request.moving.inputs) {
    if (input == "-") continue;
    text += ' ';
    text += printable(typed_name(input));
  }
  text += separation_typed(request.moving);
  append_summary_line(out, "note", text + "'");
}

// Whether the two are worst where the look ahead ends, so that they may come closer behind it.
bool is_closing_at_the_end(const Conflict& conflict, const Prediction& prediction) {
  constexpr double kRounded_s = 1e-6;
  const auto& worst = prediction.distances.worst;
  const auto moment = worst ? worst(conflict) : std::nullopt;
  const double at_s = moment ? moment->time_s : conflict.closest_s;
  return prediction.horizon_s > 0.0 && at_s > conflict.begins_s &&
         at_s >= prediction.snapshot.time_s + prediction.horizon_s - kRounded_s;
}

std::string when_text(double from_now_s) {
  if (from_now_s < 0.0) return io::grouped(-from_now_s, 2) + " s before now";
  return "in " + io::grouped(from_now_s, 2) + " s";
}

std::string summary(const Prediction& prediction, const PredictRequest& request, double search_s) {
  const analysis::Snapshot& snapshot = prediction.snapshot;
  std::string out = input_summary(prediction.recording, request.moving);
  const std::size_t all = prediction.recording.bees.size();
  append_summary_line(out, "bees",
                      io::grouped(snapshot.movers.size()) +
                          (snapshot.movers.size() < all ? " of " + io::grouped(all) : ""));
  append_summary_line(out, "now", io::moment_text(snapshot.time_s, prediction.recording));
  append_passed(out, prediction, request);
  append_ages(out, prediction, request);
  append_unmoving(out, snapshot, request.max_age_s);
  append_missing(out, prediction.recording.missing);
  append_estimates(out, snapshot);
  append_summary_line(out, "threshold",
                      separation_summary(request.moving, prediction.threshold_m,
                                         prediction.recording, prediction.distances.aviation));
  append_summary_line(out, "horizon", io::exact(prediction.horizon_s) + " s");
  append_traffic_hint(out, prediction.recording, request.moving, prediction.threshold_m);
  append_note(out, analysis::above_fl410_text(prediction.recording, prediction.threshold_m,
                                              request.moving.vertical));
  append_summary_line(out, "conflicts", found_line(prediction));
  const auto& conflicts = prediction.conflicts;
  if (!conflicts.empty()) {
    const auto soonest = std::min_element(
        conflicts.begin(), conflicts.end(),
        [](const Conflict& a, const Conflict& b) { return a.begins_s < b.begins_s; });
    const Conflict closest =
        analysis::pairs_in_conflict(conflicts, prediction.distances.worst).front().worst;
    append_summary_line(out, "soonest",
                        pair_text(*soonest, prediction.recording) + ", " +
                            when_text(soonest->begins_s - snapshot.time_s));
    append_summary_line(
        out, "closest",
        encounter_text(closest, prediction.recording, prediction.distances, Told::kConflict) +
            (is_closing_at_the_end(closest, prediction)
                 ? "; still closing at the horizon of " + io::exact(prediction.horizon_s) +
                       " s (--horizon)"
                 : ""));
  }
  append_summary_line(out, "time", "search " + io::duration(search_s));
  return out;
}

void write_outlook(io::JsonWriter& json, const Prediction& prediction,
                   const PredictRequest& request) {
  const analysis::Snapshot& snapshot = prediction.snapshot;
  write_head(json, prediction.recording, request.moving, prediction.threshold_m);
  json.member("now_s", snapshot.time_s).member("horizon_s", prediction.horizon_s);
  json.member("looked_since_s", prediction.looked_since_s.value_or(snapshot.time_s));
  json.key("not_looked_at");
  if (prediction.recorded_since_s) {
    json.begin_object().member("begins_s", *prediction.recorded_since_s);
    json.member("ends_s", snapshot.time_s).end();
  } else {
    json.null();
  }
  json.member("movers", snapshot.movers.size()).member("stale", snapshot.stale);
  json.member("on_ground", snapshot.on_ground);
  json.member("without_velocity", snapshot.unmoving.size());
  json.begin_object("known").member("complete", prediction.complete());
  write_missing(json, prediction.recording.missing);
  json.end();
  json.member("conflict_count", prediction.conflicts.size());
  if (!prediction.distances.worst) return;
  json.key("worst");
  const auto worst = worst_row(prediction.conflicts, prediction.recording, prediction.distances);
  if (!worst) return json.null();
  write_row(json, worst->columns, worst->rows.front());
}

}  // namespace

Result<ExitCode> run_predict(const PredictRequest& request) {
  const MovingRequest& moving = request.moving;
  auto output = open_output(kPredict, moving.output, moving.inputs, moving.form.packing);
  if (!output) return std::move(output).error();
  ProgressBar progress(!moving.quiet);
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
  const analysis::Geometry geometry = analysis::geometry_for(*recording, moving.vertical);
  auto snapshot =
      snapshot_of(*recording, geometry, request.max_age_s, analysis::Wanted::kMotionOrNow);
  if (!snapshot) return snapshot.error();

  progress.enter_stage("predicting");
  Stopwatch watch;
  const double threshold_m = moving.threshold_m.value_or(
      analysis::default_threshold(*recording, kDefaultThreshold_m).metres);
  const double horizon_s = request.horizon_s.value_or(analysis::usual_horizon_s(*recording));
  const PredictOptions options{
      .threshold_m = threshold_m,
      .vertical_m = vertical_in(geometry, moving.vertical, recording->height_unit),
      .horizon_s = horizon_s,
      .inclusive = moving.inclusive,
      .threads = moving.threads,
      .max_results = moving.max_results,
      .height_unit_m = height_unit_m(geometry, recording->height_unit)};
  const auto flights = analysis::created_flights(*recording, *snapshot, geometry, horizon_s);
  auto conflicts = flights ? conflicts_of(*flights, options) : conflicts_of(*snapshot, options);
  const std::optional<double> looked_since_s =
      flights ? std::exchange(snapshot->passed_over_since_s, std::nullopt) : std::nullopt;
  if (!conflicts) return in_words_of_the_command(std::move(conflicts).error(), moving);
  const double search_s = watch.lap();
  translate(*conflicts, *snapshot);

  Distances distances = distances_of(moving, *recording, threshold_m);
  if (moving.vertical) {
    distances.apart = apart_of(*snapshot, height_unit_m(geometry, recording->height_unit));
    // Times of conflicts lie within those of the outlook, in which all fly straight.
    distances.worst = worst_of(*snapshot, height_unit_m(geometry, recording->height_unit),
                               {threshold_m, *moving.vertical_m});
  }
  const Prediction prediction{*recording, *snapshot,      threshold_m, *conflicts,
                              distances,  looked_since_s, horizon_s,   recorded_since(*recording)};
  const auto head = [&](io::JsonWriter& json) { write_outlook(json, prediction, request); };
  write_answer(conflict_rows(*conflicts, *recording, false, distances), moving, head, "conflicts",
               *output);
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  progress.finish();
  if (!moving.quiet) {
    say(summary(prediction, request, search_s));
  }
  const bool risky = !conflicts->empty() || !prediction.complete() || !prediction.compares();
  return moving.fail_on_risk && risky ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace beespace::cli
