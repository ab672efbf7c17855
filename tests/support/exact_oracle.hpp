// The answers of every search, from the definition and in integers of any size: an oracle that
// shares no code with the library.
//
// Every double is an integer times a power of two. With one power of two for a whole scene,
// coordinates, differences, squares and their sums are integers, and nothing is ever rounded.
#pragma once

#include <beespace/conflict_groups.hpp>
#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/search_options.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::test {

// Up to 256 bits, which most scenes need, without memory of its own.
using ExactInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<256, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>;

// value = mantissa * 2^exponent, with an odd mantissa or none.
struct Binary {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

inline Binary binary(double value) {
  Binary result;
  result.mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &result.exponent), 53));
  result.exponent -= 53;
  if (result.mantissa == 0) return {};
  while (result.mantissa % 2 == 0) {
    result.mantissa /= 2;
    ++result.exponent;
  }
  return result;
}

// Of all coordinates; nothing but zeros is a multiple of anything.
inline int lowest_exponent(const std::vector<Point>& points) {
  constexpr int kNone = std::numeric_limits<int>::max();
  int lowest = kNone;
  for (const Point& p : points) {
    for (const double value : {p.x, p.y, p.z}) {
      if (value != 0.0) lowest = std::min(lowest, binary(value).exponent);
    }
  }
  return lowest == kNone ? 0 : lowest;
}

// value * 2^-exponent; the exponent must be low enough to make that an integer.
inline ExactInteger scaled(double value, int exponent) {
  const Binary parts = binary(value);
  if (parts.mantissa == 0) return 0;
  return ExactInteger(parts.mantissa) << (parts.exponent - exponent);
}

// All squared distances, between the points of one set or from each of one to each of another.
class ExactDistances {
 public:
  explicit ExactDistances(const std::vector<Point>& points)
      : alone_(true), rows_(points.size()), columns_(points.size()) {
    exponent_ = lowest_exponent(points);
    const auto integers = scaled_points(points);
    squared_.reserve(rows_ * (rows_ + 1) / 2);
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t j = 0; j <= i; ++j) squared_.push_back(square(integers[i], integers[j]));
    }
  }

  ExactDistances(const std::vector<Point>& points, const std::vector<Point>& others)
      : alone_(false), rows_(points.size()), columns_(others.size()) {
    exponent_ = std::min(lowest_exponent(points), lowest_exponent(others));
    const auto ours = scaled_points(points);
    const auto theirs = scaled_points(others);
    squared_.reserve(rows_ * columns_);
    for (const auto& p : ours) {
      for (const auto& q : theirs) squared_.push_back(square(p, q));
    }
  }

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] bool alone() const { return alone_; }
  [[nodiscard]] bool is_pair(std::size_t i, std::size_t j) const { return !alone_ || i != j; }

  // In units of 4^exponent.
  [[nodiscard]] const ExactInteger& squared(std::size_t i, std::size_t j) const {
    if (!alone_) return squared_[i * columns_ + j];
    const std::size_t low = std::min(i, j);
    const std::size_t high = std::max(i, j);
    return squared_[high * (high + 1) / 2 + low];
  }

  // The largest squared distance that is too close, in the same units; below zero if none is.
  [[nodiscard]] ExactInteger largest_too_close(const SearchOptions& options) const {
    const Binary parts = binary(options.threshold_m);
    const ExactInteger square = ExactInteger(parts.mantissa) * parts.mantissa;
    const int shift = 2 * (parts.exponent - exponent_);
    if (shift >= 0) return (square << shift) - (options.inclusive ? 0 : 1);
    const ExactInteger whole = square >> -shift;
    const bool more = (whole << -shift) != square;
    return options.inclusive || more ? whole : ExactInteger(whole - 1);
  }

 private:
  using IntegerPoint = std::array<ExactInteger, 3>;

  [[nodiscard]] std::vector<IntegerPoint> scaled_points(const std::vector<Point>& points) const {
    std::vector<IntegerPoint> result;
    for (const Point& p : points) {
      result.push_back({scaled(p.x, exponent_), scaled(p.y, exponent_), scaled(p.z, exponent_)});
    }
    return result;
  }

  static ExactInteger square(const IntegerPoint& p, const IntegerPoint& q) {
    ExactInteger sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ExactInteger difference = p[axis] - q[axis];
      sum += difference * difference;
    }
    return sum;
  }

  bool alone_;
  std::size_t rows_;
  std::size_t columns_;
  int exponent_ = 0;
  std::vector<ExactInteger> squared_;
};

// The points that are too close to each: the definition itself. All else about a threshold follows.
class ExactNeighbors {
 public:
  ExactNeighbors(const ExactDistances& distances, const SearchOptions& options)
      : alone_(distances.alone()), rows_(distances.rows()) {
    const ExactInteger largest = distances.largest_too_close(options);
    for (std::size_t i = 0; i < distances.rows(); ++i) {
      const std::size_t end = alone_ ? i : distances.columns();  // each pair of one set once
      for (std::size_t j = 0; j < end; ++j) {
        if (distances.squared(i, j) > largest) continue;
        rows_[i].push_back(static_cast<PointId>(j));
        if (alone_) rows_[j].push_back(static_cast<PointId>(i));
      }
    }
  }

  [[nodiscard]] const std::vector<std::vector<PointId>>& rows() const { return rows_; }

  [[nodiscard]] std::vector<PointId> at_risk() const {
    std::vector<PointId> ids;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!rows_[i].empty()) ids.push_back(static_cast<PointId>(i));
    }
    return ids;
  }

  [[nodiscard]] std::vector<Pair> pairs() const {
    std::vector<Pair> all;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (const PointId j : rows_[i]) {
        if (!alone_ || i < j) all.push_back({static_cast<PointId>(i), j});
      }
    }
    return all;
  }

  [[nodiscard]] std::vector<std::uint32_t> counts() const {
    std::vector<std::uint32_t> lengths;
    for (const auto& row : rows_) lengths.push_back(static_cast<std::uint32_t>(row.size()));
    return lengths;
  }

  // Sets are joined pair by pair; the lowest member stands for its set.
  [[nodiscard]] std::vector<std::vector<PointId>> groups() const {
    std::vector<PointId> parent(rows_.size());
    std::iota(parent.begin(), parent.end(), PointId{0});
    const auto lowest = [&](PointId id) {
      while (parent[id] != id) id = parent[id] = parent[parent[id]];
      return id;
    };
    for (const Pair& pair : pairs()) {
      const PointId a = lowest(pair.first);
      const PointId b = lowest(pair.second);
      parent[std::max(a, b)] = std::min(a, b);
    }
    std::vector<std::vector<PointId>> by_lowest(rows_.size());
    for (const PointId id : at_risk()) by_lowest[lowest(id)].push_back(id);
    std::erase_if(by_lowest, [](const auto& group) { return group.empty(); });
    return by_lowest;
  }

 private:
  bool alone_;
  std::vector<std::vector<PointId>> rows_;
};

// The nearest of `candidates(i)` for every row i, ties to the lowest id.
template <class Candidates>
std::vector<std::optional<PointId>> exact_nearest(const ExactDistances& distances,
                                                  Candidates&& candidates) {
  std::vector<std::optional<PointId>> nearest(distances.rows());
  for (std::size_t i = 0; i < distances.rows(); ++i) {
    for (const PointId j : candidates(i)) {
      std::optional<PointId>& best = nearest[i];
      if (!best || distances.squared(i, j) < distances.squared(i, *best)) best = j;
    }
  }
  return nearest;
}

inline std::vector<std::optional<PointId>> exact_nearest(const ExactDistances& distances) {
  return exact_nearest(distances, [&](std::size_t i) {
    std::vector<PointId> all;
    for (std::size_t j = 0; j < distances.columns(); ++j) {
      if (distances.is_pair(i, j)) all.push_back(static_cast<PointId>(j));
    }
    return all;
  });
}

// Ties to the lowest first, then the lowest second.
inline std::optional<Pair> exact_closest_pair(const ExactDistances& distances) {
  std::optional<Pair> closest;
  for (std::size_t i = 0; i < distances.rows(); ++i) {
    for (std::size_t j = distances.alone() ? i + 1 : 0; j < distances.columns(); ++j) {
      if (closest &&
          distances.squared(i, j) >= distances.squared(closest->first, closest->second)) {
        continue;
      }
      closest = Pair{static_cast<PointId>(i), static_cast<PointId>(j)};
    }
  }
  return closest;
}

// The double that is nearest to the real distance between two points.
inline double rounded_distance(const Point& p, const Point& q) {
  const ExactDistances distances({p}, {q});
  const ExactInteger& squared = distances.squared(0, 0);
  if (squared == 0) return 0.0;
  const int exponent = std::min(lowest_exponent({p}), lowest_exponent({q}));
  double distance =
      std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
  // Whether the real distance is beyond the middle between a and b.
  const auto beyond_middle = [&](double a, double b) {
    const int unit = std::min({binary(a).exponent, binary(b).exponent, exponent});
    const ExactInteger doubled = scaled(a, unit) + scaled(b, unit);
    return (squared << (2 * (exponent - unit) + 2)) > doubled * doubled;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  while (beyond_middle(distance, std::nextafter(distance, infinity))) {
    distance = std::nextafter(distance, infinity);
  }
  while (!beyond_middle(std::nextafter(distance, 0.0), distance)) {
    distance = std::nextafter(distance, 0.0);
  }
  return distance;
}

}  // namespace beespace::test
