#include "cli/detect/reports/report.hpp"

namespace beespace::cli {

// Found already: the summary and every JSON document name it too.
Result<Table> report_closest_pair(const Question& question) {
  PairTable table;
  if (question.closest) table.pairs.push_back({question.closest->first, question.closest->second});
  return Table{table};
}

}  // namespace beespace::cli
