// The nearest points seen so far around a place, at most k: the exact nearest, whatever the order
// in which they are seen; of equally near ones those with the lowest ids.
#pragma once

#include <beespace/nearest.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <memory_resource>
#include <vector>

namespace beespace::core {

// Whether a point is surely nearer than another one, by their squared_distances (each right to
// 5 u + O(u^2), u = 2^-53): those that differ by more than 11 u are in the order of the distances.
inline bool is_surely_nearer(double squared, double other_squared) {
  return squared * (1.0 + 0x1p-49) < other_squared;
}

class NearestList {
 public:
  NearestList() = default;
  explicit NearestList(std::pmr::memory_resource* memory) : found_(memory) {}

  // Room for so many, so that looking for them allocates nothing.
  void reserve(std::size_t count) { found_.reserve(count); }

  // Looks for the `count` nearest to `place`, at least one. Points farther away than
  // `reach_within_m` may be left out: give a distance within which there surely are as many, or
  // infinity.
  void start(const Point& place, std::size_t count, double reach_within_m);

  // Takes a candidate, at `squared` as core::squared_distance says. The point must stay where it
  // is until the list is written.
  void offer(const Point& point, PointId id, double squared);

  // Whether a point there, with an id of at least this one, would still be taken.
  [[nodiscard]] bool would_take(const Point& point, PointId id) const;

  // Writes what was found, the nearest first, and returns how many. The list is empty after that.
  std::size_t write(Nearest* nearest);

  // No point farther away can be taken any more.
  [[nodiscard]] double reach_m() const;

  // For the walks, which call no inline functions: no point whose distance, exact or rounded, has a
  // larger square can be taken any more.
  double largest_squared = 0.0;
  std::size_t most = 0;
  bool is_full = false;    // whether as many were found
  std::size_t leaves = 0;  // how many leaves walks have looked at, from the first list on

 private:
  struct Candidate {
    double squared;
    const Point* point;
    PointId id;
  };

  // Whether a is nearer than b, by real numbers, or as near with a lower id.
  [[nodiscard]] bool is_before(const Candidate& a, const Candidate& b) const;
  [[nodiscard]] bool is_sorted() const { return most <= kMostSorted; }
  [[nodiscard]] const Candidate& last() const {
    return is_sorted() ? found_.back() : found_.front();
  }
  void insert(const Candidate& candidate);
  void push(const Candidate& candidate);
  void limit();

  // Up to this many are kept in order; more are a heap, the last in front, once the list is full.
  static constexpr std::size_t kMostSorted = 64;

  Point place_;
  std::pmr::vector<Candidate> found_;
};

}  // namespace beespace::core
