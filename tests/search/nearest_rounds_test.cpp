// Nearest points are found in rounds of growing radius, the later ones in the grid of the first
// where that is possible. Swarms with gaps of all widths, in which most points need later rounds:
// equal to brute force for any folding and any width of rows.
#include "search/nearest_search.hpp"
#include "search/search_domain.hpp"

#include "tests/support/own_resources.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/search_scenes.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/nearest.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace {
namespace {

// A clump, which makes the first radius small, and a thin swarm along it whose coordinates go up in
// steps, some of them much wider than others.
std::vector<Point> clump_and_steps(test::SceneMaker& make, std::size_t clump, std::size_t size) {
  std::vector<Point> points = make.box(clump, {0, 0, 0}, {4, 1, 1});
  const double step = std::exp2(make.between(-2.0, 1.0));
  const double across = make.between(0.0, 6.0);
  double x = 2.0;
  for (std::size_t i = 0; i < size; ++i) {
    x += step * (make.below(3) == 0 ? make.between(1.0, 6.0) : make.between(0.0, 0.5));
    points.push_back({x, make.between(0.0, across), make.between(0.0, 0.2 * across)});
  }
  return points;
}

struct Forced {
  std::string name;
  search::TuningOverrides tuning;
};

std::vector<Forced> forced_choices() {
  std::vector<Forced> all{{"chosen", {}}};
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    for (const unsigned row_shift : {1U, 2U, 3U, 5U}) {
      for (const std::uint64_t fold_beyond : {std::uint64_t{1}, core::Lattice::kFoldBeyondCells}) {
        Forced forced{std::string(cpu::name_of(set)) + ", row shift " + std::to_string(row_shift) +
                          (fold_beyond == 1 ? ", folded" : ""),
                      {}};
        forced.tuning.nearest = search::TuningOverrides::Nearest::kGrids;
        forced.tuning.instruction_set = set;
        forced.tuning.row_shift = row_shift;
        forced.tuning.fold_beyond_cells = fold_beyond;
        all.push_back(forced);
      }
    }
  }
  return all;
}

void expect_same(const std::vector<Nearest>& found, const std::vector<Nearest>& truly) {
  ASSERT_EQ(found.size(), truly.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].id, truly[i].id) << i;
    ASSERT_EQ(found[i].distance_m, truly[i].distance_m) << i;
  }
}

void expect_the_nearest(const std::vector<Point>& points, const PairOptions& within) {
  const std::vector<Nearest> truly = *brute_force::find_nearest(points);
  const std::vector<Nearest> truly_within =
      *brute_force::find_nearest_within(points, within.without_limit());
  unsigned workers = 0;
  for (const Forced& forced : forced_choices()) {
    SCOPED_TRACE(forced.name);
    test::OwnResources own(1 + ++workers % 3);
    const search::SearchDomain domain = *search::SearchDomain::of(points, own.with);
    std::vector<Nearest> nearest;
    search::find_nearest(domain, std::nullopt, own.with, forced.tuning, nearest);
    expect_same(nearest, truly);
    search::find_nearest(domain, within, own.with, forced.tuning, nearest);
    expect_same(nearest, truly_within);
  }
}

TEST(NearestRounds, FindTheNearestAcrossGapsOfAllWidths) {
  for (int seed = 0; seed < test::rounds(150) && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE(seed);
    test::SceneMaker make(static_cast<std::uint32_t>(seed));
    const std::size_t size = 60 + 5 * (static_cast<std::size_t>(seed) % 40);
    const std::vector<Point> points = clump_and_steps(make, size, size);
    expect_the_nearest(points, {std::exp2(make.between(-3.0, 3.0)), false});
  }
}

// So few are left that only the points around them are visited.
TEST(NearestRounds, FindTheNearestOfAFewInOpenCountry) {
  for (int seed = 0; seed < test::rounds(30) && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE(seed);
    test::SceneMaker make(static_cast<std::uint32_t>(seed));
    const std::vector<Point> points =
        clump_and_steps(make, 1800, 20 + static_cast<std::size_t>(seed));
    expect_the_nearest(points, {std::exp2(make.between(-3.0, 3.0)), false});
  }
}

}  // namespace
}  // namespace beespace
