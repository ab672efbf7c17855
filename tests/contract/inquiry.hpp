// All inquiries of the contract: each query, on each scene, at each radius.
#pragma once

#include "tests/support/scene_maker.hpp"
#include "tests/support/two_set_scenes.hpp"

#include <beespace/points_view.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace beespace::test {

enum class Question : std::uint8_t {
  kAtRisk,
  kPairs,
  kVisitedPairs,
  kNeighbors,
  kCounts,
  kGroups,
  kNearest,
  kNearestWithin,
  kClosestPair,
  kAtRiskBetween,
  kPairsBetween,
  kNeighborsBetween,
  kCountsBetween,
  kNearestBetween,
  kNearestWithinBetween,
  kClosestPairBetween,
};

const char* name_of(Question question);

// The sets that queries are about: a scene, or two sets made of one.
struct Subject {
  std::string name;
  std::vector<Point> points;
  std::vector<Point> others;
  bool two_sets = false;
  std::vector<double> thresholds;  // the scene's own, and real distances, with an ulp either side
  // Apart from the positions; mostly none.
  std::vector<double> heights = {};
  std::vector<double> other_heights = {};

  [[nodiscard]] PointsView view() const { return PointsView(points).with_heights(heights); }
  [[nodiscard]] PointsView other_view() const {
    return PointsView(others).with_heights(other_heights);
  }
};

// In the order of the scenes; made once.
const std::vector<Subject>& subjects();

struct Inquiry {
  const Subject* subject = nullptr;
  Question question = Question::kAtRisk;
  PairOptions options = {};
};

// All of them, those about the same subject and with the same options next to each other.
const std::vector<Inquiry>& inquiries();

// "Mixture: pairs at 0x1.8p+1 m, inclusive".
std::string described(const Inquiry& inquiry);

}  // namespace beespace::test
