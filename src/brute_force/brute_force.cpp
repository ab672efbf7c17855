#include <beespace/brute_force.hpp>

#include "exact/cylinder.hpp"
#include "exact/exact_distance.hpp"
#include "exact/validate.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace beespace::brute_force {

namespace {

// One search, of points among themselves or against others.
class Pairing {
 public:
  explicit Pairing(const PointsView& points) : points_(points), others_(points), alone_(true) {}
  Pairing(const PointsView& points, const PointsView& others)
      : points_(points), others_(others), alone_(false) {}

  [[nodiscard]] std::optional<Error> check(const PairOptions& options) const {
    if (auto error = core::check_options(options)) return error;
    if (auto error = alone_ ? core::check_vertical(options, points_)
                            : core::check_vertical(options, points_, others_)) {
      return error;
    }
    return check();
  }
  // Of a question without a threshold.
  [[nodiscard]] std::optional<Error> check_positions() const {
    if (auto error = core::check_no_heights(points_, core::kPointsName)) return error;
    if (auto error = core::check_no_heights(others_, core::kOthersName)) return error;
    return check();
  }
  [[nodiscard]] std::optional<Error> check() const {
    if (auto error = core::check_set(points_, core::kPointsName)) return error;
    if (alone_) return std::nullopt;
    return core::check_set(others_, core::kOthersName);
  }

  [[nodiscard]] PointId size() const { return static_cast<PointId>(points_.size()); }

  // Calls visit(i, j) for all pairs of a point and another one, in ascending order.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (PointId i = 0; i < size(); ++i) {
      for (PointId j = 0; j < others_.size(); ++j) {
        if (!alone_ || i != j) visit(i, j);
      }
    }
  }
  template <class Visit>
  void for_each_closer(const PairOptions& options, Visit&& visit) const {
    if (options.vertical_m) {
      const core::CylinderTest closer(options);
      const Uprights uprights(*this);
      for_each([&](PointId i, PointId j) {
        if (closer(uprights.points[i], uprights.others[j])) visit(i, j);
      });
      return;
    }
    const core::ProximityTest closer(options.threshold_m, options.inclusive);
    for_each([&](PointId i, PointId j) {
      if (closer(points_[i], others_[j])) visit(i, j);
    });
  }

  // Both sets in the form for a vertical threshold.
  struct Uprights {
    core::UprightPoints points;
    core::UprightPoints others;

    explicit Uprights(const Pairing& of)
        : points(core::upright(of.points_, of.have_heights())),
          others(core::upright(of.others_, of.have_heights())) {}
  };

  [[nodiscard]] double distance_m(PointId i, PointId j) const {
    return distance(points_[i], others_[j]);
  }
  // Whether points_[i] and others_[j] are nearer to each other than points_[k] and others_[l].
  [[nodiscard]] bool nearer(PointId i, PointId j, PointId k, PointId l) const {
    return core::compare_distances(points_[i], others_[j], points_[k], others_[l]) < 0;
  }

 private:
  [[nodiscard]] bool have_heights() const { return points_.has_heights() || others_.has_heights(); }

  const PointsView& points_;
  const PointsView& others_;
  bool alone_;
};

Error too_many(const PairOptions& options) {
  return core::too_many_results(options.max_results);
}

Result<std::vector<PointId>> at_risk(const Pairing& pairing, const PairOptions& options) {
  if (auto error = pairing.check(options)) return *std::move(error);
  std::vector<PointId> ids;
  pairing.for_each_closer(options, [&](PointId i, PointId) {
    if (ids.empty() || ids.back() != i) ids.push_back(i);
  });
  return ids;
}

Result<std::vector<Pair>> pairs_of(const Pairing& pairing, const PairOptions& options, bool once) {
  if (auto error = pairing.check(options)) return *std::move(error);
  std::vector<Pair> pairs;
  pairing.for_each_closer(options, [&](PointId i, PointId j) {
    if (!once || i < j) pairs.push_back({i, j});
  });
  if (pairs.size() > options.max_results) return too_many(options);
  return pairs;
}

Result<IdRows> neighbors_of(const Pairing& pairing, const PairOptions& options) {
  if (auto error = pairing.check(options)) return *std::move(error);
  IdRows rows;
  if (pairing.size() == 0) return rows;
  rows.offsets.assign(std::size_t{pairing.size()} + 1, 0);
  pairing.for_each_closer(options, [&](PointId i, PointId j) {
    ++rows.offsets[i + 1];
    rows.ids.push_back(j);
  });
  std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
  if (rows.ids.size() > options.max_results) return too_many(options);
  return rows;
}

Result<std::vector<std::uint32_t>> counts_of(const Pairing& pairing, const PairOptions& options) {
  if (auto error = pairing.check(options)) return *std::move(error);
  std::vector<std::uint32_t> counts(pairing.size());
  pairing.for_each_closer(options, [&](PointId i, PointId) { ++counts[i]; });
  return counts;
}

std::optional<ClosestPair> closest_of(const Pairing& pairing) {
  std::optional<ClosestPair> closest;
  pairing.for_each([&](PointId i, PointId j) {
    if (closest && !pairing.nearer(i, j, closest->first, closest->second)) return;
    closest = ClosestPair{i, j, pairing.distance_m(i, j)};
  });
  return closest;
}

void keep_nearer(const Pairing& pairing, PointId i, PointId j, std::vector<Nearest>& nearest) {
  const PointId best = nearest[i].id;
  if (best != Nearest::kNone && !pairing.nearer(i, j, i, best)) return;
  nearest[i] = {j, pairing.distance_m(i, j)};
}

Result<std::vector<Nearest>> nearest_of(const Pairing& pairing) {
  if (auto error = pairing.check_positions()) return *std::move(error);
  std::vector<Nearest> nearest(pairing.size());
  pairing.for_each([&](PointId i, PointId j) { keep_nearer(pairing, i, j, nearest); });
  return nearest;
}

// The nearest by the straight line among those in the cylinder.
std::vector<Nearest> nearest_in_cylinder(const Pairing& pairing, const PairOptions& options) {
  std::vector<Nearest> nearest(pairing.size());
  const Pairing::Uprights uprights(pairing);
  const core::StraightLine line(options.height_unit_m);
  pairing.for_each_closer(options, [&](PointId i, PointId j) {
    const core::Upright here = uprights.points[i];
    const core::Upright there = uprights.others[j];
    const PointId best = nearest[i].id;
    if (best != Nearest::kNone && line.compare(here, there, here, uprights.others[best]) >= 0) {
      return;
    }
    nearest[i] = {j, line.length(here, there)};
  });
  return nearest;
}

Result<std::vector<Nearest>> nearest_within_of(const Pairing& pairing, const PairOptions& options) {
  if (auto error = pairing.check(options)) return *std::move(error);
  if (options.vertical_m) return nearest_in_cylinder(pairing, options);
  std::vector<Nearest> nearest(pairing.size());
  pairing.for_each_closer(options,
                          [&](PointId i, PointId j) { keep_nearer(pairing, i, j, nearest); });
  return nearest;
}

}  // namespace

Result<std::vector<PointId>> find_at_risk(const PointsView& points, const SearchOptions& options) {
  return at_risk(Pairing(points), options);
}

Result<std::vector<PointId>> find_at_risk_between(const PointsView& points,
                                                  const PointsView& others,
                                                  const SearchOptions& options) {
  return at_risk(Pairing(points, others), options);
}

Result<std::vector<Pair>> find_pairs(const PointsView& points, const PairOptions& options) {
  return pairs_of(Pairing(points), options, true);
}

Result<std::vector<Pair>> find_pairs_between(const PointsView& points, const PointsView& others,
                                             const PairOptions& options) {
  return pairs_of(Pairing(points, others), options, false);
}

Result<IdRows> find_neighbors(const PointsView& points, const PairOptions& options) {
  return neighbors_of(Pairing(points), options);
}

Result<IdRows> find_neighbors_between(const PointsView& points, const PointsView& others,
                                      const PairOptions& options) {
  return neighbors_of(Pairing(points, others), options);
}

Result<std::vector<std::uint32_t>> count_neighbors(const PointsView& points,
                                                   const SearchOptions& options) {
  return counts_of(Pairing(points), options);
}

Result<std::vector<std::uint32_t>> count_neighbors_between(const PointsView& points,
                                                           const PointsView& others,
                                                           const SearchOptions& options) {
  return counts_of(Pairing(points, others), options);
}

// Flood fill over rows of neighbours.
Result<IdRows> find_conflict_groups(const PointsView& points, const SearchOptions& options) {
  PairOptions unlimited = options;
  const Result<IdRows> neighbors = brute_force::find_neighbors(points, unlimited);
  if (!neighbors) return neighbors.error();
  IdRows groups;
  groups.offsets.push_back(0);
  std::vector<bool> seen(points.size());
  for (PointId first = 0; first < points.size(); ++first) {
    if (seen[first] || (*neighbors)[first].empty()) continue;
    const std::size_t begin = groups.ids.size();
    seen[first] = true;
    groups.ids.push_back(first);
    for (std::size_t next = begin; next < groups.ids.size(); ++next) {
      for (const PointId other : (*neighbors)[groups.ids[next]]) {
        if (seen[other]) continue;
        seen[other] = true;
        groups.ids.push_back(other);
      }
    }
    std::sort(groups.ids.begin() + static_cast<std::ptrdiff_t>(begin), groups.ids.end());
    groups.offsets.push_back(groups.ids.size());
  }
  if (groups.ids.empty()) groups.offsets.clear();  // no rows
  return groups;
}

Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points) {
  const Pairing pairing(points);
  if (auto error = pairing.check_positions()) return *std::move(error);
  return closest_of(pairing);  // ascending order: (i, j) comes before (j, i)
}

Result<std::optional<ClosestPair>> find_closest_pair_between(const PointsView& points,
                                                             const PointsView& others) {
  const Pairing pairing(points, others);
  if (auto error = pairing.check_positions()) return *std::move(error);
  return closest_of(pairing);
}

Result<std::vector<Nearest>> find_nearest(const PointsView& points) {
  return nearest_of(Pairing(points));
}

Result<NearestRows> find_k_nearest(const PointsView& points, std::size_t k) {
  const Pairing pairing(points);
  if (auto error = pairing.check_positions()) return *std::move(error);
  NearestRows rows;
  if (points.size() < 2) return rows;
  rows.length = std::min(k, points.size() - 1);
  if (rows.length == 0) return rows;
  std::vector<PointId> others(points.size() - 1);
  for (PointId i = 0; i < pairing.size(); ++i) {
    std::iota(others.begin(), others.begin() + i, PointId{0});
    std::iota(others.begin() + i, others.end(), i + 1);
    // Ids ascend, and the sort is stable: equally near ones stay in their order.
    std::stable_sort(others.begin(), others.end(),
                     [&](PointId a, PointId b) { return pairing.nearer(i, a, i, b); });
    for (std::size_t n = 0; n < rows.length; ++n) {
      rows.entries.push_back({others[n], pairing.distance_m(i, others[n])});
    }
  }
  return rows;
}

Result<std::vector<Nearest>> find_nearest_within(const PointsView& points,
                                                 const SearchOptions& options) {
  return nearest_within_of(Pairing(points), options);
}

Result<std::vector<Nearest>> find_nearest_between(const PointsView& points,
                                                  const PointsView& others) {
  return nearest_of(Pairing(points, others));
}

Result<std::vector<Nearest>> find_nearest_within_between(const PointsView& points,
                                                         const PointsView& others,
                                                         const SearchOptions& options) {
  return nearest_within_of(Pairing(points, others), options);
}

}  // namespace beespace::brute_force
