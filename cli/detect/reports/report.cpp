#include "cli/detect/reports/report.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace beespace::cli {

std::vector<PointId> Question::listed_bees(const std::vector<PointId>& at_risk) const {
  if (at_risk_only) return at_risk;
  std::vector<PointId> all(points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  return all;
}

std::span<const Report> reports() {
  static constexpr std::array kReports = {
      Report{"at-risk", "at_risk", "", true, false, false, true, report_at_risk},
      Report{"pairs", "pairs", "pairs", true, true, false, true, report_pairs},
      Report{"neighbors", "neighbors", "neighbours", true, true, true, true, report_neighbors},
      Report{"counts", "counts", "neighbours", true, false, true, true, report_counts},
      Report{"nearest", "nearest", "nearest", true, false, true, true, report_nearest},
      Report{"groups", "groups", "groups", false, false, false, true, report_groups},
      Report{"closest-pair", "", "", true, false, false, false, nullptr},
  };
  return kReports;
}

const Report* find_report(std::string_view name) {
  const auto all = reports();
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const Report& r) { return r.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace beespace::cli
