// Every kernel of this processor, neighbourhood by neighbourhood, against plain double arithmetic
// on the same positions.
#include "cpu/sweep.hpp"

#include "core/sorted_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace beespace::cpu {
namespace {

constexpr unsigned kFractionBits = 10;
constexpr std::int32_t kCell = 1 << kFractionBits;

class Kernels : public testing::TestWithParam<InstructionSet> {
 protected:
  // Rows of points in the order of their cells along x, as in a sorted grid.
  void make_rows(const std::vector<std::uint32_t>& sizes, std::int32_t cells_along_x) {
    rows_.clear();
    x_.clear();
    y_.clear();
    z_.clear();
    for (const std::uint32_t size : sizes) {
      std::vector<std::int32_t> xs(size);
      for (std::int32_t& x : xs) x = number_below(cells_along_x * kCell);
      std::stable_sort(xs.begin(), xs.end(),
                       [](std::int32_t a, std::int32_t b) { return a / kCell < b / kCell; });
      rows_.push_back(
          {static_cast<std::uint32_t>(x_.size()), static_cast<std::uint32_t>(x_.size()) + size});
      x_.insert(x_.end(), xs.begin(), xs.end());
      for (std::uint32_t i = 0; i < size; ++i) {
        y_.push_back(number_below(2 * kCell));
        z_.push_back(number_below(2 * kCell));
      }
    }
    for (std::size_t i = 0; i < core::kPadding; ++i) {
      for (auto* axis : {&x_, &y_, &z_}) axis->push_back(0);
    }
  }

  std::int32_t number_below(std::int32_t limit) {
    return static_cast<std::int32_t>(random_() % static_cast<std::uint32_t>(limit));
  }

  [[nodiscard]] double squared(std::uint32_t i, std::uint32_t j) const {
    const double dx = x_[i] - x_[j];
    const double dy = y_[i] - y_[j];
    const double dz = z_[i] - z_[j];
    return dx * dx + dy * dy + dz * dz;
  }

  // Runs the kernel on row 0 against the others and compares marks and unsure pairs.
  void check(const Neighbourhood& hood, const Limits& limits) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> unsure;
    const Unsure collect{[](void* context, std::uint32_t i, std::uint32_t j) {
                           static_cast<decltype(unsure)*>(context)->insert({i, j});
                         },
                         &unsure};
    const auto size = static_cast<std::uint32_t>(x_.size() - core::kPadding);
    std::vector<std::uint8_t> marks(x_.size(), 0);
    sweep_kernel(GetParam())({x_.data(), y_.data(), z_.data(), kFractionBits}, hood, limits,
                             marks.data(), 0, collect);

    std::vector<bool> near(size, false);
    std::set<std::pair<std::uint32_t, std::uint32_t>> open;
    const auto compare = [&](std::uint32_t i, const Range& range) {
      for (std::uint32_t j = range.begin; j < range.end; ++j) {
        const double distance = squared(i, j);
        if (distance < static_cast<double>(limits.near)) near[i] = near[j] = true;
        const bool above = distance > static_cast<double>(limits.far);
        if (distance >= static_cast<double>(limits.near) && !above) open.insert({i, j});
      }
    };
    for (std::uint32_t i = hood.row.begin; i < hood.row.end; ++i) {
      compare(i, {i + 1, hood.own_end});
      compare(i, hood.together);
      for (unsigned k = 0; k < hood.later_count; ++k) compare(i, hood.later[k]);
    }
    for (std::uint32_t i = 0; i < size; ++i) ASSERT_EQ(marks[i] != 0, near[i]) << i;
    ASSERT_EQ(unsure, open);
  }

  // Squares of distances up to one cell, so that nothing beyond three cells can be within.
  static constexpr Limits kLimits{0.81F * kCell * kCell, 0.998F * kCell* kCell};

  std::mt19937 random_{7};
  std::vector<Range> rows_;
  std::vector<std::int32_t> x_;
  std::vector<std::int32_t> y_;
  std::vector<std::int32_t> z_;
};

TEST_P(Kernels, FollowTheWindowAlongLongRows) {
  for (const std::int32_t cells : {3, 8, 40}) {
    for (const std::uint32_t size : {1U, 15U, 16U, 17U, 33U, 200U}) {
      make_rows({size, size, size + 1, 2, size}, cells);
      Neighbourhood hood{rows_[0], rows_[0].end, {0, 0}, {}, 4};
      for (unsigned k = 0; k < 4; ++k) hood.later[k] = rows_[k + 1];
      SCOPED_TRACE(std::to_string(cells) + " cells, rows of " + std::to_string(size));
      check(hood, kLimits);
    }
  }
}

TEST_P(Kernels, LookAtShortRowsWhole) {
  for (std::uint32_t size = 1; size <= 5; ++size) {
    make_rows({size, size, size, size, size}, 50);
    const Neighbourhood hood{rows_[0], rows_[1].end, {rows_[2].begin, rows_[4].end}, {}, 0};
    SCOPED_TRACE(size);
    check(hood, {1600.0F * kCell * kCell, 1700.0F * kCell * kCell});
  }
}

TEST_P(Kernels, LeaveLaterRowsAloneThatAreNotThere) {
  make_rows({40, 30}, 5);
  Neighbourhood hood{rows_[0], rows_[0].end, {0, 0}, {}, 1};
  hood.later[0] = rows_[1];
  check(hood, kLimits);
  check({rows_[0], rows_[0].end, {0, 0}, {}, 0}, kLimits);
}

std::vector<InstructionSet> available() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : kInstructionSets) {
    if (is_available(set)) sets.push_back(set);
  }
  return sets;
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, Kernels, testing::ValuesIn(available()),
                         [](const auto& test_case) { return name_of(test_case.param); });

}  // namespace
}  // namespace beespace::cpu
