// What `beespace detect --report` can be asked for: one file for each.
#pragma once

#include "cli/output/table.hpp"

#include <beespace/engine.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

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
  bool at_risk_only;                    // leave out the bees that are not at risk
  const std::vector<PointId>& at_risk;  // found before
  std::optional<ClosestPair> closest;   // likewise, where the report needs it

  // The bees that a report about every bee lists.
  [[nodiscard]] std::vector<PointId> listed_bees() const;
};

struct Report {
  const char* name;      // "closest-pair"
  const char* key;       // of its rows in JSON; empty where the document says it all without
  const char* label;     // of its finding in the summary
  bool takes_others;     // has a form with --others
  bool has_limit;        // obeys --max-results
  bool lists_everybody;  // obeys --at-risk-only
  bool needs_closest;
  bool takes_vertical;  // has a meaning with --vertical
  Result<Table> (*find)(const Question& question);
};

// All of them, the default first.
std::span<const Report> reports();

// Null when there is none of this name.
const Report* find_report(std::string_view name);

Result<Table> report_at_risk(const Question& question);
Result<Table> report_pairs(const Question& question);
Result<Table> report_neighbors(const Question& question);
Result<Table> report_counts(const Question& question);
Result<Table> report_nearest(const Question& question);
Result<Table> report_groups(const Question& question);
Result<Table> report_closest_pair(const Question& question);

}  // namespace beespace::cli
