// The functions of the public headers, with every number of threads and layout of the points.
#include "tests/contract/variants.hpp"

#include <beespace/beespace.hpp>

#include <algorithm>
#include <span>

namespace beespace::test {

namespace {

Answer visited_pairs(const PointsView& points, const PairOptions& options) {
  std::vector<Pair> pairs;
  bool batches_fit = true;
  const Result<bool> finished =
      visit_pairs(points, options.without_limit(), [&](std::span<const Pair> batch) {
        batches_fit = batches_fit && !batch.empty() && batch.size() <= kMostPairsAtOnce;
        pairs.insert(pairs.end(), batch.begin(), batch.end());
        return true;
      });
  if (!finished) return flat(finished.error());
  if (!*finished || !batches_fit) return {0, 0, 0};
  std::sort(pairs.begin(), pairs.end());
  return flat(pairs);
}

Answer ask_two_sets(Question question, const PointsView& points, const PointsView& others,
                    const PairOptions& options) {
  switch (question) {
    case Question::kAtRiskBetween:
      return flat(find_at_risk_between(points, others, options.without_limit()));
    case Question::kPairsBetween:
      return flat(find_pairs_between(points, others, options));
    case Question::kNeighborsBetween:
      return flat(find_neighbors_between(points, others, options));
    case Question::kCountsBetween:
      return flat(count_neighbors_between(points, others, options.without_limit()));
    case Question::kNearestBetween:
      return flat(find_nearest_between(points, others, options.threads));
    case Question::kNearestWithinBetween:
      return flat(find_nearest_within_between(points, others, options.without_limit()));
    default:
      return flat(find_closest_pair_between(points, others, options.threads));
  }
}

Answer ask_one_set(Question question, const PointsView& points, const PairOptions& options) {
  switch (question) {
    case Question::kAtRisk:
      return flat(find_at_risk(points, options.without_limit()));
    case Question::kPairs:
      return flat(find_pairs(points, options));
    case Question::kVisitedPairs:
      return visited_pairs(points, options);
    case Question::kNeighbors:
      return flat(find_neighbors(points, options));
    case Question::kCounts:
      return flat(count_neighbors(points, options.without_limit()));
    case Question::kGroups:
      return flat(find_conflict_groups(points, options.without_limit()));
    case Question::kNearest:
      return flat(find_nearest(points, options.threads));
    case Question::kNearestWithin:
      return flat(find_nearest_within(points, options.without_limit()));
    default:
      return flat(find_closest_pair(points, options.threads));
  }
}

Answer ask(const Inquiry& inquiry, const PointsView& points, const PointsView& others,
           unsigned threads) {
  PairOptions options = inquiry.options;
  options.threads = threads;
  if (inquiry.subject->two_sets) return ask_two_sets(inquiry.question, points, others, options);
  return ask_one_set(inquiry.question, points, options);
}

// The same points, one array an axis, back to front in memory.
class BackwardArrays {
 public:
  explicit BackwardArrays(const std::vector<Point>& points) : size_(points.size()) {
    for (auto p = points.rbegin(); p != points.rend(); ++p) {
      x_.push_back(p->x);
      y_.push_back(p->y);
      z_.push_back(p->z);
    }
  }

  [[nodiscard]] PointsView view() const {
    if (size_ == 0) return {};
    return PointsView::strided(&x_.back(), &y_.back(), &z_.back(), size_,
                               -static_cast<std::ptrdiff_t>(sizeof(double)));
  }

 private:
  std::size_t size_;
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> z_;
};

}  // namespace

Variant public_functions(unsigned threads) {
  return {"Functions" + std::to_string(threads), [threads](const Inquiry& inquiry) {
            return ask(inquiry, inquiry.subject->view(), inquiry.subject->other_view(), threads);
          }};
}

Variant public_functions_of_strided_points() {
  return {"FunctionsOfStridedPoints", [](const Inquiry& inquiry) {
            const BackwardArrays points(inquiry.subject->points);
            const BackwardArrays others(inquiry.subject->others);
            return ask(inquiry, points.view().with_heights(inquiry.subject->heights),
                       others.view().with_heights(inquiry.subject->other_heights), 1);
          }};
}

}  // namespace beespace::test
