#include "cli/detect/reports/report.hpp"

namespace beespace::cli {

Result<Table> report_at_risk(const Question& question) {
  return Table{BeeTable{question.at_risk, {}}};
}

}  // namespace beespace::cli
