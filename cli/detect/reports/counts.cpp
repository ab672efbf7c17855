#include "cli/detect/reports/neighbor_finding.hpp"
#include "cli/detect/reports/report.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

namespace beespace::cli {

Result<Table> report_counts(const Question& question) {
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
  return Table{BeeTable{question.listed_bees(), {{"neighbor_count", false, count}}},
               neighbor_finding(sum, counts->size(), most)};
}

}  // namespace beespace::cli
