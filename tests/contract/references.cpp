// The exact oracle and brute force, the two references of the contract.
#include "tests/contract/variants.hpp"
#include "tests/support/exact_oracle.hpp"

#include <beespace/brute_force.hpp>

#include <cmath>
#include <memory>
#include <optional>

namespace beespace::test {

namespace {

Answer flat_rows(const std::vector<std::vector<PointId>>& rows) {
  IdRows flattened;
  flattened.offsets.push_back(0);
  for (const auto& row : rows) {
    flattened.ids.insert(flattened.ids.end(), row.begin(), row.end());
    flattened.offsets.push_back(flattened.ids.size());
  }
  return flat(flattened);
}

// "The square root of the sum of three squares, each step rounded to the nearest double."
double reported_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x;
  const double dy = p.y - q.y;
  const double dz = p.z - q.z;
  const double sum_of_two = dx * dx + dy * dy;
  return std::sqrt(sum_of_two + dz * dz);
}

// Keeps what the inquiries about one subject, and those with the same options, have in common.
class Oracle {
 public:
  Answer ask(const Inquiry& inquiry) {
    prepare(inquiry);
    switch (inquiry.question) {
      case Question::kAtRisk:
      case Question::kAtRiskBetween:
        return flat(neighbors_->at_risk());
      case Question::kPairs:
      case Question::kPairsBetween:
        return limited(neighbors_->pairs().size(), flat(neighbors_->pairs()));
      case Question::kVisitedPairs:
        return flat(neighbors_->pairs());
      case Question::kNeighbors:
      case Question::kNeighborsBetween: {
        std::size_t results = 0;
        for (const auto& row : neighbors_->rows()) results += row.size();
        return limited(results, flat_rows(neighbors_->rows()));
      }
      case Question::kCounts:
      case Question::kCountsBetween:
        return flat(neighbors_->counts());
      case Question::kGroups:
        return flat_rows(neighbors_->groups());
      case Question::kNearest:
      case Question::kNearestBetween:
        return nearest(exact_nearest(*distances_));
      case Question::kNearestWithin:
      case Question::kNearestWithinBetween:
        return nearest(exact_nearest(
            *distances_, [&](std::size_t i) -> const auto& { return neighbors_->rows()[i]; }));
      case Question::kClosestPair:
      case Question::kClosestPairBetween:
        return closest_pair();
    }
    return {};
  }

 private:
  void prepare(const Inquiry& inquiry) {
    const bool same_subject = subject_ == inquiry.subject;
    if (!same_subject) {
      subject_ = inquiry.subject;
      if (subject_->two_sets) {
        distances_.emplace(subject_->points, subject_->others);
      } else {
        distances_.emplace(subject_->points);
      }
    }
    const bool same_options = same_subject && options_.inclusive == inquiry.options.inclusive &&
                              options_.threshold_m == inquiry.options.threshold_m;
    options_ = inquiry.options;
    if (!same_options) neighbors_.emplace(*distances_, options_.without_limit());
  }

  [[nodiscard]] Answer limited(std::size_t results, Answer answer) const {
    if (results <= options_.max_results) return answer;
    return flat(Error{ErrorCode::kTooManyResults, {}, {}});
  }

  [[nodiscard]] const std::vector<Point>& others() const {
    return subject_->two_sets ? subject_->others : subject_->points;
  }

  [[nodiscard]] Answer nearest(const std::vector<std::optional<PointId>>& ids) const {
    std::vector<Nearest> all(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!ids[i]) continue;
      all[i] = {*ids[i], reported_distance(subject_->points[i], others()[*ids[i]])};
    }
    return flat(all);
  }

  [[nodiscard]] Answer closest_pair() const {
    const std::optional<Pair> pair = exact_closest_pair(*distances_);
    if (!pair) return {};
    const double apart = reported_distance(subject_->points[pair->first], others()[pair->second]);
    return flat(std::optional<ClosestPair>({pair->first, pair->second, apart}));
  }

  const Subject* subject_ = nullptr;
  PairOptions options_;
  std::optional<ExactDistances> distances_;
  std::optional<ExactNeighbors> neighbors_;
};

Answer ask_brute_force(const Inquiry& inquiry) {
  const PointsView points = inquiry.subject->view();
  const PointsView others = inquiry.subject->other_view();
  const PairOptions& options = inquiry.options;
  switch (inquiry.question) {
    case Question::kAtRisk:
      return flat(brute_force::find_at_risk(points, options.without_limit()));
    case Question::kPairs:
    case Question::kVisitedPairs:
      return flat(brute_force::find_pairs(points, options));
    case Question::kNeighbors:
      return flat(brute_force::find_neighbors(points, options));
    case Question::kCounts:
      return flat(brute_force::count_neighbors(points, options.without_limit()));
    case Question::kGroups:
      return flat(brute_force::find_conflict_groups(points, options.without_limit()));
    case Question::kNearest:
      return flat(brute_force::find_nearest(points));
    case Question::kNearestWithin:
      return flat(brute_force::find_nearest_within(points, options.without_limit()));
    case Question::kClosestPair:
      return flat(brute_force::find_closest_pair(points));
    case Question::kAtRiskBetween:
      return flat(brute_force::find_at_risk_between(points, others, options.without_limit()));
    case Question::kPairsBetween:
      return flat(brute_force::find_pairs_between(points, others, options));
    case Question::kNeighborsBetween:
      return flat(brute_force::find_neighbors_between(points, others, options));
    case Question::kCountsBetween:
      return flat(brute_force::count_neighbors_between(points, others, options.without_limit()));
    case Question::kNearestBetween:
      return flat(brute_force::find_nearest_between(points, others));
    case Question::kNearestWithinBetween:
      return flat(
          brute_force::find_nearest_within_between(points, others, options.without_limit()));
    case Question::kClosestPairBetween:
      return flat(brute_force::find_closest_pair_between(points, others));
  }
  return {};
}

}  // namespace

Variant oracle() {
  const auto keeper = std::make_shared<Oracle>();
  return {"ExactOracle", [keeper](const Inquiry& inquiry) { return keeper->ask(inquiry); }};
}

Variant brute_force_reference() {
  return {"BruteForce", ask_brute_force};
}

}  // namespace beespace::test
