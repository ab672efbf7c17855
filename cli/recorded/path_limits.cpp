#include "cli/recorded/path_limits.hpp"

#include "analysis/recorded/verify_paths.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::cli {

const PathLimitWords& words_of(PathLimit limit) {
  return kPathLimitWords[static_cast<std::size_t>(limit)];
}

double shown_value(const PathPeak& peak, PathLimit limit) {
  const bool signed_one = limit == PathLimit::kClimb || limit == PathLimit::kDescent;
  return signed_one ? std::max(0.0, peak.value) : peak.value;
}

SettledLimits settle_limits(const AskedLimits& asked, const std::optional<io::ShowFacts>& show) {
  SettledLimits settled;
  for (const PathLimitWords& words : kPathLimitWords) {
    const auto which = static_cast<std::size_t>(words.limit);
    std::optional<double> most = asked[which];
    if (!most && show) {
      most = analysis::declared_limit(*show, words.limit);
      settled.declared[which] = most.has_value();
    }
    if (most) settled.limits[words.limit] = *most;
  }
  return settled;
}

std::string limits_text(const SettledLimits& settled) {
  const auto listed = [&](bool declared) {
    std::string text;
    for (const PathLimitWords& words : kPathLimitWords) {
      const double most = settled.limits[words.limit];
      if (!std::isfinite(most) ||
          settled.declared[static_cast<std::size_t>(words.limit)] != declared)
        continue;
      text += (text.empty() ? "" : ", ") + std::string(words.noun) + " " + io::exact(most) + " " +
              words.unit;
    }
    return text;
  };
  std::string text = listed(false);
  const std::string declared = listed(true);
  if (!declared.empty()) {
    text += (text.empty() ? "" : ", ") + declared + " (as the show declares)";
  }
  if (!text.empty()) return text;
  return "not checked (--max-speed, --max-horizontal, --max-climb, --max-descent, "
         "--max-acceleration, --max-height)";
}

}  // namespace beespace::cli
