#include "cli/recorded/verify_findings.hpp"

#include "analysis/text/bee_name.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/coverage_output.hpp"
#include "cli/recorded/holding_words.hpp"
#include "io/bytes/number_text.hpp"
#include "io/obstacle_name.hpp"
#include "io/recording/moment_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace beespace::cli {
namespace {

const char* word_for(BreachKind kind) {
  return kind == BreachKind::kSpeed ? "speed" : "acceleration";
}

std::string times(std::uint64_t count, const char* one, const char* several) {
  return io::grouped(count) + " " + (count == 1 ? one : several);
}

std::string limits_text(const VerifyOptions& options) {
  std::string text;
  if (std::isfinite(options.max_speed_mps)) text = io::exact(options.max_speed_mps) + " m/s";
  if (std::isfinite(options.max_acceleration_mps2)) {
    text += (text.empty() ? "" : ", ") + io::exact(options.max_acceleration_mps2) + " m/s^2";
  }
  return text.empty() ? "not checked (--max-speed, --max-acceleration)" : text;
}

std::string closest_text(const Verification& verification, const MovingRequest& request) {
  const Verdict& verdict = verification.verdict;
  if (verification.recording.bees.size() == 1) return kNoPair;
  const double threshold_m = verification.options.threshold_m;
  const Distances distances = distances_of(request, verification.recording, threshold_m);
  if (!verdict.closest_m) {
    const bool small = distances.small != io::Unit::kUnstated;
    return "no two came closer than " + (small ? distance_text(2.0 * threshold_m, distances)
                                               : io::exact(2.0 * threshold_m) + " m");
  }
  const auto shown = [&](PointId bee) {
    return printable(text_of(analysis::name_of(bee, verification.recording)));
  };
  return shown(verdict.closest_pair->first) + " and " + shown(verdict.closest_pair->second) + ", " +
         distance_text(*verdict.closest_m, distances) + " apart in the step from " +
         io::moment_text(verdict.closest_step_s, verification.recording);
}

std::string found_text(std::uint64_t count, const char* one, const char* several) {
  if (count == 0) return bold("none");
  std::string text = red(times(count, one, several));
  if (count > Verdict::kMostShown) {
    text +=
        ", of which the answer has the first " + io::grouped(std::uint64_t{Verdict::kMostShown});
  }
  return text;
}

std::string verdict_text(const Verification& verification) {
  const Verdict& verdict = verification.verdict;
  const analysis::Coverage& coverage = verification.coverage;
  const std::string unknown = printable(analysis::unknown_text(coverage, &verification.recording));
  const HoldingWords holding(verification.recording.bees.size(),
                             verification.options.obstacles != nullptr, verification.has_limits());
  if (verdict.holds() && !verification.compares()) {
    return red("nothing to compare") + ": " + kNothingToCheck;
  }
  if (verdict.holds() && coverage.may_hide_conflicts()) {
    return red("not seen as a whole") + ": " + holding.plain(" in the known time") + "; " + unknown;
  }
  if (verdict.holds() && !coverage.complete()) {
    return holding.text(" in the known time") + "; " + unknown;
  }
  if (verdict.holds()) return holding.text();
  std::string text;
  const auto append = [&text](const char* what) {
    if (!text.empty()) text += ", and ";
    text += what;
  };
  if (verdict.losses > 0) append("does not keep its distance");
  if (verdict.clearance_losses > 0) append("does not keep clear of obstacles");
  if (verdict.breaches > 0) append("breaks the limits");
  return red(text) + (coverage.may_hide_conflicts() ? "; " + unknown : "");
}

std::string obstacles_text(const VerifyOptions& options) {
  return io::grouped(std::uint64_t{options.obstacles->obstacles().size()}) + ", clearance " +
         io::exact(options.clearance_m) + " m";
}

}  // namespace

bool Verification::has_limits() const {
  return std::isfinite(options.max_speed_mps) || std::isfinite(options.max_acceleration_mps2);
}

Rows finding_rows(const Verification& verification) {
  const io::Recording& recording = verification.recording;
  const auto& times_s = verification.times_s;
  Rows rows{{{"finding"},
             {"first", "first_label"},
             {"second", "second_label"},
             {"begins_s", nullptr, "begins"},
             {"ends_s", nullptr, "ends"},
             {"value"}},
            {},
            analysis::has_labels(recording),
            io::calendar_of(recording)};
  for (const Loss& loss : verification.verdict.first_losses) {
    rows.rows.push_back({std::string("loss"),
                         analysis::name_at(loss.begins_s, loss.pair.first, recording),
                         analysis::name_at(loss.begins_s, loss.pair.second, recording),
                         loss.begins_s, loss.ends_s, loss.closest_m});
  }
  for (const ClearanceLoss& loss : verification.verdict.first_clearance_losses) {
    const Obstacle& obstacle = verification.options.obstacles->obstacles()[loss.obstacle];
    rows.rows.push_back({std::string("clearance"), analysis::name_of(loss.agent, recording),
                         io::obstacle_name(loss.obstacle, obstacle), loss.begins_s, loss.ends_s,
                         loss.closest_m});
  }
  for (const Breach& breach : verification.verdict.first_breaches) {
    const auto ends = std::upper_bound(times_s.begin(), times_s.end(), breach.begins_s);
    rows.rows.push_back({std::string(word_for(breach.kind)),
                         analysis::name_of(breach.agent, recording), std::monostate{},
                         breach.begins_s, *ends, breach.value});
  }
  return rows;
}

void write_verdict(io::JsonWriter& json, const Verification& verification,
                   const MovingRequest& request) {
  const Verdict& verdict = verification.verdict;
  const VerifyOptions& options = verification.options;
  write_head(json, verification.recording, request, options.threshold_m);
  json.member("max_speed_mps", options.max_speed_mps);
  json.member("max_acceleration_mps2", options.max_acceleration_mps2);
  json.member("straight", options.straight);
  json.member("steps", verdict.steps).member("holds", verification.holds());
  write_coverage(json.key("known"), verification.coverage, verification.recording);
  json.member("loss_count", verdict.losses);
  if (options.obstacles != nullptr) {
    json.member("obstacles", options.obstacles->obstacles().size());
    json.member("clearance_m", options.clearance_m);
    json.member("clearance_loss_count", verdict.clearance_losses);
  }
  json.member("breach_count", verdict.breaches).member("peak_speed_mps", verdict.peak_speed_mps);
  json.member("peak_acceleration_mps2",
              io::known_if(!options.straight, verdict.peak_acceleration_mps2));
  if (!verdict.closest_m) return json.key("closest").null();
  Rows closest{
      {{"first", "first_label"}, {"second", "second_label"}, {"step_begins_s"}, {"distance_m"}},
      {{analysis::name_of(verdict.closest_pair->first, verification.recording),
        analysis::name_of(verdict.closest_pair->second, verification.recording),
        verdict.closest_step_s, *verdict.closest_m}},
      analysis::has_labels(verification.recording)};
  set_labels_apart(closest);
  write_row(json.key("closest"), closest.columns, closest.rows.front());
}

std::string verify_summary(const Verification& verification, const MovingRequest& request) {
  const io::Recording& recording = verification.recording;
  const Verdict& verdict = verification.verdict;
  const VerifyOptions& options = verification.options;
  const auto& times_s = verification.times_s;
  std::string out = input_summary(recording, request);
  append_summary_line(out, "bees", io::grouped(recording.bees.size()));
  append_summary_line(out, "from",
                      io::moment_text(times_s.front(), recording) + " to " +
                          io::moment_text(times_s.back(), recording) + " (" +
                          io::grouped(times_s.back() - times_s.front(), 2) + " s)");
  append_coverage(out, verification.coverage, recording);
  append_summary_line(out, "motion", verification.motion);
  append_summary_line(out, "threshold",
                      separation_summary(request, options.threshold_m, recording));
  if (options.obstacles != nullptr) {
    append_summary_line(out, "obstacles", obstacles_text(options));
  }
  append_summary_line(out, "limits", limits_text(options));
  append_summary_line(out, "checked", times(verdict.steps, "step", "steps"));
  append_summary_line(out, "closest", closest_text(verification, request));
  append_summary_line(out, "peak speed", io::grouped(verdict.peak_speed_mps, 3) + " m/s");
  append_summary_line(out, "peak accel",
                      options.straight ? "not known of straight lines"
                                       : io::grouped(verdict.peak_acceleration_mps2, 3) + " m/s^2");
  append_summary_line(out, "losses",
                      found_text(verdict.losses, "pair in a step", "times a pair in a step"));
  if (options.obstacles != nullptr) {
    append_summary_line(
        out, "clearance",
        found_text(verdict.clearance_losses, "bee in a step", "times a bee in a step"));
  }
  append_summary_line(out, "breaches",
                      found_text(verdict.breaches, "limit in a step", "times a limit in a step"));
  append_summary_line(out, "verdict", verdict_text(verification));
  append_summary_line(out, "time",
                      "read " + io::duration(verification.read_s) + ", check " +
                          io::duration(verification.check_s));
  return out;
}

}  // namespace beespace::cli
