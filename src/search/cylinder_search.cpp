#include "search/cylinder_search.hpp"

#include "core/cylinder.hpp"
#include "core/validate.hpp"
#include "cpu/collect_pairs.hpp"
#include "search/frame.hpp"
#include "search/question_grids.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace beespace::search {

namespace {

// Heights stretched so that the cylinder is as high as it is wide: then a sphere around it holds
// little else. Cut where numbers would leave the coordinate domain: the sphere is larger then, and
// as right.
double stretch_of(const SearchOptions& options) {
  constexpr double kMost = 0x1p+40;
  return std::clamp(options.threshold_m / *options.vertical_m, 1.0 / kMost, kMost);
}

core::Buffer<Point> stretched(const PointsView& points, double stretch, core::Memory& memory) {
  core::Buffer<Point> places(memory, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    const double z = p.z * stretch;
    // What is too small for the domain is nothing beside the radius.
    places[i] = {p.x, p.y, std::abs(z) < kSmallestCoordinate_m ? 0.0 : z};
  }
  return places;
}

}  // namespace

Result<bool> CylinderSearch::visit_pairs(const PairVisitor& visit) const {
  if (auto error = core::check_vertical(options_, points_.size())) return *std::move(error);
  if (auto error = core::check_set(points_, "")) return *std::move(error);
  const bool apart = !options_.heights_m.empty();
  const double stretch = stretch_of(options_);
  const core::Buffer<Point> places = stretched(points_, apart ? 0.0 : stretch, with_.memory);
  const PointsView sphere =
      apart ? points_ : PointsView(std::span<const Point>(places.data(), points_.size()));
  // Rounded up, and wider by far than what the stretching rounds.
  const double radius =
      (1.0 + 0x1p-20) * (apart ? options_.threshold_m
                               : std::hypot(options_.threshold_m, stretch * *options_.vertical_m));
  const Result<Frame> frame = Frame::of(sphere, with_);
  if (!frame) return frame.error();
  const QuestionGrids grids(*frame, {.threshold_m = radius, .inclusive = true}, with_, choices_);
  const core::CylinderTest closer(points_, options_);
  std::vector<Pair> near;
  return cpu::show_pairs(grids.question(), with_, [&](std::span<const Pair> pairs) {
    near.clear();
    for (const Pair& pair : pairs) {
      if (closer(pair.first, pair.second)) near.push_back(pair);
    }
    return near.empty() || visit(near);
  });
}

Status CylinderSearch::find_pairs(std::vector<Pair>& pairs) const {
  pairs.clear();
  const auto all = visit_pairs([&](std::span<const Pair> some) {
    pairs.insert(pairs.end(), some.begin(), some.end());
    return pairs.size() <= options_.max_results;
  });
  if (!all) return all.error();
  if (pairs.size() > options_.max_results) return core::too_many_results(options_.max_results);
  std::sort(pairs.begin(), pairs.end());
  return std::monostate{};
}

Status CylinderSearch::count_neighbors(std::vector<std::uint32_t>& counts) const {
  counts.assign(points_.size(), 0);
  const auto all = visit_pairs([&](std::span<const Pair> pairs) {
    for (const Pair& pair : pairs) {
      ++counts[pair.first];
      ++counts[pair.second];
    }
    return true;
  });
  if (!all) return all.error();
  return std::monostate{};
}

Status CylinderSearch::find_at_risk(std::vector<PointId>& at_risk) const {
  at_risk.clear();
  std::vector<std::uint32_t> counts;
  Status counted = count_neighbors(counts);
  if (!counted) return counted;
  for (PointId id = 0; id < counts.size(); ++id) {
    if (counts[id] > 0) at_risk.push_back(id);
  }
  return std::monostate{};
}

Status CylinderSearch::find_neighbors(IdRows& neighbors) const {
  std::vector<Pair> pairs;
  Status found = find_pairs(pairs);
  if (!found) return found;
  if (2 * pairs.size() > options_.max_results) return core::too_many_results(options_.max_results);
  neighbors.offsets.assign(points_.size() + 1, 0);
  for (const Pair& pair : pairs) {
    ++neighbors.offsets[pair.first + 1];
    ++neighbors.offsets[pair.second + 1];
  }
  std::partial_sum(neighbors.offsets.begin(), neighbors.offsets.end(), neighbors.offsets.begin());
  neighbors.ids.resize(2 * pairs.size());
  std::vector<std::uint64_t> next(neighbors.offsets.begin(), neighbors.offsets.end());
  // Lower neighbours come from pairs that are sorted by them, and before the higher ones.
  for (const Pair& pair : pairs) neighbors.ids[next[pair.second]++] = pair.first;
  for (const Pair& pair : pairs) neighbors.ids[next[pair.first]++] = pair.second;
  return std::monostate{};
}

Status CylinderSearch::find_groups(IdRows& groups) const {
  std::vector<PointId> root_of(points_.size());
  std::iota(root_of.begin(), root_of.end(), PointId{0});
  const auto root = [&](PointId id) {
    while (root_of[id] != id) id = root_of[id] = root_of[root_of[id]];
    return id;
  };
  const auto all = visit_pairs([&](std::span<const Pair> pairs) {
    for (const Pair& pair : pairs) {
      const PointId a = root(pair.first);
      const PointId b = root(pair.second);
      root_of[std::max(a, b)] = std::min(a, b);  // so a root is the lowest of its group
    }
    return true;
  });
  if (!all) return all.error();
  std::vector<std::uint64_t> next(points_.size() + 1, 0);
  for (PointId id = 0; id < root_of.size(); ++id) ++next[root(id)];
  groups.offsets.assign(1, 0);
  for (PointId id = 0; id < root_of.size(); ++id) {
    const std::uint64_t members = next[id];
    next[id] = groups.offsets.back();
    if (members > 1) groups.offsets.push_back(groups.offsets.back() + members);
  }
  groups.ids.resize(groups.offsets.back());
  std::vector<bool> joined(points_.size());
  for (PointId id = 0; id < root_of.size(); ++id) joined[id] = root(id) != id;
  for (PointId id = 0; id < root_of.size(); ++id) {
    if (joined[id]) joined[root(id)] = true;
  }
  for (PointId id = 0; id < root_of.size(); ++id) {
    if (joined[id]) groups.ids[next[root(id)]++] = id;
  }
  return std::monostate{};
}

}  // namespace beespace::search
