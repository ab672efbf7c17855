#include "tests/differential/cylinder_variants.hpp"

#include "tests/contract/backward_crew.hpp"

#include "base/memory.hpp"
#include "search/cylinder_search.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace beespace::differential {

namespace {

using search::TuningOverrides;
using test::Answer;
using test::flat_if;
using test::Inquiry;
using test::Question;

// Keeps its memory from one inquiry to the next, as an Engine does.
class ForcedCylinders {
 public:
  ForcedCylinders(const TuningOverrides& tuning, unsigned workers)
      : tuning_(tuning), crew_(workers) {}

  Answer ask(const Inquiry& inquiry) {
    const PointsView points = inquiry.subject->view();
    const PointsView others = inquiry.subject->other_view();
    memory_.start_call();
    const search::CylinderSearch search(points, inquiry.subject->two_sets ? &others : nullptr,
                                        inquiry.options, with_, tuning_);
    search::PairVector pair_answer(pairs_);
    search::RowVectors row_answer(rows_, points.size());
    switch (inquiry.question) {
      case Question::kAtRisk:
      case Question::kAtRiskBetween:
        return flat_if(search.find_at_risk(ids_), ids_);
      case Question::kPairs:
      case Question::kPairsBetween:
        return flat_if(search.find_pairs(pair_answer), pairs_);
      case Question::kNeighbors:
      case Question::kNeighborsBetween:
        return flat_if(search.find_neighbors(row_answer), rows_);
      case Question::kCounts:
      case Question::kCountsBetween:
        return flat_if(search.count_neighbors(ids_), ids_);
      case Question::kGroups:
        return flat_if(search.find_groups(rows_), rows_);
      case Question::kNearestWithin:
      case Question::kNearestWithinBetween:
        return flat_if(search.find_nearest(nearest_), nearest_);
      default:
        return visited_pairs(search);
    }
  }

 private:
  Answer visited_pairs(const search::CylinderSearch& search) {
    pairs_.clear();
    const auto all = search.visit_pairs([&](std::span<const Pair> batch) {
      pairs_.insert(pairs_.end(), batch.begin(), batch.end());
      return true;
    });
    std::sort(pairs_.begin(), pairs_.end());
    return all && *all ? test::flat(pairs_) : Answer{0, 0, 0};
  }

  TuningOverrides tuning_;
  test::BackwardCrew crew_;
  core::Memory memory_;
  core::Resources with_{crew_, memory_};
  std::vector<std::uint32_t> ids_;
  std::vector<Pair> pairs_;
  IdRows rows_;
  std::vector<Nearest> nearest_;
};

}  // namespace

std::vector<test::Variant> forced_cylinders() {
  std::vector<test::Variant> all;
  for (const auto& [crowds, name] :
       {std::pair(TuningOverrides::Crowds::kNever, "CylinderRows"),
        std::pair(TuningOverrides::Crowds::kAlways, "CylinderTrees")}) {
    for (const unsigned workers : {1U, 3U}) {
      TuningOverrides tuning;
      tuning.crowds = crowds;
      const auto kept = std::make_shared<ForcedCylinders>(tuning, workers);
      all.push_back({name + std::to_string(workers),
                     [kept](const Inquiry& inquiry) { return kept->ask(inquiry); },
                     {}});
    }
  }
  return all;
}

}  // namespace beespace::differential
