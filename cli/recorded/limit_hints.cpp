#include "cli/recorded/limit_hints.hpp"

#include "analysis/recorded/low_conflicts.hpp"
#include "analysis/recorded/low_navigation.hpp"
#include "analysis/text/bee_name.hpp"
#include "analysis/text/unit_notes.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace beespace::cli {
namespace {

std::string bee_text(PointId bee, const io::Recording& recording) {
  return printable(text_of(analysis::name_of(bee, recording)));
}

}  // namespace

std::string counted_from_sea(const io::Recording& recording) {
  const bool of_sea = recording.heights == io::HeightDatum::kMeanSeaLevel ||
                      recording.heights == io::HeightDatum::kEllipsoid;
  return of_sea ? " " + std::string(analysis::datum_text(recording.heights)) : std::string();
}

std::string ground_hint(const io::Recording& recording, const analysis::PathBreach& worst,
                        double most_m) {
  const std::string from = counted_from_sea(recording);
  if (from.empty()) return {};
  std::string text =
      "these heights count" + from + ", and limits of law are mostly above the ground";
  const auto ground_m = analysis::took_off_at_m(recording, worst.bee);
  if (ground_m) {
    text += "; the worst is " + io::grouped(worst.excess.peak.value - *ground_m, 1) +
            " m above where " + bee_text(worst.bee, recording) + " took off";
  }
  if (!recording.heights_beside.empty()) {
    text += "; for heights above the place of take-off, if that of all is equally high, add " +
            recording.heights_beside;
  } else if (ground_m) {
    text += "; for " + io::exact(most_m) + " m above that say --max-height " +
            io::exact(std::floor((most_m + *ground_m) * 10.0) / 10.0);
  }
  return text;
}

std::string kept_navigation(const analysis::PathVerdict& verdict) {
  std::string text;
  for (const analysis::NavigationCheck& check : verdict.navigation) {
    if (!check.kept()) continue;
    text.append(text.empty() ? "" : ", ").append(printable(check.name)).append(" ");
    text.append(io::exact(check.height_m)).append(" m: kept");
  }
  if (text.empty()) return text;
  return text + " (below it none moves sideways by more than " +
         io::exact(analysis::kSidewaysAtMost_m) + " m)";
}

std::vector<std::string> low_moves(const analysis::PathVerdict& verdict,
                                   const io::Recording& recording) {
  std::vector<std::string> lines;
  for (const analysis::NavigationCheck& check : verdict.navigation) {
    if (check.kept()) continue;
    lines.push_back(red(printable(analysis::low_move_text(check))) + ": " +
                    bee_text(check.worst->bee, recording) + " at " +
                    io::moment_text(check.worst->at_s, recording));
  }
  return lines;
}

std::vector<std::string> looked_at(const std::vector<std::string>& names,
                                   const analysis::PathVerdict& verdict, bool wanted) {
  std::vector<std::string> some;
  std::copy_if(names.begin(), names.end(), std::back_inserter(some), [&](const auto& name) {
    const auto& checks = verdict.navigation;
    return wanted == std::any_of(checks.begin(), checks.end(),
                                 [&name](const auto& check) { return check.name == name; });
  });
  return some;
}

void write_navigation(io::JsonWriter& json, const analysis::PathVerdict& verdict,
                      const io::Recording& recording) {
  if (verdict.navigation.empty()) return;
  json.begin_array("navigation", io::JsonLayout::kLines);
  for (const analysis::NavigationCheck& check : verdict.navigation) {
    json.begin_object();
    json.member("name", check.name).member("below_m", check.height_m);
    json.member("kept", check.kept());
    if (check.worst) {
      json.member("bees", std::uint64_t{check.bees});
      json.member("id", analysis::name_of(check.worst->bee, recording).id);
      json.member("moved_m", check.worst->moved_m);
      json.member("fastest_mps", check.worst->fastest_mps).member("at_s", check.worst->at_s);
    }
    json.end();
  }
  json.end();
}

}  // namespace beespace::cli
