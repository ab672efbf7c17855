// What `beespace detect --report` can be asked for: one file for each.
#pragma once

#include "cli/output/table.hpp"

#include <beespace/engine.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace beespace::cli {

// What a report has to go by.
struct Question {
  Engine& engine;
  PointsView points;
  const PointsView* others;  // null: the swarm against itself
  PairOptions search;
  bool at_risk_only;  // leave out the bees that are not at risk

  // The bees that a report about every bee lists, of these at risk.
  [[nodiscard]] std::vector<PointId> listed_bees(const std::vector<PointId>& at_risk) const;
};

// What a report found; and the bees at risk, ascending, where that says who they are.
struct ReportFound {
  Table table;
  std::optional<std::vector<PointId>> at_risk = {};
};

struct Report {
  const char* name;     // "closest-pair"
  const char* key;      // of its rows in JSON; empty where the document says it all without
  const char* label;    // of its finding in the summary
  bool takes_others;    // has a form with --others
  bool has_limit;       // obeys --max-results
  bool lists_all;       // obeys --at-risk-only
  bool takes_vertical;  // has a meaning with --vertical
  // Null of the closest pair, which the summary and every JSON document tell too.
  Result<ReportFound> (*find)(const Question& question);
};

// All of them, the default first.
std::span<const Report> reports();

// Null when there is none of this name.
const Report* find_report(std::string_view name);

// The bees, ascending, of which `is_one` says that they are.
template <class IsOne>
std::vector<PointId> bees_that(std::size_t count, const IsOne& is_one) {
  std::vector<PointId> bees;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_one(i)) bees.push_back(static_cast<PointId>(i));
  }
  return bees;
}

Status find_at_risk(const Question& question, std::vector<PointId>& at_risk);

Result<ReportFound> report_at_risk(const Question& question);
Result<ReportFound> report_pairs(const Question& question);
Result<ReportFound> report_neighbors(const Question& question);
Result<ReportFound> report_counts(const Question& question);
Result<ReportFound> report_nearest(const Question& question);
Result<ReportFound> report_groups(const Question& question);

}  // namespace beespace::cli
