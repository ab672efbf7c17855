// Layouts that would make a search compare all with all: sets far apart, clumps no wider than what
// floats or doubles resolve, shells of a radius next to the threshold, densities over many decades.
// Trees of boxes answer them; all answers are those of brute force, at the threshold and one ulp
// either side.
#include "tests/contract/agreement.hpp"
#include "tests/contract/variants.hpp"
#include "tests/support/lattice_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace beespace::test {
namespace {

constexpr std::size_t kSize = 130;  // of each set

std::vector<Point> shell(SceneMaker& make, double radius) {
  std::vector<Point> points;
  while (points.size() < kSize) {
    const Point p = make.box(1, {-1, -1, -1}, {1, 1, 1})[0];
    const double length = distance(p, {0, 0, 0});
    if (length < 0.1 || length > 1.0) continue;
    const double factor = radius / length;
    points.push_back({p.x * factor, p.y * factor, p.z * factor});
  }
  return points;
}

std::vector<Point> clump(SceneMaker& make, double side, const Point& at = {0, 0, 0}) {
  return moved(make.box(kSize, {0, 0, 0}, {side, side, side}), at);
}

std::vector<Point> radii_of_decades(SceneMaker& make, bool powers_of_two) {
  std::vector<Point> points = shell(make, 1.0);
  for (Point& p : points) {
    const double power = make.between(-30, 30);
    const double radius = std::exp2(powers_of_two ? std::floor(power) : power);
    p = {p.x * radius, p.y * radius, p.z * radius};
  }
  return points;
}

std::vector<Point> coordinates_powers_of_two(SceneMaker& make) {
  const auto power = [&] { return std::exp2(std::floor(make.between(-100, 100))); };
  std::vector<Point> points(kSize);
  for (Point& p : points) p = {power(), -power(), power()};
  return points;
}

std::vector<Point> line(double x) {
  std::vector<Point> points(kSize);
  for (std::size_t i = 0; i < kSize; ++i) points[i] = {x, 1e-9 * static_cast<double>(i), 0.0};
  return points;
}

std::vector<Subject> subjects_of_two_sets() {
  SceneMaker make(53);
  std::vector<Subject> all;
  const auto add = [&](const char* name, std::vector<Point> points, std::vector<Point> others,
                       double threshold) {
    all.push_back({name, others, points, true, {threshold}});
    all.push_back(
        {std::string(name) + ", turned", std::move(points), std::move(others), true, {threshold}});
  };
  const auto box = [&](double x) { return clump(make, 100.0, {x, 0, 0}); };
  add("TwoBoxes", box(0), box(300), 250.0);
  add("TwoBoxesFarApart", box(0), box(1e4), 1e4);
  add("TwoBoxesAMillionKilometresApart", box(0), box(1e9), 1e9);
  add("AllAtOnePlace", box(0), std::vector<Point>(kSize, Point{50, 50, 50}), 40.0);
  add("TwoPlacesAtTheThreshold", std::vector<Point>(kSize, Point{0, 0, 0}),
      std::vector<Point>(kSize, Point{3, 4, 0}), 5.0);
  for (const double side : {1e-3, 1e-9, 1e-15}) {
    add("BoxAndClump", box(0), clump(make, side, {50, 50, 50}), 40.0);
    add("TwoClumpsAThresholdApart", clump(make, side), clump(make, side, {1, 0, 0}), 1.0);
    add("ShellAndClump", shell(make, 1.0), clump(make, side), 1.0);
  }
  add("ShellJustBeyond", shell(make, 1.0 + 1e-9), clump(make, 1e-12), 1.0);
  add("ShellAndItsCentre", shell(make, 1.0), {{0, 0, 0}}, 1.0);
  add("LinesAThresholdApart", line(0), line(1), 1.0);
  add("RadiiOfDecades", radii_of_decades(make, false), radii_of_decades(make, true), 1.0);
  add("LatticeAndItself", integer_lattice(7, 1.0, {0, 0, 0}), integer_lattice(7, 1.0, {1, 0, 0}),
      1.0);
  return all;
}

std::vector<Subject> subjects_of_one_set() {
  std::vector<Subject> all;
  for (const Subject& two : subjects_of_two_sets()) {
    if (two.name.ends_with(", turned")) continue;
    std::vector<Point> points = two.points;
    append(points, two.others);
    all.push_back({two.name, std::move(points), {}, false, two.thresholds});
  }
  SceneMaker make(59);
  all.push_back({"PowersOfTwo", coordinates_powers_of_two(make), {}, false, {1.0}});
  return all;
}

std::vector<Inquiry> inquiries_about(const std::vector<Subject>& subjects) {
  std::vector<Inquiry> all;
  for (const Subject& subject : subjects) {
    const auto questions =
        subject.two_sets ? std::vector{Question::kAtRiskBetween, Question::kCountsBetween,
                                       Question::kNearestBetween, Question::kNearestWithinBetween,
                                       Question::kClosestPairBetween}
                         : std::vector{Question::kAtRisk, Question::kCounts, Question::kGroups,
                                       Question::kNearest, Question::kNearestWithin};
    const double threshold = subject.thresholds[0];
    for (const Question question : questions) {
      for (const double at :
           {std::nextafter(threshold, 0.0), threshold, std::nextafter(threshold, 1e300)}) {
        for (const bool inclusive : {false, true})
          all.push_back({&subject, question, {at, inclusive}});
      }
    }
  }
  return all;
}

void expect_answers_of_brute_force(const std::vector<Subject>& subjects) {
  std::vector<Variant> variants = forced_trees();
  for (Variant& variant : forced_shells()) variants.push_back(std::move(variant));
  for (Variant& variant : forced_crowds()) variants.push_back(std::move(variant));
  variants.push_back(engine_with_threads(1));
  variants.push_back(engine_with_threads(3));
  const Variant reference = brute_force_reference();
  for (const Inquiry& inquiry : inquiries_about(subjects)) {
    const Answer expected = reference.ask(inquiry);
    for (const Variant& variant : variants) {
      if (!asks(variant, inquiry.question)) continue;
      ASSERT_EQ(variant.ask(inquiry), expected) << variant.name << ": " << described(inquiry);
    }
  }
}

TEST(HostileSwarms, HaveTheAnswersOfBruteForceInOneSet) {
  expect_answers_of_brute_force(subjects_of_one_set());
}

TEST(HostileSwarms, HaveTheAnswersOfBruteForceBetweenTwo) {
  expect_answers_of_brute_force(subjects_of_two_sets());
}

}  // namespace
}  // namespace beespace::test
