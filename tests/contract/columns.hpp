// Answers in columns of the caller's, held against the same in vectors.
#pragma once

#include "tests/contract/answer.hpp"

#include <beespace/columns.hpp>
#include <beespace/nearest.hpp>
#include <beespace/points_view.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace beespace::test {

// No answer is this.
inline const Answer kBadColumns = {0, ~std::uint64_t{0}, 0};

// Gives columns that have an entry more than they need, and tells whether these are untouched.
class Columns {
 public:
  [[nodiscard]] PairRoom for_pairs() {
    return [this](std::uint64_t size) {
      open(size, size, size);
      return PairColumns{first_.data(), second_.data(), distances_m_.data()};
    };
  }
  [[nodiscard]] RowRoom for_rows() {
    return [this](std::uint64_t rows, std::uint64_t size) {
      open(rows + 1, size, size);
      return RowColumns{first_.data(), second_.data(), distances_m_.data()};
    };
  }

  [[nodiscard]] Answer pairs(const PointsView& points, const PointsView& others) const {
    if (!is_sound()) return kBadColumns;
    Answer answer;
    for (std::size_t i = 0; i < second().size(); ++i) {
      const Pair pair = {id(first_[i]), id(second_[i])};
      if (!has_distance(i, points[pair.first], others[pair.second])) return kBadColumns;
      answer.push_back(std::uint64_t{pair.first} << 32 | pair.second);
    }
    return answer;
  }

  [[nodiscard]] Answer rows(const PointsView& points, const PointsView& others) const {
    if (!is_sound()) return kBadColumns;
    Answer answer(first_.begin(), first_.end() - 1);
    answer.insert(answer.end(), second().begin(), second().end());
    for (std::size_t row = 0; row + 2 < first_.size(); ++row) {
      for (std::int64_t i = first_[row]; i < first_[row + 1]; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (at >= second().size() || !has_distance(at, points[row], others[id(second_[at])])) {
          return kBadColumns;
        }
      }
    }
    return answer;
  }

 private:
  static constexpr std::int64_t kUntouched = -7;

  void open(std::uint64_t first, std::uint64_t second, std::uint64_t distances) {
    ++opened_;
    first_.assign(first + 1, kUntouched);
    second_.assign(second + 1, kUntouched);
    distances_m_.assign(distances + 1, static_cast<double>(kUntouched));
  }

  [[nodiscard]] bool is_sound() const {
    return opened_ == 1 && first_.back() == kUntouched && second_.back() == kUntouched &&
           distances_m_.back() == static_cast<double>(kUntouched) &&
           std::count(first_.begin(), first_.end(), kUntouched) == 1 &&
           std::count(second_.begin(), second_.end(), kUntouched) == 1;
  }
  [[nodiscard]] std::span<const std::int64_t> second() const {
    return std::span(second_).first(second_.size() - 1);
  }
  [[nodiscard]] bool has_distance(std::size_t i, const Point& a, const Point& b) const {
    return std::bit_cast<std::uint64_t>(distances_m_[i]) ==
           std::bit_cast<std::uint64_t>(distance(a, b));
  }
  static PointId id(std::int64_t id) { return static_cast<PointId>(id); }

  int opened_ = 0;
  std::vector<std::int64_t> first_;
  std::vector<std::int64_t> second_;
  std::vector<double> distances_m_;
};

// An answer that both forms agree on.
inline Answer agreed(const Answer& in_vectors, const Answer& in_columns) {
  return in_vectors == in_columns ? in_vectors : kBadColumns;
}

}  // namespace beespace::test
