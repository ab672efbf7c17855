#include "cli/detect/reports/neighbor_finding.hpp"
#include "cli/detect/reports/report.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace beespace::cli {

Result<ReportFound> report_counts(const Question& question) {
  const auto counts = std::make_shared<std::vector<std::uint32_t>>();
  const Status found =
      question.others == nullptr
          ? question.engine.count_neighbors(question.points, question.search.without_limit(),
                                            *counts)
          : question.engine.count_neighbors_between(question.points, *question.others,
                                                    question.search.without_limit(), *counts);
  if (!found) return found.error();
  const std::uint64_t sum = std::accumulate(counts->begin(), counts->end(), std::uint64_t{0});
  const std::uint64_t most =
      counts->empty() ? 0 : *std::max_element(counts->begin(), counts->end());
  const auto count = [counts](PointId bee) -> Cell { return std::uint64_t{(*counts)[bee]}; };
  std::vector<PointId> at_risk =
      bees_that(counts->size(), [&](std::size_t bee) { return (*counts)[bee] > 0; });
  return ReportFound{
      Table{BeeTable{question.listed_bees(at_risk), {{"neighbor_count", false, count}}},
            neighbor_finding(sum, counts->size(), most)},
      std::move(at_risk)};
}

}  // namespace beespace::cli
