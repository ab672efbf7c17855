// The searches with the tuning that they make from the data forced upon them: every instruction
// set of this processor, narrow and wide rows, folded axes, crowds taken as a whole or never, every
// way to find points at risk, trees instead of grids.
#include "tests/contract/backward_crew.hpp"
#include "tests/contract/columns.hpp"
#include "tests/contract/variants.hpp"

#include "base/memory.hpp"
#include "search/at_risk_search.hpp"
#include "search/column_answer.hpp"
#include "search/group_search.hpp"
#include "search/nearest_search.hpp"
#include "search/pair_answer.hpp"
#include "search/pair_search.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/nearest.hpp>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace beespace::test {

namespace {

using search::TuningOverrides;

// Keeps memory and answers from one inquiry to the next, as an Engine does.
class ForcedSearch {
 public:
  ForcedSearch(const TuningOverrides& tuning, unsigned workers) : tuning_(tuning), crew_(workers) {}

  Answer ask(const Inquiry& inquiry) {
    const Subject& subject = *inquiry.subject;
    const PointsView points = subject.points;
    const PointsView others = subject.others;
    const Result<search::SearchDomain> domain =
        subject.two_sets ? search::SearchDomain::of(points, others, with_)
                         : search::SearchDomain::of(points, with_);
    if (!domain) return flat(domain.error());
    return ask(inquiry, *domain);
  }

 private:
  Answer ask(const Inquiry& inquiry, const search::SearchDomain& domain) {
    const PairOptions& options = inquiry.options;
    switch (inquiry.question) {
      case Question::kAtRisk:
      case Question::kAtRiskBetween:
        search::find_at_risk(domain, options, with_, tuning_, ids_);
        return flat(ids_);
      case Question::kPairs:
      case Question::kPairsBetween:
        return pairs(domain, options);
      case Question::kVisitedPairs:
        return visited_pairs(domain, options);
      case Question::kNeighbors:
      case Question::kNeighborsBetween:
        return neighbors(domain, options);
      case Question::kCounts:
      case Question::kCountsBetween:
        search::count_neighbors(domain, options, with_, tuning_, ids_);
        return flat(ids_);
      case Question::kGroups:
        search::find_conflict_groups(domain, options, with_, tuning_, rows_);
        return flat(rows_);
      case Question::kNearest:
      case Question::kNearestBetween:
        search::find_nearest(domain, std::nullopt, with_, tuning_, nearest_);
        return flat(nearest_);
      case Question::kNearestWithin:
      case Question::kNearestWithinBetween:
        search::find_nearest(domain, options, with_, tuning_, nearest_);
        return flat(nearest_);
      case Question::kClosestPair:  // has no tuning
        return flat(find_closest_pair(inquiry.subject->points));
      case Question::kClosestPairBetween:
        return flat(search::find_closest_between(domain, with_, tuning_, nearest_));
    }
    return {};
  }

  Answer pairs(const search::SearchDomain& domain, const PairOptions& options) {
    search::PairVector in_vector(pairs_);
    const Status status = search::find_pairs(domain, options, with_, tuning_, in_vector);
    if (!status) return flat(status.error());
    Columns columns;
    const PairRoom room = columns.for_pairs();
    search::PairColumnsAnswer in_columns(room, domain.points(), domain.others());
    if (!search::find_pairs(domain, options, with_, tuning_, in_columns)) return kBadColumns;
    return agreed(flat(pairs_), columns.pairs(domain.points(), domain.others()));
  }

  Answer neighbors(const search::SearchDomain& domain, const PairOptions& options) {
    search::RowVectors in_vectors(rows_, domain.points().size());
    const Status status = search::find_neighbors(domain, options, with_, tuning_, in_vectors);
    if (!status) return flat(status.error());
    Columns columns;
    const RowRoom room = columns.for_rows();
    search::RowColumnsAnswer in_columns(room, domain.points(), domain.others());
    if (!search::find_neighbors(domain, options, with_, tuning_, in_columns)) return kBadColumns;
    return agreed(flat(rows_), columns.rows(domain.points(), domain.others()));
  }

  Answer visited_pairs(const search::SearchDomain& domain, const PairOptions& options) {
    pairs_.clear();
    const bool all =
        search::visit_pairs(domain, options, with_, tuning_, [&](std::span<const Pair> batch) {
          pairs_.insert(pairs_.end(), batch.begin(), batch.end());
          return true;
        });
    std::sort(pairs_.begin(), pairs_.end());
    return all ? flat(pairs_) : Answer{0, 0, 0};
  }

  TuningOverrides tuning_;
  BackwardCrew crew_;
  core::Memory memory_;
  core::Resources with_{crew_, memory_};
  std::vector<std::uint32_t> ids_;
  std::vector<Pair> pairs_;
  IdRows rows_;
  std::vector<Nearest> nearest_;
};

Variant forced(const std::string& name, const TuningOverrides& tuning, unsigned workers) {
  const auto kept = std::make_shared<ForcedSearch>(tuning, workers);
  return {name, [kept](const Inquiry& inquiry) { return kept->ask(inquiry); }, {}};
}

// "avx2", say; the name of the widest set that this machine has ends in "Widest", so that a test
// run can be asked for it on any machine.
std::string variant_name(cpu::InstructionSet set) {
  const auto wider = [set](cpu::InstructionSet other) {
    return other > set && cpu::is_available(other);
  };
  const bool widest =
      std::none_of(std::begin(cpu::kInstructionSets), std::end(cpu::kInstructionSets), wider);
  return std::string(cpu::name_of(set)) + (widest ? "Widest" : "");
}

}  // namespace

std::vector<Variant> forced_kernels() {
  std::vector<Variant> all;
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    const std::string name = variant_name(set);
    TuningOverrides tuning;
    tuning.method = TuningOverrides::Method::kSweep;
    tuning.crowds = TuningOverrides::Crowds::kNever;
    tuning.nearest = TuningOverrides::Nearest::kGrids;
    tuning.instruction_set = set;
    all.push_back(forced(name, tuning, 1));
    for (const unsigned row_shift : {0U, 2U, 30U}) {
      tuning.row_shift = row_shift;
      const unsigned workers = 1 + row_shift % 4;
      all.push_back(forced(name + "RowShift" + std::to_string(row_shift), tuning, workers));
    }
    tuning.row_shift = {};
    tuning.fold_beyond_cells = 4;
    all.push_back(forced(name + "Folded", tuning, 3));
  }
  return all;
}

std::vector<Variant> forced_crowds() {
  std::vector<Variant> all;
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    TuningOverrides tuning;
    tuning.crowds = TuningOverrides::Crowds::kAlways;
    tuning.instruction_set = set;
    for (const unsigned workers : {1U, 3U}) {
      const std::string name = variant_name(set) + "Crowds" + std::to_string(workers);
      all.push_back(forced(name, tuning, workers));
      all.back().questions = {Question::kCounts, Question::kCountsBetween, Question::kGroups};
    }
    tuning.fold_beyond_cells = 4;
    all.push_back(forced(variant_name(set) + "CrowdsFolded", tuning, 2));
    all.back().questions = {Question::kCounts, Question::kCountsBetween, Question::kGroups};
  }
  return all;
}

std::vector<Variant> forced_trees() {
  std::vector<Variant> all;
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    TuningOverrides tuning;
    tuning.instruction_set = set;
    tuning.nearest = TuningOverrides::Nearest::kTree;
    tuning.method = TuningOverrides::Method::kBoxes;
    tuning.crowds = TuningOverrides::Crowds::kAlways;
    tuning.crowd_decisions = 0;
    for (const unsigned workers : {1U, 3U}) {
      const std::string name = variant_name(set) + "Trees" + std::to_string(workers);
      all.push_back(forced(name, tuning, workers));
      all.back().questions = {Question::kNearest,        Question::kNearestWithin,
                              Question::kNearestBetween, Question::kNearestWithinBetween,
                              Question::kAtRiskBetween,  Question::kClosestPairBetween,
                              Question::kCounts,         Question::kCountsBetween,
                              Question::kGroups};
    }
  }
  return all;
}

std::vector<Variant> forced_shells() {
  std::vector<Variant> all;
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    TuningOverrides tuning;
    tuning.instruction_set = set;
    tuning.nearest = TuningOverrides::Nearest::kShells;
    all.push_back(forced(variant_name(set) + "Shells", tuning, 2));
    all.back().questions = {Question::kNearestBetween, Question::kNearestWithinBetween,
                            Question::kClosestPairBetween};
  }
  return all;
}

std::vector<Variant> forced_methods() {
  std::vector<Variant> all;
  using Method = TuningOverrides::Method;
  for (const auto& [method, name] :
       {std::pair(Method::kAutomatic, "Automatic"), std::pair(Method::kSweep, "Sweep"),
        std::pair(Method::kProveThenSweep, "ProveThenSweep"),
        std::pair(Method::kProveThenLook, "ProveThenLook")}) {
    for (const auto& [table, table_name] : {std::pair(core::CellTable::kDense, "Dense"),
                                            std::pair(core::CellTable::kHashed, "Hashed")}) {
      for (const unsigned workers : {1U, 2U, 5U}) {
        TuningOverrides tuning;
        tuning.method = method;
        tuning.cell_table = table;
        const std::string full_name = std::string(name) + table_name + std::to_string(workers);
        all.push_back(forced(full_name, tuning, workers));
        all.back().questions = {Question::kAtRisk};
      }
    }
  }
  return all;
}

}  // namespace beespace::test
