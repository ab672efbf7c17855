#include "cli/recorded/replay_summary.hpp"

#include "analysis/recorded/above_fl410.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/recorded/kept_by_height.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/shared_ids.hpp"
#include "analysis/recorded/unknown_around.hpp"
#include "analysis/text/bee_name.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/coverage_output.hpp"
#include "cli/recorded/near_limit.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

std::string plural(std::uint64_t count, const char* one, const char* several) {
  return io::grouped(count) + " " + (count == 1 ? one : several);
}

// What keeps the verdict from being about all that was flown.
std::string open_text(const analysis::Findings& findings) {
  std::string text;
  if (findings.velocities_passed_over) {
    text = "with --memory velocities are not looked at";
  } else if (findings.velocities_open()) {
    text = "the velocities lead too far away from these to be followed";
  }
  if (findings.heights_open()) {
    text += (text.empty() ? "" : ", ") + analysis::unsure_heights_text(*findings.kept_by_height);
  }
  const bool complete = findings.coverage.complete();
  if (!text.empty() && !complete) text += ", ";
  return complete
             ? text
             : text + printable(analysis::unknown_text(findings.coverage, &findings.recording));
}

std::string kinds_text(const analysis::Findings& findings) {
  std::string text;
  if (!findings.with_standing.empty()) {
    text += ", " + io::grouped(findings.with_standing.size()) + " " +
            with_standing_words(findings.recording);
  }
  if (findings.curves != nullptr && !findings.curves->conflicts.empty()) {
    text += ", " + io::grouped(findings.curves->conflicts.size()) +
            " possible, along curves with the given velocities";
  }
  if (findings.arcs != nullptr && !findings.arcs->conflicts.empty()) {
    text += ", " + io::grouped(findings.arcs->conflicts.size()) +
            " possible, on the arcs of turns between fixes";
  }
  const auto shared =
      analysis::count_of_shared_ids(findings.recorded.conflicts, findings.recording);
  if (shared > 0) text += ", " + io::grouped(std::uint64_t{shared}) + " possible, of a shared id";
  return text;
}

// Of what it is said that there is no conflict.
const char* known_words(const analysis::Findings& findings) {
  if (findings.velocities_open()) return "no conflict along straight lines";
  return findings.coverage.missing.files > 0 ? "no conflict among what was read"
                                             : "no conflict in the known time";
}

// `beside` is what goes with any answer.
std::string verdict(const analysis::Findings& findings,
                    const std::vector<analysis::PairInConflict>& pairs, const std::string& beside) {
  if (!findings.has_encounters)
    return red("nothing to compare") + ": no two bees are there at the same time" +
           (findings.coverage.may_hide_conflicts()
                ? "; " + printable(analysis::unknown_text(findings.coverage, &findings.recording))
                : "");
  const std::string open = open_text(findings);
  const std::string sector = analysis::sector_text(findings.coverage);
  if (pairs.empty() && open.empty() && !findings.low.left_out.empty()) {
    return bold("keeps its distance") + ", but for " + low_text(findings.low) +
           (sector.empty() ? "" : "; " + sector) + (beside.empty() ? "" : "; " + beside);
  }
  const std::string but = (open.empty() ? "" : "; " + open) +
                          (sector.empty() ? "" : "; " + sector) +
                          (beside.empty() ? "" : "; " + beside);
  if (pairs.empty() && open.empty()) {
    return bold(findings.above_fl410.empty() ? "keeps its distance"
                                             : "no conflict by that vertical limit") +
           but;
  }
  if (pairs.empty()) {
    return bold(known_words(findings)) + but;
  }
  const auto& conflicts = findings.recorded.conflicts;
  const bool certain =
      std::any_of(conflicts.begin(), conflicts.end(), [&findings](const Conflict& conflict) {
        return conflict.certain && !analysis::is_of_shared_id(conflict, findings.recording);
      });
  return red(certain ? "does not keep its distance" : "may not keep its distance") + ": " +
         plural(conflicts.size(), "conflict", "conflicts") + " of " +
         plural(pairs.size(), "pair", "pairs") + kinds_text(findings) + but;
}

// How far given velocities lead away from straight lines, where that can be seen.
void append_velocities(std::string& out, const analysis::Findings& findings, double threshold_m) {
  constexpr double kSeen = 0.01;  // of the threshold
  const analysis::VelocityCurves* const curves = findings.curves;
  if (curves == nullptr || !(curves->most_off_m > kSeen * threshold_m)) return;
  const io::Recording& recording = findings.recording;
  append_summary_line(
      out, "velocities",
      "curves with them leave the straight lines by up to " + io::length(curves->most_off_m) +
          " (" + printable(text_of(analysis::name_of(curves->bee, recording))) + " from " +
          io::moment_text(curves->span.begins_s, recording) + " to " +
          io::moment_text(curves->span.ends_s, recording) + "); " +
          (curves->followed ? "both are looked at (--straight: not the curves)"
                            : red("that is too far to follow them") +
                                  ": are they in another unit, or of another direction?"));
}

// The pairs that come too close in the air, told by that, and behind them those of which one stands
// on the ground whenever they do.
std::vector<analysis::PairInConflict> in_the_air_first(const analysis::Findings& findings,
                                                       std::vector<analysis::PairInConflict> pairs,
                                                       const Distances& distances) {
  if (findings.with_standing.empty()) return pairs;
  const auto ids = [](const analysis::PairInConflict& pair) {
    return std::pair(pair.worst.first, pair.worst.second);
  };
  std::map<std::pair<PointId, PointId>, Conflict> worst_in_the_air;
  const auto& conflicts = findings.recorded.conflicts;
  for (const auto& pair : analysis::pairs_in_conflict(
           analysis::without(conflicts, findings.with_standing), distances.worst)) {
    worst_in_the_air.emplace(ids(pair), pair.worst);
  }
  std::map<std::pair<PointId, PointId>, std::pair<bool, double>> order;
  for (auto& pair : pairs) {
    const auto found = worst_in_the_air.find(ids(pair));
    const bool in_the_air = found != worst_in_the_air.end();
    if (in_the_air) pair.worst = found->second;
    order[ids(pair)] = {!in_the_air, analysis::rank_of(pair.worst, distances.worst)};
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const auto& a, const auto& b) { return order[ids(a)] < order[ids(b)]; });
  return pairs;
}

// Of a show with drones on the ground, who is closest in the air comes first.
void append_closest(std::string& out, const analysis::Findings& findings,
                    const Distances& distances) {
  if (!findings.closest) return;
  const auto& conflicts = findings.recorded.conflicts;
  const Conflict closest = *told_as_closest(conflicts, findings.closest, distances);
  const auto in_the_air = told_as_closest(analysis::without(conflicts, findings.with_standing),
                                          findings.closest_in_the_air, distances);
  const auto is_conflict = [&conflicts](const Conflict& one) {
    return std::find(conflicts.begin(), conflicts.end(), one) != conflicts.end();
  };
  const bool conflict = is_conflict(closest);
  std::string text = encounter_text(closest, findings.recording, distances,
                                    conflict ? Told::kConflict : Told::kDistance);
  if (conflict && analysis::is_of_shared_id(closest, findings.recording)) {
    text += ", possible, as two seem to share an id";
  }
  const bool both_stand = conflicts.empty() && analysis::both_stand(findings.recording, closest);
  if (both_stand) text += ", both on the ground";
  const auto& low = findings.low.left_out;
  const bool left_out = std::find(low.begin(), low.end(), closest) != low.end();
  if (left_out) text += ", left out";
  const auto& standing = findings.with_standing;
  const bool one_stands = std::find(standing.begin(), standing.end(), closest) != standing.end();
  if (!one_stands && !both_stand && !(left_out && in_the_air)) {
    return append_summary_line(out, "closest", text);
  }
  if (one_stands) text += ", " + std::string(with_standing_words(findings.recording));
  if (in_the_air) {
    append_summary_line(
        out, "closest",
        encounter_text(*in_the_air, findings.recording, distances,
                       is_conflict(*in_the_air) ? Told::kConflict : Told::kDistance));
  }
  append_summary_line(out, in_the_air ? "" : "closest", text);
}

void append_worst(std::string& out, const analysis::Findings& findings,
                  const std::vector<analysis::PairInConflict>& pairs, const Distances& distances) {
  constexpr std::size_t kMost = 5;
  for (std::size_t i = 0; i < std::min(kMost, pairs.size()); ++i) {
    const analysis::PairInConflict& pair = pairs[i];
    std::string text = encounter_text(pair.worst, findings.recording, distances, Told::kConflict);
    const auto& standing = findings.with_standing;
    if (std::count(standing.begin(), standing.end(), pair.worst) > 0) {
      text += ", " + std::string(with_standing_words(findings.recording));
    }
    text += "; in conflict for " + io::grouped(pair.time_s, 2) + " s";
    if (pair.conflicts > 1) text += " in " + io::grouped(pair.conflicts) + " conflicts";
    if (analysis::is_of_shared_id(pair.worst, findings.recording)) {
      text += ", possible, as two seem to share an id";
    } else if (findings.curves != nullptr && findings.curves->given && !pair.worst.certain) {
      text += ", on curves with the given velocities";
    }
    append_summary_line(out, i == 0 ? "worst" : "", text);
  }
  if (pairs.size() > kMost) {
    append_summary_line(out, "", "and " + plural(pairs.size() - kMost, "pair", "pairs") + " more");
  }
}

// Conflicts of which not all may be seen.
void append_cut_conflicts(std::string& out, const analysis::Findings& findings) {
  const auto& conflicts = findings.recorded.conflicts;
  if (conflicts.empty()) return;
  const std::vector<Gap> unknown = analysis::all_unknown_spans(
      findings.recording, findings.recorded.gaps, findings.coverage.max_gap);
  if (unknown.empty()) return;
  const auto cut = std::count_if(conflicts.begin(), conflicts.end(), [&](const Conflict& conflict) {
    const auto around = analysis::unknown_around(conflict, unknown);
    return around.before || around.after;
  });
  if (cut == 0) return;
  append_note(out, plural(static_cast<std::uint64_t>(cut), "conflict begins or ends",
                          "conflicts begin or end") +
                       " where one of the two is not known just before or after "
                       "(unknown_before, unknown_after): such conflicts may be longer, and "
                       "several may be one");
}

// The least separation over time as a row of bars, of which the highest stands for twice the
// threshold and more.
std::string bars_over_time(const analysis::Findings& findings, double threshold_m) {
  constexpr std::size_t kBars = 60;
  constexpr std::array<std::string_view, 8> kHeights = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const auto time = analysis::time_of(findings.tracks);
  if (!time || !(time->ends_s > time->begins_s)) return {};
  // What is between two moments is not seen here; where there was a conflict it is marked anyway.
  const double each = (time->ends_s - time->begins_s) / kBars;
  const auto moments = analysis::separation_over_time(findings, each);
  std::array<bool, kBars> conflict{};
  const auto bar_at = [&](double at) {
    const double place = std::clamp((at - time->begins_s) / each, 0.0, kBars - 1.0);
    return static_cast<std::size_t>(place);
  };
  for (const Conflict& c : findings.recorded.conflicts) {
    for (std::size_t bar = bar_at(c.begins_s); bar <= bar_at(c.ends_s); ++bar) conflict[bar] = true;
  }
  const auto unknown = analysis::unknown_spans(findings.recording, findings.recorded.gaps,
                                               findings.coverage.max_gap);
  const auto is_unknown = [&](double time_s) {
    return std::any_of(unknown.begin(), unknown.end(), [&](const Gap& gap) {
      return gap.begins_s < time_s && time_s < gap.ends_s;
    });
  };
  std::string text;
  for (std::size_t bar = 0; bar < kBars && bar < moments.size(); ++bar) {
    const double share = moments[bar].distance_m / (2.0 * threshold_m);
    const auto height = static_cast<std::size_t>(std::clamp(share * 8.0, 0.0, 7.0));
    if (conflict[bar]) {
      text += red("!");
    } else if (moments[bar].open || is_unknown(moments[bar].time_s)) {
      text += "?";
    } else {
      text += std::isfinite(moments[bar].distance_m) ? kHeights[height] : " ";
    }
  }
  return text;
}

double width_m(const std::vector<Track>& tracks) {
  Point least{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Point greatest{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Track& track : tracks) {
    for (const Fix& fix : track.fixes) {
      const Point& at = fix.position;
      least = {std::min(least.x, at.x), std::min(least.y, at.y), std::min(least.z, at.z)};
      greatest = {std::max(greatest.x, at.x), std::max(greatest.y, at.y),
                  std::max(greatest.z, at.z)};
    }
  }
  return std::hypot(greatest.x - least.x, greatest.y - least.y, greatest.z - least.z);
}

// Of a threshold that is wider than all that was recorded, so that all are in conflict: the default
// one; or a bare number beside units of small things, which may have been meant, as 10 um and not
// 10 m.
void append_wide_threshold(std::string& out, const analysis::Findings& findings,
                           const MovingRequest& request, double threshold_m) {
  const auto& units = findings.recording.units;
  const auto taken = std::find_if(units.begin(), units.end(), [](const io::UnitTaken& one) {
    return one.of.starts_with('x') && one.unit != io::Unit::kMetre &&
           one.unit != io::Unit::kUnstated;
  });
  const bool small = taken != units.end();
  const bool is_default =
      !request.threshold &&
      analysis::default_threshold(findings.recording, threshold_m).words.empty();
  const bool bare = small && request.threshold && request.threshold->unit == io::Unit::kMetre;
  if (!is_default && !bare) return;
  const double wide_m = width_m(findings.tracks);
  if (!(wide_m > 0.0) || !(wide_m < threshold_m)) return;
  const bool in_pixels = small && taken->unit == io::Unit::kPixel && request.load.pixel.has_value();
  // What is typed is in the unit of the scale.
  const io::Unit unit = in_pixels ? request.load.pixel->unit
                        : small   ? taken->unit
                                  : io::Unit::kMetre;
  const std::string name(io::symbol_of(unit));
  const double wide = io::from_metric(wide_m, unit);
  std::string so_wide = "all of it is " + io::grouped(wide, 1) + " " + name;
  if (in_pixels) so_wide += " (" + io::grouped(wide_m / request.load.pixel->metric, 0) + " px)";
  so_wide += " wide, and ";
  if (is_default) {
    const double example = std::pow(10.0, std::floor(std::log10(wide)) - 1.0);
    return append_summary_line(out, "note",
                               so_wide + io::exact(threshold_m) +
                                   " m is the default: say how close is too close, as in "
                                   "--threshold " +
                                   io::exact(example) + name);
  }
  const double meant = request.threshold->value * (in_pixels ? request.load.pixel->value : 1.0);
  append_summary_line(out, "note",
                      so_wide + "the threshold is " + io::exact(threshold_m) + " m: if " +
                          (in_pixels ? "px" : name) + " are meant, say --threshold " +
                          io::exact(meant) + name);
}

// Of bees that are known nowhere no bar knows anything.
std::string bars_legend(const std::string& bars, std::uint64_t nowhere) {
  const bool any_open = bars.find('?') != std::string::npos;
  return std::string("(how far apart the closest two are: a full bar is twice the threshold, ") +
         "! a conflict" + (any_open ? ", ? not known, as one is there and may be closer" : "") +
         (nowhere > 0 ? "; without " + plural(nowhere, "bee that is", "bees that are") +
                            " known nowhere and may be closer at any time)"
                      : ")");
}

}  // namespace

std::string replay_summary(const analysis::Findings& findings, const MovingRequest& request,
                           const ReplayFigures& figures, const Distances& distances) {
  const io::Recording& recording = findings.recording;
  std::string out = input_summary(recording, request);
  const std::uint64_t nowhere = findings.coverage.missing.nowhere;
  append_summary_line(
      out, "bees",
      io::grouped(findings.tracks.size() + nowhere) +
          (nowhere > 0 ? ", " + io::grouped(nowhere) + " of which known nowhere" : ""));
  if (const auto time = analysis::time_of(findings.tracks)) {
    append_summary_line(out, "from",
                        io::moment_text(time->begins_s, recording) + " to " +
                            io::moment_text(time->ends_s, recording) + " (" +
                            io::grouped(time->ends_s - time->begins_s, 2) + " s)");
  }
  append_coverage(out, findings.coverage, recording);
  append_velocities(out, findings, figures.threshold_m);
  const auto instants = std::count_if(findings.tracks.begin(), findings.tracks.end(),
                                      [](const Track& track) { return track.fixes.size() == 1; });
  if (instants > 0) {
    append_summary_line(out, "note",
                        plural(static_cast<std::size_t>(instants), "bee has", "bees have") +
                            " one fix only, known for an instant; 'beespace predict' brings all "
                            "bees to one time");
  }
  append_summary_line(
      out, "threshold",
      separation_summary(request, figures.threshold_m, recording, distances.aviation));
  append_wide_threshold(out, findings, request, figures.threshold_m);
  if (findings.kept_by_height) {
    append_note(out, analysis::kept_by_height_text(*findings.kept_by_height, recording,
                                                   figures.threshold_m));
  } else if (figures.memory_bytes && !recording.flat && !request.vertical) {
    append_note(
        out,
        "with --memory it is not looked at whether heights alone keep two apart; --vertical "
        "compares heights and ways over ground apart from each other");
  }
  append_traffic_hint(out, recording, request, figures.threshold_m);
  const auto pairs = analysis::pairs_in_conflict(findings.recorded.conflicts, distances.worst);
  std::string above = analysis::above_fl410_text(recording, figures.threshold_m, request.vertical);
  if (const auto closer = analysis::pairs_in_conflict(findings.above_fl410); !closer.empty()) {
    above += "; " +
             red(plural(closer.size(), "pair", "pairs") + " without a conflict come closer") +
             ": " + encounter_text(closer.front().closest, recording, distances);
  }
  append_summary_line(out, "verdict", verdict(findings, pairs, above));
  append_closest(out, findings, distances);
  append_worst(out, findings, in_the_air_first(findings, pairs, distances), distances);
  append_cut_conflicts(out, findings);
  if (recording.of_aircraft && !findings.with_standing.empty()) {
    append_note(out,
                "who stands still for a minute or longer, by its own reports of 0 kt at one place, "
                "may be on the ground without saying so: its conflicts come last");
  }
  append_note(out, analysis::chords_text(findings.chords));
  if (findings.arcs != nullptr) append_note(out, analysis::turn_arcs_text(*findings.arcs));
  append_note(out, near_limit_text(findings.recorded.conflicts, request, distances, recording));
  append_low(out, findings.low, recording, request, distances, findings.with_standing);
  const std::string bars = findings.has_encounters && !figures.memory_bytes
                               ? bars_over_time(findings, figures.threshold_m)
                               : std::string();
  if (!bars.empty()) {
    append_summary_line(out, "over time", bars);
    append_summary_line(out, "", bars_legend(bars, findings.coverage.missing.nowhere));
  }
  if (figures.memory_bytes) {
    append_summary_line(out, "memory",
                        io::byte_count(*figures.memory_bytes) + ", " +
                            io::counted(figures.windows, "window of time", "windows of time"));
  }
  append_summary_line(
      out, "time",
      "read " + io::duration(figures.read_s) + ", search " + io::duration(figures.search_s));
  return out;
}

}  // namespace beespace::cli
