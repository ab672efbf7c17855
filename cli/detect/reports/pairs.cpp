#include "cli/detect/reports/report.hpp"
#include "io/bytes/number_text.hpp"

#include <utility>

namespace beespace::cli {

Result<ReportFound> report_pairs(const Question& question) {
  PairTable table;
  const Status found =
      question.others == nullptr
          ? question.engine.find_pairs(question.points, question.search, table.pairs)
          : question.engine.find_pairs_between(question.points, *question.others, question.search,
                                               table.pairs);
  if (!found) return found.error();
  std::vector<bool> marked(question.points.size());
  for (const Pair& pair : table.pairs) {
    marked[pair.first] = true;
    if (question.others == nullptr) marked[pair.second] = true;
  }
  std::vector<PointId> at_risk =
      bees_that(marked.size(), [&](std::size_t bee) -> bool { return marked[bee]; });
  std::string finding = table.pairs.empty() ? "none" : io::grouped(table.pairs.size());
  return ReportFound{Table{std::move(table), std::move(finding)}, std::move(at_risk)};
}

}  // namespace beespace::cli
