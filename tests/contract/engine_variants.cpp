// Engines that live through all inquiries: nothing that one call leaves behind, in its buffers or
// in the caller's containers, may show in the answer of another.
#include "tests/contract/columns.hpp"
#include "tests/contract/variants.hpp"

#include <beespace/engine.hpp>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

namespace beespace::test {

namespace {

class EngineAndAnswers {
 public:
  EngineAndAnswers(std::shared_ptr<Crew> crew, unsigned threads)
      : crew_(std::move(crew)), engine_(crew_ ? Engine(*crew_) : Engine()), threads_(threads) {}

  Answer ask(const Inquiry& inquiry) {
    PairOptions options = inquiry.options;
    options.threads = threads_;
    const Subject& subject = *inquiry.subject;
    if (subject.two_sets) {
      return ask_two_sets(inquiry.question, subject.view(), subject.other_view(), options);
    }
    return ask_one_set(inquiry.question, subject.view(), options);
  }

 private:
  Answer ask_one_set(Question question, const PointsView& points, const PairOptions& options) {
    switch (question) {
      case Question::kAtRisk:
        return flat_if(engine_.find_at_risk(points, options.without_limit(), ids_), ids_);
      case Question::kPairs:
        return agreed(flat_if(engine_.find_pairs(points, options, pairs_), pairs_),
                      pairs_in_columns(points, points, [&](const auto& room) {
                        return engine_.find_pairs(points, options, room);
                      }));
      case Question::kVisitedPairs:
        return visited_pairs(points, options);
      case Question::kNeighbors:
        return agreed(flat_if(engine_.find_neighbors(points, options, rows_), rows_),
                      rows_in_columns(points, points, [&](const auto& room) {
                        return engine_.find_neighbors(points, options, room);
                      }));
      case Question::kCounts:
        return flat_if(engine_.count_neighbors(points, options.without_limit(), ids_), ids_);
      case Question::kGroups:
        return flat_if(engine_.find_conflict_groups(points, options.without_limit(), rows_), rows_);
      case Question::kNearest:
        return flat_if(engine_.find_nearest(points, nearest_, threads_), nearest_);
      case Question::kNearestWithin:
        return flat_if(engine_.find_nearest_within(points, options.without_limit(), nearest_),
                       nearest_);
      default:
        return flat(engine_.find_closest_pair(points, threads_));
    }
  }

  Answer ask_two_sets(Question question, const PointsView& points, const PointsView& others,
                      const PairOptions& options) {
    switch (question) {
      case Question::kAtRiskBetween:
        return flat_if(engine_.find_at_risk_between(points, others, options.without_limit(), ids_),
                       ids_);
      case Question::kPairsBetween:
        return agreed(flat_if(engine_.find_pairs_between(points, others, options, pairs_), pairs_),
                      pairs_in_columns(points, others, [&](const auto& room) {
                        return engine_.find_pairs_between(points, others, options, room);
                      }));
      case Question::kNeighborsBetween:
        return agreed(
            flat_if(engine_.find_neighbors_between(points, others, options, rows_), rows_),
            rows_in_columns(points, others, [&](const auto& room) {
              return engine_.find_neighbors_between(points, others, options, room);
            }));
      case Question::kCountsBetween:
        return flat_if(
            engine_.count_neighbors_between(points, others, options.without_limit(), ids_), ids_);
      case Question::kNearestBetween:
        return flat_if(engine_.find_nearest_between(points, others, nearest_, threads_), nearest_);
      case Question::kNearestWithinBetween:
        return flat_if(
            engine_.find_nearest_within_between(points, others, options.without_limit(), nearest_),
            nearest_);
      default:
        return flat(engine_.find_closest_pair_between(points, others, threads_));
    }
  }

  template <class Find>
  static Answer pairs_in_columns(const PointsView& points, const PointsView& others, Find&& find) {
    Columns columns;
    const Status status = find(columns.for_pairs());
    return status ? columns.pairs(points, others) : flat(status.error());
  }
  template <class Find>
  static Answer rows_in_columns(const PointsView& points, const PointsView& others, Find&& find) {
    Columns columns;
    const Status status = find(columns.for_rows());
    return status ? columns.rows(points, others) : flat(status.error());
  }

  Answer visited_pairs(const PointsView& points, const PairOptions& options) {
    pairs_.clear();
    const auto finished =
        engine_.visit_pairs(points, options.without_limit(), [&](std::span<const Pair> batch) {
          pairs_.insert(pairs_.end(), batch.begin(), batch.end());
          return true;
        });
    std::sort(pairs_.begin(), pairs_.end());
    return finished ? flat(pairs_) : flat(finished.error());
  }

  std::shared_ptr<Crew> crew_;
  Engine engine_;
  unsigned threads_;
  std::vector<std::uint32_t> ids_;
  std::vector<Pair> pairs_;
  IdRows rows_;
  std::vector<Nearest> nearest_;
};

Variant engine(const std::string& name, std::shared_ptr<Crew> crew, unsigned threads) {
  const auto kept = std::make_shared<EngineAndAnswers>(std::move(crew), threads);
  return {name, [kept](const Inquiry& inquiry) { return kept->ask(inquiry); }};
}

}  // namespace

Variant engine_with_crew(const std::string& name, std::shared_ptr<Crew> crew) {
  return engine(name, std::move(crew), 1);
}

Variant engine_with_threads(unsigned threads) {
  return engine("Engine" + std::to_string(threads), nullptr, threads);
}

}  // namespace beespace::test
