// The paper's own method, rebuilt from its description: a hash table whose keys are texts.
//
// The key is the three rounded cell numbers joined by blanks; each key has a linked list of the
// bees of its cell. Cells have the diagonal of one threshold (side: threshold / sqrt 3), so two
// bees of a cell are too close to each other: all of them are taken. A bee alone in its cell looks
// at the 26 cells around it and is taken when another bee there is within the threshold on each
// axis. So the answer is approximate: a bee near a corner of that box is taken though it is farther
// away, and one two cells away is missed.
//
// Kinder than the published program in one thing: looking up a cell that is not there does not
// create it.
#pragma once

#include <beespace/point.hpp>

#include <cmath>
#include <list>
#include <string>
#include <unordered_map>
#include <vector>

namespace beespace::compare {

class TextKeyHash {
 public:
  explicit TextKeyHash(double threshold_m)
      : threshold_m_(threshold_m), cell_side_m_(threshold_m / std::sqrt(3.0)) {}

  void insert(const Point& point, PointId id) {
    cells_[key(number(point.x), number(point.y), number(point.z))].push_back({point, id});
  }

  struct Bee {
    Point point;
    PointId id = 0;
  };
  using Bees = std::list<Bee>;

  // The cells whose bees are taken as a whole, as the program does it: no bee is named singly.
  [[nodiscard]] std::vector<const Bees*> find() const {
    std::vector<const Bees*> taken;
    for (const auto& [text, bees] : cells_) {
      if (bees.size() > 1 || has_company(bees.front())) taken.push_back(&bees);
    }
    return taken;
  }

  // The ids of these bees, in the order of the table.
  static std::vector<PointId> ids(const std::vector<const Bees*>& taken) {
    std::vector<PointId> ids;
    for (const Bees* bees : taken) {
      for (const Bee& bee : *bees) ids.push_back(bee.id);
    }
    return ids;
  }

 private:
  [[nodiscard]] long long number(double coordinate) const {
    return std::llround(coordinate / cell_side_m_);
  }

  static std::string key(long long x, long long y, long long z) {
    return std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z);
  }

  [[nodiscard]] bool has_company(const Bee& bee) const {
    for (long long x = -1; x <= 1; ++x) {
      for (long long y = -1; y <= 1; ++y) {
        for (long long z = -1; z <= 1; ++z) {
          if (x == 0 && y == 0 && z == 0) continue;
          const auto cell = cells_.find(
              key(number(bee.point.x) + x, number(bee.point.y) + y, number(bee.point.z) + z));
          if (cell != cells_.end() && anyone_in_box(bee.point, cell->second)) return true;
        }
      }
    }
    return false;
  }

  [[nodiscard]] bool anyone_in_box(const Point& centre, const Bees& bees) const {
    for (const Bee& bee : bees) {
      if (std::fabs(bee.point.x - centre.x) < threshold_m_ &&
          std::fabs(bee.point.y - centre.y) < threshold_m_ &&
          std::fabs(bee.point.z - centre.z) < threshold_m_) {
        return true;
      }
    }
    return false;
  }

  double threshold_m_;
  double cell_side_m_;
  std::unordered_map<std::string, Bees> cells_;
};

}  // namespace beespace::compare
