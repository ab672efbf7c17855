// Optimised spatial hashing, after Teschner, Heidelberger, Müller, Pomeranets, Gross: Optimized
// spatial hashing for collision detection of deformable objects, 2003: cells of one threshold, the
// cell numbers times three primes, XORed, modulo the size of the table; exact distances decide.
//
// The table is one array of points in the order of their hash, with the start of each bucket (a
// counting sort instead of lists), rebuilt each time instead of stamped.
#include "bench/compare/contender.hpp"
#include "bench/compare/point_queries.hpp"
#include "bench/compare/space_order.hpp"

#include <cmath>
#include <numeric>

namespace beespace::compare {
namespace {

struct Cell {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

class HashTable {
 public:
  HashTable(std::span<const Point> points, double threshold_m)
      : points_(points), cell_side_m_(threshold_m), squared_(threshold_m * threshold_m) {
    const std::size_t buckets = odd_prime_from(2 * points.size() + 1);
    starts_.resize(buckets + 1);
    std::vector<std::uint32_t> bucket_of(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      bucket_of[i] = bucket(cell_of(points[i]));
      ++starts_[bucket_of[i] + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    entries_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      entries_[next[bucket_of[i]]++] = {points[i], static_cast<PointId>(i)};
    }
  }

  [[nodiscard]] bool has_other(PointId self) const {
    return !each_near(self, [self](PointId other) { return other == self; });
  }
  template <class Visit>
  void visit_near(PointId self, Visit&& visit) const {
    each_near(self, [&](PointId other) {
      visit(other);
      return true;
    });
  }
  [[nodiscard]] std::uint32_t count_others(PointId self) const {
    std::uint32_t count = 0;
    visit_near(self, [&](PointId other) { count += other != self ? 1 : 0; });
    return count;
  }
  // A hash of fixed cells cannot answer this question; it is never asked.
  [[nodiscard]] static Nearest nearest_other(PointId /*self*/) { return {}; }

 private:
  struct Entry {
    Point point;
    PointId id = 0;
  };

  static std::size_t odd_prime_from(std::size_t number) {
    const auto is_prime = [](std::size_t candidate) {
      for (std::size_t i = 3; i * i <= candidate; i += 2) {
        if (candidate % i == 0) return false;
      }
      return true;
    };
    number |= 1u;
    while (!is_prime(number)) number += 2;
    return number;
  }

  [[nodiscard]] Cell cell_of(const Point& point) const {
    const auto number = [this](double coordinate) {
      return static_cast<std::int64_t>(std::floor(coordinate / cell_side_m_));
    };
    return {number(point.x), number(point.y), number(point.z)};
  }

  // The primes of the paper.
  [[nodiscard]] std::uint32_t bucket(const Cell& cell) const {
    const std::int64_t hash = (cell.x * 73'856'093) ^ (cell.y * 19'349'663) ^ (cell.z * 83'492'791);
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(hash) % (starts_.size() - 1));
  }

  // Calls visit(id) for each near point, `self` too, until it returns false; whether it never did.
  template <class Visit>
  bool each_near(PointId self, Visit&& visit) const {
    const Point& at = points_[self];
    const Cell centre = cell_of(at);
    // The own cell first: most often a neighbour is there.
    if (!each_near_in(centre, at, visit)) return false;
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        for (std::int64_t z = -1; z <= 1; ++z) {
          if (x == 0 && y == 0 && z == 0) continue;
          if (!each_near_in({centre.x + x, centre.y + y, centre.z + z}, at, visit)) return false;
        }
      }
    }
    return true;
  }

  template <class Visit>
  bool each_near_in(const Cell& cell, const Point& at, Visit&& visit) const {
    const std::uint32_t number = bucket(cell);
    for (std::uint32_t i = starts_[number]; i < starts_[number + 1]; ++i) {
      const Entry& entry = entries_[i];
      const double x = entry.point.x - at.x;
      const double y = entry.point.y - at.y;
      const double z = entry.point.z - at.z;
      // Two of the 27 cells may share a bucket: a near point counts in its own cell only.
      if (x * x + y * y + z * z < squared_ && cell_of(entry.point) == cell && !visit(entry.id)) {
        return false;
      }
    }
    return true;
  }

  std::span<const Point> points_;
  double cell_side_m_;
  double squared_;
  std::vector<std::uint32_t> starts_;
  std::vector<Entry> entries_;
};

class TeschnerHash final : public Contender {
 public:
  [[nodiscard]] Description description() const override {
    return {"optimised spatial hash",
            "Teschner et al. 2003",
            Arithmetic::kFloat64,
            "rebuilt: two buckets a point, counting sort, queried in Morton order, stops "
            "at the first neighbour",
            {Question::kAtRisk, Question::kPairs, Question::kCounts}};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    const HashTable table(points, threshold_m);
    return answer_point_by_point(question, space_order(points), table);
  }
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view) {
  return std::make_unique<TeschnerHash>();
}

}  // namespace beespace::compare
