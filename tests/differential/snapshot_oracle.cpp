#include "tests/differential/snapshot_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace beespace::differential {

namespace {

Whole distance_squared(const Whole& x, const Whole& y, const Whole& z) {
  return squared(x) + squared(y) + squared(z);
}

Answer flat_rows(const std::vector<std::vector<PointId>>& rows) {
  IdRows all;
  all.offsets.push_back(0);
  for (const auto& row : rows) {
    all.ids.insert(all.ids.end(), row.begin(), row.end());
    all.offsets.push_back(all.ids.size());
  }
  return test::flat(all);
}

Answer too_many_results() {
  return test::flat(Error{ErrorCode::kTooManyResults, {}, {}});
}

}  // namespace

SnapshotOracle::SnapshotOracle(const Subject& subject, const PairOptions& options)
    : subject_(subject),
      options_(options),
      upright_(options.vertical_m.has_value()),
      apart_(upright_ && (!subject.heights.empty() || !subject.other_heights.empty())) {
  Unit unit;
  for (const auto* points : {&subject.points, &subject.others}) {
    for (const Point& p : *points) {
      for (const double value : {p.x, p.y, p.z}) unit.include(value);
    }
  }
  for (const double height : subject.heights) unit.include(height);
  for (const double height : subject.other_heights) unit.include(height);
  unit.include(options.threshold_m);
  unit.include(options.vertical_m.value_or(0.0));
  unit_ = unit.exponent();
  threshold_ = whole(options.threshold_m, unit_);
  vertical_ = whole(options.vertical_m.value_or(0.0), unit_);
  const Parts metres = parts_of(options.height_unit_m);
  metre_shift_ = std::max(0, -metres.exponent);
  height_unit_ = whole(options.height_unit_m, -metre_shift_);
  ours_ = places_of(subject.points, subject.heights);
  theirs_ = places_of(subject.others, subject.other_heights);
  by_x_.resize(others().size());
  std::iota(by_x_.begin(), by_x_.end(), PointId{0});
  std::sort(by_x_.begin(), by_x_.end(),
            [&](PointId i, PointId j) { return others()[i].x < others()[j].x; });
}

std::vector<SnapshotOracle::Place> SnapshotOracle::places_of(
    const std::vector<Point>& points, std::span<const double> heights) const {
  std::vector<Place> places;
  places.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    Place place{whole(p.x, unit_), whole(p.y, unit_), whole(p.z, unit_), 0};
    place.height = apart_ ? whole(heights[i], unit_) : place.z;
    places.push_back(place);
  }
  return places;
}

Whole SnapshotOracle::squared_line(const Place& p, const Place& q) const {
  const Whole far = distance_squared(q.x - p.x, q.y - p.y, q.z - p.z);
  if (!apart_) return far;
  return (far << (2 * metre_shift_)) + squared((q.height - p.height) * height_unit_);
}

const std::vector<SnapshotOracle::Place>& SnapshotOracle::others() const {
  return subject_.two_sets ? theirs_ : ours_;
}

const std::vector<Point>& SnapshotOracle::other_points() const {
  return subject_.two_sets ? subject_.others : subject_.points;
}

bool SnapshotOracle::below(const Whole& value, const Whole& limit) const {
  return options_.inclusive ? value <= limit : value < limit;
}

bool SnapshotOracle::near(const Place& p, const Place& q) const {
  const Whole x = p.x - q.x;
  const Whole y = p.y - q.y;
  const Whole z = p.z - q.z;
  if (!upright_) return below(distance_squared(x, y, z), squared(threshold_));
  const Whole level = distance_squared(x, y, apart_ ? z : Whole(0));
  return below(level, squared(threshold_)) && below(abs(p.height - q.height), vertical_);
}

const SnapshotOracle::Rows& SnapshotOracle::rows() {
  if (rows_) return *rows_;
  rows_.emplace(ours_.size());
  for (std::size_t i = 0; i < ours_.size(); ++i) {
    const Place& p = ours_[i];
    // Points farther away along x than the threshold are farther away.
    const auto first =
        std::lower_bound(by_x_.begin(), by_x_.end(), Whole(p.x - threshold_),
                         [&](PointId j, const Whole& x) { return others()[j].x < x; });
    for (auto j = first; j != by_x_.end() && others()[*j].x - p.x <= threshold_; ++j) {
      if (!subject_.two_sets && *j == i) continue;
      if (near(p, others()[*j])) (*rows_)[i].push_back(*j);
    }
    std::sort((*rows_)[i].begin(), (*rows_)[i].end());
  }
  return *rows_;
}

std::vector<Pair> SnapshotOracle::all_pairs() {
  std::vector<Pair> all;
  for (std::size_t i = 0; i < rows().size(); ++i) {
    for (const PointId j : rows()[i]) {
      if (subject_.two_sets || i < j) all.push_back({static_cast<PointId>(i), j});
    }
  }
  return all;
}

std::size_t SnapshotOracle::pairs() {
  std::size_t count = 0;
  for (const auto& row : rows()) count += row.size();
  return subject_.two_sets ? count : count / 2;
}

Answer SnapshotOracle::ids_at_risk() {
  std::vector<PointId> ids;
  for (std::size_t i = 0; i < rows().size(); ++i) {
    if (!rows()[i].empty()) ids.push_back(static_cast<PointId>(i));
  }
  return test::flat(ids);
}

// From each point that is in no group yet, on to all that can be got to.
Answer SnapshotOracle::groups() {
  Rows groups;
  std::vector<bool> seen(rows().size());
  for (std::size_t i = 0; i < rows().size(); ++i) {
    if (seen[i] || rows()[i].empty()) continue;
    std::vector<PointId> group = {static_cast<PointId>(i)};
    seen[i] = true;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (const PointId j : rows()[group[next]]) {
        if (seen[j]) continue;
        seen[j] = true;
        group.push_back(j);
      }
    }
    std::sort(group.begin(), group.end());
    groups.push_back(group);
  }
  return flat_rows(groups);
}

// The reported distance: by nearest.hpp the root of the sum of the squares, each step rounded to
// the nearest double.
Nearest SnapshotOracle::reported(std::size_t i, std::optional<PointId> j) const {
  if (!j) return {};
  const Point& p = subject_.points[i];
  const Point& q = other_points()[*j];
  const double x = p.x - q.x;
  const double y = p.y - q.y;
  const double z = p.z - q.z;
  if (!apart_) return {*j, std::sqrt(x * x + y * y + z * z)};
  const auto& heights = subject_.two_sets ? subject_.other_heights : subject_.heights;
  const double up = (subject_.heights[i] - heights[*j]) * options_.height_unit_m;
  return {*j, std::sqrt(x * x + y * y + z * z + up * up)};
}

// Outwards along x in both directions, until that alone is farther than the nearest so far.
std::optional<PointId> SnapshotOracle::nearest_to(std::size_t i) const {
  const Place& p = ours_[i];
  std::optional<PointId> best;
  Whole least;
  const auto look_at = [&](PointId j) {
    const Place& q = others()[j];
    if (best && squared(q.x - p.x) > least) return false;
    if (!subject_.two_sets && j == i) return true;
    const Whole far = distance_squared(q.x - p.x, q.y - p.y, q.z - p.z);
    if (!best || far < least || (far == least && j < *best)) {
      best = j;
      least = far;
    }
    return true;
  };
  const auto middle =
      std::lower_bound(by_x_.begin(), by_x_.end(), p.x,
                       [&](PointId j, const Whole& x) { return others()[j].x < x; });
  for (auto right = middle; right != by_x_.end() && look_at(*right);) ++right;
  for (auto left = middle; left != by_x_.begin() && look_at(*(left - 1));) --left;
  return best;
}

Answer SnapshotOracle::nearest() {
  std::vector<Nearest> all;
  for (std::size_t i = 0; i < ours_.size(); ++i) all.push_back(reported(i, nearest_to(i)));
  return test::flat(all);
}

Answer SnapshotOracle::nearest_within() {
  std::vector<Nearest> all;
  for (std::size_t i = 0; i < ours_.size(); ++i) {
    const Place& p = ours_[i];
    std::optional<PointId> best;
    Whole least;
    for (const PointId j : rows()[i]) {
      const Whole far = squared_line(p, others()[j]);
      if (best && far >= least) continue;
      best = j;
      least = far;
    }
    all.push_back(reported(i, best));
  }
  return test::flat(all);
}

Answer SnapshotOracle::closest_pair() {
  std::optional<Pair> closest;
  Whole least;
  for (std::size_t i = 0; i < ours_.size(); ++i) {
    const auto j = nearest_to(i);
    if (!j) continue;
    const Place& q = others()[*j];
    const Whole far = distance_squared(q.x - ours_[i].x, q.y - ours_[i].y, q.z - ours_[i].z);
    Pair pair{static_cast<PointId>(i), *j};
    if (!subject_.two_sets && pair.second < pair.first) std::swap(pair.first, pair.second);
    if (!closest || far < least || (far == least && pair < *closest)) {
      closest = pair;
      least = far;
    }
  }
  if (!closest) return {};
  const Nearest one = reported(closest->first, closest->second);
  return test::flat(std::optional<ClosestPair>({closest->first, closest->second, one.distance_m}));
}

Answer SnapshotOracle::answer(Question question, std::uint64_t max_results) {
  switch (question) {
    case Question::kAtRisk:
    case Question::kAtRiskBetween:
      return ids_at_risk();
    case Question::kPairs:
    case Question::kPairsBetween:
      return pairs() > max_results ? too_many_results() : test::flat(all_pairs());
    case Question::kVisitedPairs:
      return test::flat(all_pairs());
    case Question::kNeighbors:
    case Question::kNeighborsBetween: {
      const std::size_t results = subject_.two_sets ? pairs() : 2 * pairs();
      return results > max_results ? too_many_results() : flat_rows(rows());
    }
    case Question::kCounts:
    case Question::kCountsBetween: {
      std::vector<std::uint32_t> counts;
      for (const auto& row : rows()) counts.push_back(static_cast<std::uint32_t>(row.size()));
      return test::flat(counts);
    }
    case Question::kGroups:
      return groups();
    case Question::kNearest:
    case Question::kNearestBetween:
      return nearest();
    case Question::kNearestWithin:
    case Question::kNearestWithinBetween:
      return nearest_within();
    case Question::kClosestPair:
    case Question::kClosestPairBetween:
      return closest_pair();
  }
  return {};
}

}  // namespace beespace::differential
