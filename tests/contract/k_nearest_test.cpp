// The k nearest other points of each point: every kernel, crew and number of threads against brute
// force, and brute force against integers of any size.
#include "tests/contract/answer.hpp"
#include "tests/contract/backward_crew.hpp"
#include "tests/contract/inquiry.hpp"
#include "tests/support/exact_oracle.hpp"
#include "tests/support/scene_maker.hpp"

#include "base/bounds.hpp"
#include "base/memory.hpp"
#include "search/k_nearest_search.hpp"

#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

Answer flat_rows(const NearestRows& rows) {
  Answer answer = flat(rows.entries);
  answer.push_back(rows.length);
  answer.push_back(rows.size());
  return answer;
}

Answer flat_rows(const Result<NearestRows>& rows) {
  return rows ? flat_rows(*rows) : flat(rows.error());
}

// Scenes of one set that brute force can sort, and one with more ties than a row has room for.
const std::vector<Subject>& scenes() {
  static const std::vector<Subject> all = [] {
    std::vector<Subject> some;
    for (const Subject& subject : subjects()) {
      if (!subject.two_sets && subject.points.size() <= 420) some.push_back(subject);
    }
    Subject ties{"three places and a cube", {}, {}, false, {}};
    for (int i = 0; i < 120; ++i)
      ties.points.push_back({0.0 + i % 3, 0.0, i % 2 == 0 ? 0.0 : -0.0});
    for (int i = 0; i < 64; ++i)
      ties.points.push_back({0.0 + i % 4, 0.0 + i / 4 % 4, 0.0 + i / 16});
    some.push_back(ties);
    some.push_back({"none", {}, {}, false, {}});
    some.push_back({"one", {{1, 2, 3}}, {}, false, {}});
    return some;
  }();
  return all;
}

std::vector<std::size_t> lengths_for(std::size_t points) {
  std::vector<std::size_t> all = {0, 1, 2, 5, 17};
  if (points <= 100)
    all.insert(all.end(), {63, 64, 65, points - (points > 0 ? 1 : 0), points, kAll});
  return all;
}

// Brute force's rows of all others, cut to `k` of them.
Answer cut(const NearestRows& all, std::size_t k) {
  NearestRows rows;
  rows.length = std::min(k, all.length);
  for (std::size_t i = 0; rows.length > 0 && i < all.size(); ++i) {
    rows.entries.insert(rows.entries.end(), all[i].begin(),
                        all[i].begin() + static_cast<std::ptrdiff_t>(rows.length));
  }
  return flat_rows(rows);
}

// Of each scene one for each length; worked out once.
const std::vector<std::vector<Answer>>& expected_answers() {
  static const std::vector<std::vector<Answer>> answers = [] {
    std::vector<std::vector<Answer>> all;
    for (const Subject& scene : scenes()) {
      const NearestRows rows = *brute_force::find_k_nearest(scene.points, kAll);
      std::vector<Answer>& of_scene = all.emplace_back();
      for (const std::size_t k : lengths_for(scene.points.size())) {
        of_scene.push_back(cut(rows, k));
      }
    }
    return all;
  }();
  return answers;
}

template <class Ask>
void expect_brute_force(const std::string& name, Ask&& ask) {
  for (std::size_t i = 0; i < scenes().size(); ++i) {
    const Subject& scene = scenes()[i];
    const std::vector<std::size_t> lengths = lengths_for(scene.points.size());
    for (std::size_t n = 0; n < lengths.size(); ++n) {
      ASSERT_EQ(ask(scene.points, lengths[n]), expected_answers()[i][n])
          << name << ", " << scene.name << ", k " << lengths[n];
    }
  }
}

TEST(KNearest, BruteForceFindsAsManyAsAreAskedFor) {
  for (const Subject& scene : scenes()) {
    if (scene.points.size() > 100) continue;
    const NearestRows all = *brute_force::find_k_nearest(scene.points, kAll);
    for (const std::size_t k : lengths_for(scene.points.size())) {
      ASSERT_EQ(flat_rows(brute_force::find_k_nearest(scene.points, k)), cut(all, k)) << scene.name;
    }
  }
}

TEST(KNearest, BruteForceIsWhatIntegersSay) {
  for (const Subject& scene : scenes()) {
    const std::size_t size = scene.points.size();
    if (size > 100) continue;
    const ExactDistances distances(scene.points);
    const auto found = brute_force::find_k_nearest(scene.points, kAll);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), size < 2 ? 0 : size);
    for (std::size_t i = 0; i < found->size(); ++i) {
      std::vector<PointId> others(size);
      std::iota(others.begin(), others.end(), PointId{0});
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      std::stable_sort(others.begin(), others.end(), [&](PointId a, PointId b) {
        return distances.squared(i, a) < distances.squared(i, b);
      });
      ASSERT_EQ((*found)[i].size(), others.size());
      for (std::size_t n = 0; n < others.size(); ++n) {
        ASSERT_EQ((*found)[i][n].id, others[n]) << scene.name << ", row " << i;
        ASSERT_EQ((*found)[i][n].distance_m, distance(scene.points[i], scene.points[others[n]]));
      }
    }
  }
}

TEST(KNearest, FunctionsWithEveryNumberOfThreads) {
  for (const unsigned threads : {1U, 2U, 8U}) {
    expect_brute_force("threads " + std::to_string(threads),
                       [&](const auto& points, std::size_t k) {
                         return flat_rows(find_k_nearest(points, k, threads));
                       });
  }
}

TEST(KNearest, OneEngineForAllScenesWithEveryCrew) {
  for (const unsigned workers : {1U, 2U, 5U}) {
    BackwardCrew crew(workers);
    Engine engine(crew);
    NearestRows rows;
    expect_brute_force("workers " + std::to_string(workers),
                       [&](const auto& points, std::size_t k) {
                         const Status status = engine.find_k_nearest(points, k, rows);
                         return status ? flat_rows(rows) : flat(status.error());
                       });
  }
}

TEST(KNearest, EveryKernel) {
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    search::TuningOverrides tuning;
    tuning.instruction_set = set;
    BackwardCrew crew(3);
    core::Memory memory;
    const core::Resources with{crew, memory};
    std::vector<core::NearestList> lists(crew.size());
    NearestRows rows;
    expect_brute_force(cpu::name_of(set), [&](const std::vector<Point>& points, std::size_t k) {
      const Result<core::Bounds> bounds = core::measure(points, with);
      if (!bounds) return flat(bounds.error());
      search::find_k_nearest(points, *bounds, k, with, tuning, lists, rows);
      return flat_rows(rows);
    });
  }
}

// As Index::k_nearest, which knows nothing of a point's own id, on a swarm that threads share.
TEST(KNearest, IsWhatAnIndexSaysWithoutThePointItself) {
  SceneMaker make(5);
  std::vector<Point> points = make.box(30'000, {0, 0, 0}, {300, 300, 300});
  for (std::size_t i = 0; i < 3000; ++i) points[i] = points[i % 7];
  const auto index = Index::build(points);
  ASSERT_TRUE(index);
  constexpr std::size_t kLength = 6;
  const auto with_itself = index->k_nearest(points, kLength + 1);
  ASSERT_TRUE(with_itself);
  for (const unsigned threads : {1U, 3U}) {
    const auto found = find_k_nearest(points, kLength, threads);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<Nearest> expected((*with_itself)[i].begin(), (*with_itself)[i].end());
      const auto self = std::find_if(expected.begin(), expected.end(),
                                     [&](const Nearest& near) { return near.id == i; });
      expected.erase(self == expected.end() ? expected.end() - 1 : self);
      ASSERT_TRUE(std::equal(expected.begin(), expected.end(), (*found)[i].begin())) << i;
    }
  }
}

TEST(KNearest, RefusesWhatFindNearestRefuses) {
  const std::vector<Point> bad = {{0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}};
  NearestRows rows{1, {{}}};
  const Status status = Engine().find_k_nearest(bad, 1, rows);
  ASSERT_FALSE(status);
  EXPECT_EQ(flat(status.error()), flat(find_nearest(bad)));
  EXPECT_EQ(rows, NearestRows{});
  EXPECT_EQ(flat(brute_force::find_k_nearest(bad, 1).error()), flat(status.error()));
}

}  // namespace
}  // namespace beespace::test
