// Swarms too large for brute force, but large enough that threads share the work, that blocks and
// buffers fill up, and that each way to search is chosen from the data. The variants must agree
// with each other, and the plain one with brute force about some of the points.
#include "tests/contract/variants.hpp"
#include "tests/support/crowd_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

std::vector<Point> large_clusters(SceneMaker& make) {
  std::vector<Point> points;
  for (const Point& centre : make.box(40, {0, 0, 0}, {1e5, 1e5, 1e5})) {
    append(points, moved(make.box(250, {-200, -200, -200}, {200, 200, 200}), centre));
  }
  make.shuffle(points);
  return points;
}

std::vector<Point> large_crowd_and_outlier(SceneMaker& make) {
  std::vector<Point> points = make.box(2000, {0, 0, 0}, {20, 20, 20});
  append(points, make.box(6000, {0, 0, 0}, {3000, 3000, 3000}));
  points.push_back({1e9, 1e9, 1e9});
  return points;
}

// And two sets made of each.
std::vector<Subject> with_two_sets(std::vector<Subject> all) {
  for (std::size_t i = all.size(); i > 0; --i) {
    TwoSets sets = split(all[i - 1].points, Split::kEvenAndOdd);
    all.push_back({all[i - 1].name + ", " + name_of(Split::kEvenAndOdd), std::move(sets.points),
                   std::move(sets.others), true, all[i - 1].thresholds});
  }
  return all;
}

std::vector<Subject> large_subjects() {
  SceneMaker make(31);
  std::vector<Subject> all;
  const auto add = [&](const char* name, std::vector<Point> points, double threshold) {
    all.push_back({name, std::move(points), {}, false, {threshold}});
  };
  add("LargeSparse", make.box(12'000, {-2e4, -2e4, 0}, {2e4, 2e4, 9000}), 200.0);
  add("LargeDense", make.box(6000, {0, 0, 0}, {500, 400, 130}), 60.0);
  add("LargePlane", make.box(12'000, {0, 0, 7}, {1900, 1900, 7}), 20.0);
  add("LargeLattice", integer_lattice(20, 1.0, {1e6, 0, -1e6}), 1.0);
  add("LargeTurnedLattice", turned(integer_lattice(20, 1.0, {0, 0, 0}), 2, 3, 4, 5), 1.0);
  add("LargeClusters", large_clusters(make), 20.0);
  add("LargeCrowdAndOutlier", large_crowd_and_outlier(make), 5.0);
  return with_two_sets(std::move(all));
}

// More points than eight threads need to be worth starting.
std::vector<Subject> subjects_for_threads() {
  SceneMaker make(37);
  std::vector<Point> points = make.ragged_box(60'000, {0, 0, 0}, {5200, 5200, 5200});
  append(points, make.box(6000, {100, 100, 100}, {500, 500, 500}));
  make.shuffle(points);
  return with_two_sets({{"LargeUniformAndClump", std::move(points), {}, false, {100.0}}});
}

std::vector<Inquiry> large_inquiries(const std::vector<Subject>& subjects) {
  std::vector<Inquiry> all;
  for (const Subject& subject : subjects) {
    const auto first = subject.two_sets ? Question::kAtRiskBetween : Question::kAtRisk;
    const auto last = subject.two_sets ? Question::kClosestPairBetween : Question::kClosestPair;
    for (auto question = first; question <= last;
         question = static_cast<Question>(static_cast<int>(question) + 1)) {
      all.push_back({&subject, question, {subject.thresholds[0]}});
    }
  }
  return all;
}

void expect_agreement(const std::vector<Subject>& subjects, const std::vector<Variant>& variants) {
  std::vector<Inquiry> inquiries = large_inquiries(subjects);
  // Sanitizers take a minute for each second: with them each question of another swarm.
  std::size_t number = 0;
  if (kSanitized) std::erase_if(inquiries, [&](const Inquiry&) { return number++ % 3 != 0; });
  const Variant plain = public_functions(1);
  std::vector<std::uint64_t> expected;
  for (const Inquiry& inquiry : inquiries) expected.push_back(digest(plain.ask(inquiry)));
  for (const Variant& variant : variants) {
    for (std::size_t i = 0; i < inquiries.size(); ++i) {
      if (!asks(variant, inquiries[i].question)) continue;
      EXPECT_EQ(digest(variant.ask(inquiries[i])), expected[i])
          << variant.name << ": " << described(inquiries[i]);
    }
  }
}

TEST(LargeSwarms, EveryNumberOfThreadsGivesTheSameAnswer) {
  expect_agreement(subjects_for_threads(), variants_with_threads());
}

TEST(LargeSwarms, EveryKernelGivesTheSameAnswer) {
  expect_agreement(large_subjects(), forced_kernels());
}

TEST(LargeSwarms, CrowdsTakenAsAWholeGiveTheSameAnswer) {
  expect_agreement(large_subjects(), forced_crowds());
  expect_agreement(subjects_for_threads(), forced_crowds());
}

TEST(LargeSwarms, EveryWayToFindPointsAtRiskGivesTheSameAnswer) {
  expect_agreement(large_subjects(), forced_methods());
}

TEST(LargeSwarms, TreesGiveTheSameAnswer) {
  expect_agreement(large_subjects(), forced_trees());
  expect_agreement(subjects_for_threads(), forced_trees());
}

// Brute force looks from every 500th point only, at all others.
TEST(LargeSwarms, BruteForceAgreesAboutSomeOfThePoints) {
  std::vector<Subject> subjects = large_subjects();
  for (Subject& subject : subjects_for_threads()) subjects.push_back(std::move(subject));
  for (const Subject& subject : subjects) {
    SCOPED_TRACE(subject.name);
    const std::vector<Point>& others = subject.two_sets ? subject.others : subject.points;
    const SearchOptions options{subject.thresholds[0], true};
    const IdRows rows = subject.two_sets ? *find_neighbors_between(subject.points, others, options)
                                         : *find_neighbors(subject.points, options);
    const std::vector<Nearest> nearest = subject.two_sets
                                             ? *find_nearest_between(subject.points, others)
                                             : *find_nearest(subject.points);
    for (PointId i = 0; i < subject.points.size(); i += 500) {
      const std::vector<Point> one = {subject.points[i]};
      std::vector<PointId> expected =
          brute_force::find_neighbors_between(one, others, options).value().ids;
      if (!subject.two_sets) std::erase(expected, i);
      ASSERT_TRUE(std::equal(rows[i].begin(), rows[i].end(), expected.begin(), expected.end()))
          << i;
      std::vector<Point> without = others;
      if (!subject.two_sets) without[i] = {kLargestCoordinate_m, 0, 0};
      ASSERT_EQ(nearest[i], (*brute_force::find_nearest_between(one, without))[0]) << i;
    }
  }
}

}  // namespace
}  // namespace beespace::test
