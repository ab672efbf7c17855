#include "cli/recorded/path_summary.hpp"

#include "analysis/recorded/all_conflicts.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/shared_ids.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "analysis/text/bee_name.hpp"
#include "analysis/text/unit_notes.hpp"
#include "cli/command_line/command.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/coverage_output.hpp"
#include "cli/recorded/holding_words.hpp"
#include "cli/recorded/limit_hints.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace beespace::cli {
namespace {

std::string shown_bee(PointId bee, const io::Recording& recording) {
  return printable(text_of(analysis::name_of(bee, recording)));
}

std::string when(double time_s, const io::Recording& recording) {
  return " at " + io::moment_text(time_s, recording);
}

// Of the acceleration of a corner: what it is of.
std::string corner_text(const PathPeak& peak) {
  if (!peak.at_corner) return "";
  return ", where it turns at a point (within " + io::exact(kCornerDeviation_m) + " m of its path)";
}

// What heights are counted from, where that is not the ground.
std::string counted_from(PathLimit limit, const io::Recording& recording) {
  return limit == PathLimit::kHeight ? counted_from_sea(recording) : std::string();
}

// The unit of aviation; nothing of accelerations.
std::optional<io::Unit> aviation_unit(PathLimit limit) {
  switch (limit) {
    case PathLimit::kSpeed:
    case PathLimit::kHorizontalSpeed:
      return io::Unit::kKnot;
    case PathLimit::kClimb:
    case PathLimit::kDescent:
      return io::Unit::kFootPerMinute;
    case PathLimit::kHeight:
      return io::Unit::kFoot;
    case PathLimit::kAcceleration:
      break;
  }
  return std::nullopt;
}

// "231.500 m/s"; of aviation "450.0 kt (231.500 m/s)".
std::string quantity_text(PathLimit limit, double value, bool aviation) {
  std::string metric = io::grouped(value, 3) + " " + words_of(limit).unit;
  const auto unit = aviation ? aviation_unit(limit) : std::nullopt;
  if (!unit) return metric;
  const int decimals = *unit == io::Unit::kKnot ? 1 : 0;
  return io::grouped(io::from_metric(value, *unit), decimals) + " " +
         std::string(io::symbol_of(*unit)) + " (" + metric + ")";
}

std::string peak_text(PathLimit limit, const analysis::BeePeak& peak,
                      const io::Recording& recording, bool aviation) {
  return std::string(words_of(limit).noun) + " " +
         quantity_text(limit, shown_value(peak.peak, limit), aviation) +
         counted_from(limit, recording) + ", " + shown_bee(peak.bee, recording) +
         when(peak.peak.at_s, recording) + corner_text(peak.peak);
}

void append_peaks(std::string& out, const PathFindings& findings, bool aviation) {
  bool first = true;
  for (const PathLimitWords& words : kPathLimitWords) {
    const auto& peak = findings.verdict.peaks[static_cast<std::size_t>(words.limit)];
    if (!peak) continue;
    append_summary_line(out, first ? "greatest" : "",
                        peak_text(words.limit, *peak, findings.recording, aviation));
    first = false;
  }
}

using Breaches = std::vector<const analysis::PathBreach*>;

// Of one limit of the flights, or of one that the show declares beside them.
Breaches breaches_of(const PathFindings& findings, PathLimit limit,
                     const std::optional<std::size_t>& beside) {
  Breaches some;
  for (const analysis::PathBreach& breach : findings.verdict.breaches) {
    if (breach.excess.limit == limit && breach.beside == beside) some.push_back(&breach);
  }
  return some;
}

const analysis::PathBreach& worst_of(const Breaches& breaches) {
  return **std::max_element(breaches.begin(), breaches.end(), [](const auto* a, const auto* b) {
    return a->excess.peak.value < b->excess.peak.value;
  });
}

// How many they are, and the worst.
std::string breaches_text(const Breaches& breaches, const std::string& limit,
                          const PathFindings& findings) {
  const analysis::PathBreach& worst = worst_of(breaches);
  return red(io::counted(breaches.size(), "stretch", "stretches") + " above the " + limit) +
         ", the worst " + io::grouped(worst.excess.peak.value, 3) + " " +
         words_of(worst.excess.limit).unit + ": " + shown_bee(worst.bee, findings.recording) +
         when(worst.excess.peak.at_s, findings.recording) + corner_text(worst.excess.peak);
}

std::string acceleration_text(const io::ShowAcceleration& declared) {
  return std::string(analysis::acceleration_noun(declared.direction)) + " " +
         io::exact(declared.most_mps2) + " m/s^2";
}

void append_breaches(std::string& out, const PathFindings& findings) {
  const std::vector<std::string> low = low_moves(findings.verdict, findings.recording);
  if (findings.verdict.breaches.empty() && low.empty()) {
    return append_summary_line(out, "breaches", bold("none"));
  }
  bool first = true;
  for (const std::string& line : low) {
    append_summary_line(out, first ? "breaches" : "", line);
    first = false;
  }
  const auto append = [&](const Breaches& breaches, const std::string& limit) {
    if (breaches.empty()) return;
    append_summary_line(out, first ? "breaches" : "", breaches_text(breaches, limit, findings));
    first = false;
  };
  for (const PathLimitWords& words : kPathLimitWords) {
    append(breaches_of(findings, words.limit, std::nullopt),
           std::string(words.noun) + " of " + io::exact(findings.limits.limits[words.limit]) + " " +
               words.unit + counted_from(words.limit, findings.recording));
  }
  if (const auto high = breaches_of(findings, PathLimit::kHeight, std::nullopt); !high.empty()) {
    const std::string hint =
        ground_hint(findings.recording, worst_of(high), findings.limits.limits[PathLimit::kHeight]);
    if (!hint.empty()) append_summary_line(out, "", hint);
  }
  const auto& accelerations = findings.verdict.accelerations;
  for (std::size_t i = 0; i < accelerations.size(); ++i) {
    const io::ShowAcceleration& declared = accelerations[i].declared;
    append(breaches_of(findings, PathLimit::kAcceleration, i),
           std::string(analysis::acceleration_noun(declared.direction)) + " of " +
               io::exact(declared.most_mps2) + " m/s^2 (" + printable(declared.name) + ")");
  }
}

std::string accelerations_text(const PathFindings& findings) {
  std::string text;
  for (const analysis::AccelerationCheck& check : findings.verdict.accelerations) {
    text += (text.empty() ? "" : ", ") + acceleration_text(check.declared);
  }
  return text.empty() ? text : text + " (as the show declares)";
}

// With a vertical threshold, how far apart two are horizontally and vertically.
Distances distances_in(const PathFindings& findings, const MovingRequest& request) {
  const io::Recording& recording = findings.recording;
  const analysis::PathVerdict& verdict = findings.verdict;
  Distances distances = distances_of(request, recording, findings.question.threshold_m);
  if (!request.vertical) return distances;
  const analysis::Geometry geometry = analysis::geometry_for(recording, request.vertical);
  distances.apart = analysis::apart_along(verdict.lines, verdict.curves, verdict.arcs,
                                          height_unit_m(geometry, recording.height_unit));
  distances.worst = analysis::worst_along(verdict.lines, verdict.curves, verdict.arcs,
                                          height_unit_m(geometry, recording.height_unit),
                                          {findings.question.threshold_m, *request.vertical_m});
  return distances;
}

std::string possible_text(const Conflict& loss, const PathFindings& findings) {
  if (analysis::is_of_shared_id(loss, findings.recording)) {
    return ", possible, as two seem to share an id";
  }
  const bool along_curves = findings.verdict.curves.given && !loss.certain;
  return along_curves ? ", possible, on curves with the given velocities" : "";
}

void append_losses(std::string& out, const PathFindings& findings, const Distances& distances) {
  constexpr std::size_t kMost = 5;
  std::vector<Conflict> standing = findings.verdict.with_standing;
  std::vector<Conflict> losses = analysis::without(findings.verdict.losses, standing);
  for (std::vector<Conflict>* const some : {&losses, &standing}) {
    analysis::sort_worst_first(distances.worst, *some);
  }
  const std::size_t in_the_air = losses.size();
  losses.insert(losses.end(), standing.begin(), standing.end());
  const std::size_t on_ground = findings.verdict.standing_count;
  if (losses.empty()) {
    return append_summary_line(
        out, "losses",
        bold("none") + (on_ground == 0
                            ? ""
                            : " (left out: " + io::counted(on_ground, "conflict", "conflicts") +
                                  " of two that both stand on the ground)"));
  }
  append_summary_line(out, "losses",
                      red(io::counted(losses.size(), "conflict", "conflicts")) +
                          (standing.empty() ? ""
                                            : ", " + io::grouped(std::uint64_t{standing.size()}) +
                                                  " " + with_standing_words(findings.recording)));
  for (std::size_t i = 0; i < std::min(kMost, losses.size()); ++i) {
    append_summary_line(
        out, "",
        encounter_text(losses[i], findings.recording, distances, Told::kConflict) +
            possible_text(losses[i], findings) +
            (i < in_the_air ? "" : ", " + std::string(with_standing_words(findings.recording))));
  }
}

// Of a show with drones on the ground, who is closest in the air comes first.
void append_closest(std::string& out, const PathFindings& findings, const Distances& distances) {
  const analysis::PathVerdict& verdict = findings.verdict;
  if (!verdict.closest) {
    // Of those that keep a vertical threshold a straight line says little.
    if (verdict.encounters) return;
    const bool alone = findings.recording.bees.size() == 1;
    return append_summary_line(out, "closest",
                               alone ? kNoPair : "no two are there at the same time");
  }
  const auto closest = told_as_closest(verdict.losses, verdict.closest, distances);
  const auto in_the_air = told_as_closest(analysis::without(verdict.losses, verdict.with_standing),
                                          verdict.closest_in_the_air, distances);
  const auto told = [&verdict](const Conflict& one) {
    const auto& losses = verdict.losses;
    return std::find(losses.begin(), losses.end(), one) == losses.end() ? Told::kDistance
                                                                        : Told::kConflict;
  };
  std::string text = encounter_text(*closest, findings.recording, distances, told(*closest));
  const bool both_stand =
      verdict.losses.empty() && analysis::both_stand(findings.recording, *closest);
  if (both_stand) text += ", both on the ground";
  if (closest == in_the_air) {
    return append_summary_line(out, "closest", text);
  }
  if (in_the_air) {
    append_summary_line(
        out, "closest",
        encounter_text(*in_the_air, findings.recording, distances, told(*in_the_air)));
  }
  if (!both_stand) text += ", " + std::string(with_standing_words(findings.recording));
  append_summary_line(out, in_the_air ? "" : "closest", text);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + printable(name);
  return text;
}

std::string verdict_text(const PathFindings& findings) {
  const analysis::PathVerdict& verdict = findings.verdict;
  const analysis::PathQuestion& question = findings.question;
  const HoldingWords holding(findings.recording.bees.size(), question.obstacles != nullptr,
                             question.has_limits());
  if (verdict.found_nothing() && !verdict.curves.followed) {
    return red("not looked at as a whole") +
           ": nothing else was found, but velocities lead too far away from straight lines to be "
           "followed (are they in another unit, or of another direction?); --straight leaves them "
           "out" +
           (findings.coverage.may_hide_conflicts()
                ? "; " + printable(analysis::unknown_text(findings.coverage, &findings.recording))
                : "");
  }
  const std::vector<std::string> not_kept = looked_at(verdict.undecided, verdict, true);
  const std::vector<std::string> unknown = looked_at(verdict.undecided, verdict, false);
  if (verdict.found_nothing() && not_kept.empty() && !unknown.empty()) {
    return red("not looked at as a whole") + ": nothing else was found, but whether " +
           listed(unknown) + (unknown.size() == 1 ? " is kept" : " are kept") +
           " is not known; where that need not be looked at, say --skip-limits " +
           joined(unknown, ",") +
           (findings.coverage.may_hide_conflicts()
                ? "; " + printable(analysis::unknown_text(findings.coverage, &findings.recording))
                : "");
  }
  if (findings.holds() && !findings.coverage.complete()) {
    return holding.text(" in the known time") + "; " +
           printable(analysis::unknown_text(findings.coverage, &findings.recording));
  }
  if (findings.holds() && !verdict.not_looked_at.empty()) {
    return holding.text() + " in what was looked at, which " + listed(verdict.not_looked_at) +
           (verdict.not_looked_at.size() == 1 ? " is" : " are") + " not (--skip-limits)";
  }
  if (findings.holds() && !verdict.low.left_out.empty()) {
    return holding.text() + ", but for " + low_text(verdict.low);
  }
  if (findings.holds()) return holding.text();
  if (verdict.holds() && !findings.compares() && findings.recording.bees.size() == 1) {
    return red("nothing to compare") + ": " + kNothingToCheck;
  }
  if (verdict.holds() && !findings.compares()) {
    return red("nothing to compare") + ": no two bees are there at the same time; the limits hold";
  }
  if (verdict.holds()) {
    return red("not seen as a whole") + ": " + holding.plain(" in the known time") + "; " +
           printable(analysis::unknown_text(findings.coverage, &findings.recording));
  }
  std::string text;
  const auto append = [&text](bool broken, const char* what) {
    if (broken) text += (text.empty() ? "" : ", and ") + std::string(what);
  };
  append(!verdict.losses.empty(), "does not keep its distance");
  append(!verdict.clearance_losses.empty(), "does not keep clear of obstacles");
  append(!verdict.breaches.empty(), "breaks the limits");
  if (!not_kept.empty()) {
    text += (text.empty() ? "" : ", and ") + ("does not keep " + listed(not_kept));
  }
  const bool hidden = findings.coverage.may_hide_conflicts();
  const std::string skipping =
      not_kept.empty() ? std::string()
                       : "; where that does not count, say --skip-limits " + joined(not_kept, ",");
  return red(text) + skipping +
         (hidden ? "; " + printable(analysis::unknown_text(findings.coverage, &findings.recording))
                 : "");
}

TimeSpan time_of_all(const io::Recording& recording) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  TimeSpan time{kNever, -kNever};
  const auto take = [&time](double begins_s, double ends_s) {
    time = {std::min(time.begins_s, begins_s), std::max(time.ends_s, ends_s)};
  };
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.path) {
      const auto& pieces = bee.path->pieces;
      take(bee.path->begins_s, pieces.empty() ? bee.path->begins_s : pieces.back().ends_s);
    } else if (!bee.fixes.empty()) {
      take(bee.fixes.front().time_s, bee.fixes.back().time_s);
    }
  }
  return time;
}

}  // namespace

std::string verify_summary(const PathFindings& findings, const MovingRequest& request) {
  const io::Recording& recording = findings.recording;
  const analysis::PathVerdict& verdict = findings.verdict;
  std::string out = input_summary(recording, request);
  append_summary_line(out, "bees", io::grouped(recording.bees.size()));
  const TimeSpan time = time_of_all(recording);
  append_summary_line(out, "from",
                      io::moment_text(time.begins_s, recording) + " to " +
                          io::moment_text(time.ends_s, recording) + " (" +
                          io::grouped(time.ends_s - time.begins_s, 2) + " s)");
  if (!recording.show || !findings.coverage.complete()) {
    append_coverage(out, findings.coverage, recording);
  }
  append_summary_line(out, "motion", findings.motion);
  append_summary_line(out, "threshold",
                      separation_summary(request, findings.question.threshold_m, recording));
  if (findings.question.obstacles != nullptr) {
    append_summary_line(
        out, "obstacles",
        io::grouped(std::uint64_t{findings.question.obstacles->obstacles().size()}) +
            ", clearance " + io::exact(findings.question.clearance_m) + " m");
  }
  const std::string accelerations = accelerations_text(findings);
  const bool any = findings.question.has_limits() || accelerations.empty();
  if (any) append_summary_line(out, "limits", limits_text(findings.limits));
  if (!accelerations.empty()) append_summary_line(out, any ? "" : "limits", accelerations);
  if (const std::string kept = kept_navigation(verdict); !kept.empty()) {
    append_summary_line(out, any || !accelerations.empty() ? "" : "limits", kept);
  }
  if (const auto names = looked_at(verdict.not_looked_at, verdict, false); !names.empty()) {
    append_summary_line(out, "", red("declared, but not looked at") + ": " + listed(names));
  }
  const Distances distances = distances_in(findings, request);
  append_closest(out, findings, distances);
  append_peaks(out, findings, distances.aviation);
  append_losses(out, findings, distances);
  append_low(out, verdict.low, recording, request, distances, verdict.with_standing);
  if (findings.question.obstacles != nullptr) {
    const auto count = verdict.clearance_losses.size();
    append_summary_line(
        out, "clearance",
        count == 0
            ? bold("none")
            : red(io::counted(count, "time that a bee is", "times that bees are") + " closer"));
  }
  append_breaches(out, findings);
  append_summary_line(out, "verdict", verdict_text(findings));
  append_summary_line(
      out, "time",
      "read " + io::duration(findings.read_s) + ", check " + io::duration(findings.check_s));
  return out;
}

}  // namespace beespace::cli
