#include "cli/detect/reports/report.hpp"

#include <utility>

namespace beespace::cli {

Status find_at_risk(const Question& question, std::vector<PointId>& at_risk) {
  if (question.others == nullptr) {
    return question.engine.find_at_risk(question.points, question.search.without_limit(), at_risk);
  }
  return question.engine.find_at_risk_between(question.points, *question.others,
                                              question.search.without_limit(), at_risk);
}

Result<ReportFound> report_at_risk(const Question& question) {
  std::vector<PointId> at_risk;
  if (Status found = find_at_risk(question, at_risk); !found) return std::move(found).error();
  return ReportFound{Table{BeeTable{at_risk, {}}}, at_risk};
}

}  // namespace beespace::cli
