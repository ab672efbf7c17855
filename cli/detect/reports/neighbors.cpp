#include "cli/detect/reports/neighbor_finding.hpp"
#include "cli/detect/reports/report.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace beespace::cli {

Result<ReportFound> report_neighbors(const Question& question) {
  const auto rows = std::make_shared<IdRows>();
  const Status found = question.others == nullptr
                           ? question.engine.find_neighbors(question.points, question.search, *rows)
                           : question.engine.find_neighbors_between(
                                 question.points, *question.others, question.search, *rows);
  if (!found) return found.error();
  std::uint64_t most = 0;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    most = std::max<std::uint64_t>(most, (*rows)[i].size());
  }
  const auto count = [rows](PointId bee) -> Cell { return std::uint64_t{(*rows)[bee].size()}; };
  const auto neighbors = [rows](PointId bee) -> Cell { return (*rows)[bee]; };
  std::vector<PointId> at_risk =
      bees_that(rows->size(), [&](std::size_t bee) { return !(*rows)[bee].empty(); });
  return ReportFound{
      Table{BeeTable{question.listed_bees(at_risk),
                     {{"neighbor_count", false, count}, {"neighbors", true, neighbors}}},
            neighbor_finding(rows->ids.size(), rows->size(), most)},
      std::move(at_risk)};
}

}  // namespace beespace::cli
