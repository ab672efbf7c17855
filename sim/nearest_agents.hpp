// The direction from each agent to its nearest neighbour, for disturbances that push it there.
#pragma once

#include "sim/vector3.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace beespace::sim {

class NearestAgents {
 public:
  // Neighbours farther away do not count.
  explicit NearestAgents(double reach_m) : reach_m_(reach_m) {}

  // Of length 1, or zero where there is none.
  const std::vector<Vector3>& find(const std::vector<Vector3>& places) {
    cells_.clear();
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      const Vector3& p = places[i];
      cells_.push_back({index(p.x), index(p.y), index(p.z), i});
    }
    std::sort(cells_.begin(), cells_.end());
    ways_.assign(places.size(), {});
    for (const Cell& cell : cells_) ways_[cell.place] = way_from(cell, places);
    return ways_;
  }

 private:
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;
    std::uint32_t place = 0;
    friend bool operator<(const Cell& a, const Cell& b) {
      return std::tie(a.x, a.y, a.z, a.place) < std::tie(b.x, b.y, b.z, b.place);
    }
  };

  [[nodiscard]] std::int64_t index(double x) const {
    return static_cast<std::int64_t>(std::floor(x / reach_m_));
  }

  [[nodiscard]] Vector3 way_from(const Cell& cell, const std::vector<Vector3>& places) const {
    Vector3 way;
    double nearest_m = reach_m_;
    for (std::int64_t x = cell.x - 1; x <= cell.x + 1; ++x) {
      for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y) {
        const Cell from{x, y, cell.z - 1, 0};
        const Cell to{x, y, cell.z + 1, std::numeric_limits<std::uint32_t>::max()};
        auto other = std::lower_bound(cells_.begin(), cells_.end(), from);
        for (; other != cells_.end() && !(to < *other); ++other) {
          const Vector3 there = places[other->place] - places[cell.place];
          const double distance_m = length_of(there);
          if (other->place == cell.place || distance_m >= nearest_m) continue;
          nearest_m = distance_m;
          way = distance_m > 0.0 ? there * (1.0 / distance_m) : Vector3{1.0, 0.0, 0.0};
        }
      }
    }
    return way;
  }

  double reach_m_;
  std::vector<Cell> cells_;
  std::vector<Vector3> ways_;
};

}  // namespace beespace::sim
