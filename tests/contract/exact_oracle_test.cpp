// Brute force, the reference for all else, against arithmetic without rounding; and the oracle
// itself against results by hand.
#include "tests/support/exact_oracle.hpp"
#include "tests/contract/agreement.hpp"
#include "tests/contract/golden_digest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace beespace::test {
namespace {

TEST(ExactOracle, AgreesWithBruteForceOnEveryInquiry) {
  expect_brute_force_of(oracle());
  EXPECT_EQ(digest(expected_digests()), kGoldenAnswers)
      << std::hex << "it is now 0x" << digest(expected_digests());
}

TEST(ExactOracle, DoublesBecomeIntegersWithoutLoss) {
  EXPECT_EQ(scaled(0.75, -2), 3);
  EXPECT_EQ(scaled(-6.0, 0), -6);
  EXPECT_EQ(scaled(0x1p+400, -452), ExactInteger(1) << 852);
  EXPECT_EQ(binary(-0.0).mantissa, 0);
  EXPECT_EQ(lowest_exponent({{1.0, 0.0, 0.5}, {0x1.0000000000001p-400, 8.0, 0.0}}), -452);
}

TEST(ExactOracle, TheThresholdItselfIsTooCloseOnlyInclusively) {
  const ExactDistances distances({{0, 0, 0}, {3, 4, 12}, {3, 4, 0}});
  const auto first_row = [&](double threshold, bool inclusive) {
    return ExactNeighbors(distances, {threshold, inclusive}).rows()[0];
  };
  using Ids = std::vector<PointId>;
  EXPECT_EQ(first_row(13.0, false), (Ids{2}));
  EXPECT_EQ(first_row(13.0, true), (Ids{1, 2}));
  EXPECT_EQ(first_row(std::nextafter(13.0, 14.0), false), (Ids{1, 2}));
  EXPECT_EQ(first_row(std::nextafter(13.0, 0.0), true), (Ids{2}));
  EXPECT_EQ(first_row(0x1p-400, true), Ids{});
  EXPECT_EQ(first_row(0x1p+400, false), (Ids{1, 2}));
}

TEST(ExactOracle, TiesGoToTheLowestIdAndGroupsAreComponents) {
  const ExactDistances distances({{5, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {9, 0, 0}});
  EXPECT_EQ(exact_nearest(distances), (std::vector<std::optional<PointId>>{3, 2, 1, 2, 0}));
  EXPECT_EQ(*exact_closest_pair(distances), (Pair{1, 2}));
  const ExactNeighbors neighbors(distances, {1.5});
  EXPECT_EQ(neighbors.groups(), (std::vector<std::vector<PointId>>{{1, 2, 3}}));
  EXPECT_EQ(neighbors.at_risk(), (std::vector<PointId>{1, 2, 3}));
}

// 1 + 2^-54 rounds to 1, one half ulp and a little more to the next double.
TEST(ExactOracle, DistancesAreRoundedToTheNearestDouble) {
  EXPECT_EQ(rounded_distance({0, 0, 0}, {3, 4, 12}), 13.0);
  EXPECT_EQ(rounded_distance({1, 1, 1}, {1, 1, 1}), 0.0);
  EXPECT_EQ(rounded_distance({1, 0, 0}, {-0x1p-54, 0, 0}), 1.0);
  EXPECT_EQ(rounded_distance({1, 0, 0}, {-0x1.1p-53, 0, 0}), 1.0 + 0x1p-52);
  EXPECT_EQ(rounded_distance({1, 0, 0}, {0x1.1p-54, 0, 0}), 1.0 - 0x1p-53);
}

// "Within 4 * 2^-53 of the true one, relatively": (1 - e)^2 S <= d^2 <= (1 + e)^2 S in integers.
TEST(ReportedDistance, IsWithinItsBoundOfTheTrueOne) {
  constexpr double kBound = 4.0 * 0x1p-53;
  std::size_t pairs = 0;
  for (const Subject& subject : subjects()) {
    const std::vector<Point>& points = subject.points;
    for (std::size_t i = 1; !subject.two_sets && i < points.size(); ++i) {
      const Point& p = points[i - 1];
      const Point& q = points[i];
      const ExactDistances distances({p}, {q});
      const auto is_within = [&](double slack, bool at_most) {
        const int unit = std::min(lowest_exponent({p}), lowest_exponent({q}));
        const double reported = distance(p, q);
        const int low = std::min(unit, binary(reported).exponent);
        const ExactInteger d = scaled(reported, low) << 53;
        const ExactInteger factor = scaled(1.0, -53) + scaled(slack, -53);  // 2^53 (1 + slack)
        const ExactInteger s = distances.squared(0, 0) << (2 * (unit - low));
        return at_most ? d * d <= factor * factor * s : d * d >= factor * factor * s;
      };
      ASSERT_TRUE(is_within(kBound, true) && is_within(-kBound, false)) << subject.name << " " << i;
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 10'000U);
}

TEST(Inquiries, AskEveryQuestionOfEveryScene) {
  std::set<std::pair<std::string, Question>> asked;
  std::set<std::string> names;
  for (const Inquiry& inquiry : inquiries()) {
    asked.emplace(inquiry.subject->name, inquiry.question);
    names.insert(inquiry.subject->name);
  }
  EXPECT_EQ(names.size(), subjects().size());
  std::size_t questions = 0;
  for (const Subject& subject : subjects()) questions += subject.two_sets ? 7 : 9;
  EXPECT_EQ(asked.size(), questions);
}

// If the radii missed the distances by an ulp, strict and inclusive would rarely differ.
TEST(Inquiries, ManyPairsAreExactlyAtTheThreshold) {
  std::map<std::pair<const Subject*, double>, std::uint64_t> strict;
  std::size_t different = 0;
  for (std::size_t i = 0; i < inquiries().size(); ++i) {
    const Inquiry& inquiry = inquiries()[i];
    if (inquiry.question != Question::kPairs ||
        inquiry.options.max_results != PairOptions{}.max_results) {
      continue;
    }
    const std::pair key(inquiry.subject, inquiry.options.threshold_m);
    if (!inquiry.options.inclusive) strict[key] = expected_digests()[i];
    if (inquiry.options.inclusive && strict.at(key) != expected_digests()[i]) ++different;
  }
  EXPECT_GT(different, 100U);
}

TEST(Inquiries, SomeAllowTooFewResultsByOne) {
  const std::uint64_t too_many = digest(flat(Error{ErrorCode::kTooManyResults, {}, {}}));
  const auto& digests = expected_digests();
  EXPECT_GT(std::count(digests.begin(), digests.end(), too_many), 500);
}

TEST(Scenes, AreTheSameBitForBitEverywhere) {
  Answer bits;
  for (const Subject& subject : subjects()) {
    for (const auto* points : {&subject.points, &subject.others}) {
      for (const Point& p : *points) {
        for (const double value : {p.x, p.y, p.z}) {
          bits.push_back(std::bit_cast<std::uint64_t>(value));
        }
      }
    }
  }
  EXPECT_EQ(digest(bits), kGoldenScenes) << std::hex << "it is now 0x" << digest(bits);
}

}  // namespace
}  // namespace beespace::test
