// The reference for an Index: every point is visited, every distance compared exactly.
#pragma once

#include "exact/exact_distance.hpp"

#include <beespace/index.hpp>

#include <algorithm>
#include <map>
#include <vector>

namespace beespace::test {

class PlainIndex {
 public:
  PlainIndex() = default;
  explicit PlainIndex(const std::vector<Point>& points) {
    for (const Point& point : points) insert(point);
  }

  PointId insert(const Point& point) {
    points_[next_] = point;
    return next_++;
  }
  void move(PointId id, const Point& point) { points_.at(id) = point; }
  void remove(PointId id) { points_.erase(id); }

  [[nodiscard]] const std::map<PointId, Point>& points() const { return points_; }

  [[nodiscard]] std::vector<PointId> find_around(const Point& place, double radius,
                                                 bool inclusive) const {
    std::vector<PointId> found;
    for (const auto& [id, point] : points_) {
      const int sign = core::compare_exactly(point, place, radius);
      if (sign < 0 || (inclusive && sign == 0)) found.push_back(id);
    }
    return found;
  }

  [[nodiscard]] std::vector<Nearest> k_nearest(const Point& place, std::size_t k) const {
    std::vector<PointId> ids;
    for (const auto& entry : points_) ids.push_back(entry.first);
    k = std::min(k, ids.size());
    const auto middle = ids.begin() + static_cast<std::ptrdiff_t>(k);
    std::partial_sort(ids.begin(), middle, ids.end(), [&](PointId a, PointId b) {
      const int sign = core::compare_distances(points_.at(a), place, points_.at(b), place);
      return sign != 0 ? sign < 0 : a < b;
    });
    std::vector<Nearest> nearest;
    for (auto id = ids.begin(); id != middle; ++id) {
      nearest.push_back({*id, distance(points_.at(*id), place)});
    }
    return nearest;
  }

 private:
  std::map<PointId, Point> points_;
  PointId next_ = 0;
};

}  // namespace beespace::test
