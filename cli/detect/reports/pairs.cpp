#include "cli/detect/reports/report.hpp"
#include "io/bytes/number_text.hpp"

#include <utility>

namespace beespace::cli {

Result<Table> report_pairs(const Question& question) {
  PairTable table;
  const Status found =
      question.others == nullptr
          ? question.engine.find_pairs(question.points, question.search, table.pairs)
          : question.engine.find_pairs_between(question.points, *question.others, question.search,
                                               table.pairs);
  if (!found) return found.error();
  std::string finding = table.pairs.empty() ? "none" : io::grouped(table.pairs.size());
  return Table{std::move(table), std::move(finding)};
}

}  // namespace beespace::cli
