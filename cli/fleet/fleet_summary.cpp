#include "cli/fleet/fleet_summary.hpp"

#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/coverage_output.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/recorded_noun.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

using analysis::BeeDeviation;
using analysis::Extreme;
using analysis::TrackingFigures;

constexpr std::size_t kMostNamed = 5;

// "a, b and 3 more".
std::string some_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) {
    text.append(i == 0 ? "" : ", ").append(names[i]);
  }
  if (names.size() > kMostNamed) {
    text.append(" and ").append(io::grouped(names.size() - kMostNamed)).append(" more");
  }
  return printable(text);
}

// "8.25 s", "1 min 1 s".
std::string lasts_text(double seconds) {
  return io::time_span(std::round(seconds * 100.0) / 100.0);
}

// "7 (Drone 7)".
std::string name_of(const FleetAnswer& answer, std::size_t bee) {
  const std::string& id = answer.both.flown_ids[bee];
  const std::string& set_id = answer.both.set_ids[bee];
  return id == set_id ? id : id + " (" + set_id + ")";
}

std::string extreme_text(const Extreme& extreme, const std::string& unit) {
  return io::grouped(extreme.greatest, 3) + unit + " (99.9 %: " + io::grouped(extreme.usual, 3) +
         unit + ")";
}

void append_compared(std::string& out, const FleetAnswer& answer) {
  const TrackingFigures& figures = answer.figures;
  std::string text = io::noun_of(answer.flown).counted(answer.both.bees.size()) + ", " +
                     io::counted(figures.fixes, "fix", "fixes");
  if (figures.not_set > 0) {
    text += "; nothing was set at the times of " + io::grouped(figures.not_set) + " more";
  }
  append_summary_line(out, "compared", text);
}

// Those of which it is not known how far they strayed, all the time or for a part of it.
void append_unknown(std::string& out, const FleetAnswer& answer) {
  const SetBesideFlown& both = answer.both;
  if (!both.only_set.empty()) {
    std::vector<std::string> ids;
    ids.reserve(both.only_set.size());
    for (const OnlySet& one : both.only_set) ids.push_back(one.id);
    append_summary_line(out, "not flown",
                        some_of(ids) + ": set, and not in what was flown; where " +
                            (ids.size() == 1 ? "it was" : "they were") + " is not known");
  }
  if (!both.only_flown.empty()) {
    append_summary_line(
        out, "not set",
        some_of(both.only_flown) + ": flown, and not in what was set; compared with nothing");
  }
  std::vector<std::pair<double, std::size_t>> longest;
  double seconds = 0.0;
  for (std::size_t bee = 0; bee < both.bees.size(); ++bee) {
    const double of_bee_s = unknown_s(answer, bee);
    if (of_bee_s > 0.0) longest.emplace_back(-of_bee_s, bee);
    seconds += of_bee_s;
  }
  if (longest.empty()) return;
  std::sort(longest.begin(), longest.end());
  std::vector<std::string> names;
  names.reserve(longest.size());
  for (const auto& [less_s, bee] : longest) {
    const TimeSpan& first = both.unknown[bee].front();
    std::string name = name_of(answer, bee);
    name.append(" for ").append(lasts_text(-less_s)).append(" from ");
    name.append(io::moment_text(first.begins_s, answer.flown)).append(" on");
    names.push_back(std::move(name));
  }
  append_summary_line(out, "unknown",
                      io::noun_of(answer.flown).counted(longest.size()) + " for " +
                          lasts_text(seconds) + " in all of what was set: " + some_of(names));
}

void append_farthest(std::string& out, const FleetAnswer& answer) {
  append_summary_line(out, "deviation",
                      std::string(is_known(answer) ? "" : "in the known time ") + "at most " +
                          extreme_text(answer.figures.deviation_m, " m"));
  const auto bee = farthest_bee(answer);
  if (!bee) return;
  const BeeDeviation& of = *answer.figures.each[*bee];
  append_summary_line(out, "farthest",
                      printable(name_of(answer, *bee)) + ", " + io::grouped(of.farthest_m, 3) +
                          " m from where it was set to be at " +
                          io::moment_text(of.farthest_s, answer.flown));
}

void append_verdict(std::string& out, const FleetAnswer& answer) {
  if (!answer.max_deviation_m) return;
  const std::string limit = io::exact(*answer.max_deviation_m) + " m";
  const std::vector<std::size_t> too_far = bees_too_far(answer);
  std::string text;
  if (too_far.empty()) {
    text = is_known(answer) ? "stays within " + limit
                            : "not known: stays within " + limit + " in the known time";
  } else {
    std::vector<std::string> names;
    names.reserve(too_far.size());
    for (const std::size_t bee : too_far) names.push_back(name_of(answer, bee));
    text = io::noun_of(answer.flown).counted(too_far.size()) + " farther than " + limit + ": " +
           some_of(names);
  }
  append_summary_line(out, "verdict", text);
}

// For those who plan with the tube of docs/fleet-figures.md.
void append_to_plan_with(std::string& out, const FleetAnswer& answer) {
  const TrackingFigures& figures = answer.figures;
  append_summary_line(out, "rate", extreme_text(figures.rate_mps, " m/s"));
  append_summary_line(out, "changes by", extreme_text(figures.acceleration_mps2, " m/s^2"));
  append_summary_line(
      out, "to plan",
      "sensing_error_m = " + io::grouped(up_to_mm(figures.deviation_m.greatest), 3) +
          ", deviation_mps = 0, correction_mps = " +
          io::grouped(up_to_mm(figures.rate_mps.greatest), 3) +
          "; how wrong flown positions are themselves is not told: add that to sensing_error_m and "
          "report_error_m");
}

}  // namespace

std::string fleet_summary(const FleetAnswer& answer) {
  std::string out;
  append_compared(out, answer);
  append_unknown(out, answer);
  append_missing(out, answer.flown.missing);
  append_farthest(out, answer);
  const TrackingFigures& figures = answer.figures;
  append_summary_line(out, "lag",
                      figures.lag_s ? io::grouped(*figures.lag_s, 2) + " s; without it at most " +
                                          extreme_text(figures.without_lag_m, " m")
                                    : std::string("none that could be told"));
  if (!answer.set.show) append_to_plan_with(out, answer);
  append_verdict(out, answer);
  return out;
}

}  // namespace beespace::cli
