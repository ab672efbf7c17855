#include "scenes/swarm_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/random_stream.hpp"
#include "tests/scenes/fingerprint.hpp"

namespace beespace::scenes {
namespace {

constexpr std::size_t kMany = 200'000;

std::uint64_t fingerprint(const std::vector<Point>& points) {
  Fingerprint fingerprint;
  for (const Point& point : points) fingerprint.take({point.x, point.y, point.z});
  return fingerprint.value();
}

TEST(RandomStream, IsSplitMix64) {
  // The published sequence for seed 1234567.
  RandomStream random(1'234'567);
  EXPECT_EQ(random.bits(), 6'457'827'717'110'365'317u);
  EXPECT_EQ(random.bits(), 3'203'168'211'198'807'973u);
  EXPECT_EQ(random.bits(), 9'817'491'932'198'370'423u);
}

TEST(RandomStream, NearlyNormalHasTheMomentsOfTheNormalDistribution) {
  RandomStream random(5);
  double sum = 0.0;
  double squares = 0.0;
  double beyond_two = 0.0;
  for (std::size_t i = 0; i < kMany; ++i) {
    const double value = random.nearly_normal();
    ASSERT_LE(std::abs(value), 6.0);
    sum += value;
    squares += value * value;
    if (std::abs(value) > 2.0) beyond_two += 1.0;
  }
  EXPECT_NEAR(sum / kMany, 0.0, 0.01);
  EXPECT_NEAR(squares / kMany, 1.0, 0.02);
  EXPECT_NEAR(beyond_two / kMany, 0.0455, 0.003);
}

TEST(RandomStream, IndexReachesEveryValueAndNoOther) {
  RandomStream random(6);
  std::vector<int> seen(7, 0);
  for (int i = 0; i < 7'000; ++i) ++seen.at(random.index(7));
  for (const int count : seen) EXPECT_NEAR(count, 1'000, 200);
}

TEST(SwarmScenes, TheSameSeedGivesTheseBitsOnEveryMachine) {
  const std::vector<Point> box = uniform_box(1'000, {12'800.0, 6'400.0, 480.0}, 1);
  EXPECT_EQ(box[0], (Point{0x1.c53fcf832c275p+12, 0x1.2a500d4c2eaf5p+12, 0x1.d214d18016fe5p+8}));
  EXPECT_EQ(fingerprint(box), 3'899'778'610'226'821'131u);
  EXPECT_EQ(fingerprint(gaussian_clusters(1'000, 10, 200.0, 12'800.0, 1)),
            18'009'548'884'656'422'703u);
  EXPECT_EQ(fingerprint(geographic_area(1'000, kMedellin, 1)), 7'083'921'079'707'912'047u);
}

TEST(SwarmScenes, AnotherSeedGivesAnotherSwarm) {
  const Point size{100.0, 100.0, 100.0};
  EXPECT_NE(fingerprint(uniform_box(100, size, 1)), fingerprint(uniform_box(100, size, 2)));
  EXPECT_NE(fingerprint(gaussian_clusters(100, 3, 1.0, 100.0, 1)),
            fingerprint(gaussian_clusters(100, 3, 1.0, 100.0, 2)));
  EXPECT_NE(fingerprint(geographic_area(100, kMedellin, 1)),
            fingerprint(geographic_area(100, kMedellin, 2)));
}

TEST(SwarmScenes, UniformBoxFillsItsBoxEvenly) {
  const std::vector<Point> points = uniform_box(kMany, {10.0, 20.0, 30.0}, 3);
  Point sum;
  for (const Point& point : points) {
    ASSERT_TRUE(point.x >= 0.0 && point.x <= 10.0);
    ASSERT_TRUE(point.y >= 0.0 && point.y <= 20.0);
    ASSERT_TRUE(point.z >= 0.0 && point.z <= 30.0);
    sum = {sum.x + point.x, sum.y + point.y, sum.z + point.z};
  }
  EXPECT_NEAR(sum.x / kMany, 5.0, 0.1);
  EXPECT_NEAR(sum.y / kMany, 10.0, 0.2);
  EXPECT_NEAR(sum.z / kMany, 15.0, 0.3);
}

TEST(SwarmScenes, ClustersStayWithinSixSigmaOfTheirCube) {
  const std::vector<Point> points = gaussian_clusters(kMany, 4, 10.0, 1'000.0, 4);
  double close_to_first = 0.0;
  for (const Point& point : points) {
    for (const double coordinate : {point.x, point.y, point.z}) {
      ASSERT_TRUE(coordinate >= -60.0 && coordinate <= 1'060.0);
    }
    const double dx = point.x - points[0].x;
    const double dy = point.y - points[0].y;
    const double dz = point.z - points[0].z;
    if (std::sqrt(dx * dx + dy * dy + dz * dz) < 120.0) close_to_first += 1.0;
  }
  EXPECT_GT(close_to_first / kMany, 0.2);  // a quarter of all belongs to each centre
}

TEST(SwarmScenes, GeographicAreaStaysInItsRanges) {
  for (const Point& point : geographic_area(kMany, kMedellin, 5)) {
    ASSERT_TRUE(point.x >= -75.57 && point.x <= -75.54);
    ASSERT_TRUE(point.y >= 6.327 && point.y <= 6.348);
    ASSERT_TRUE(point.z >= 1'310.0 && point.z <= 1'790.0);
  }
}

TEST(SwarmScenes, AreasAreFoundByTheirNames) {
  ASSERT_TRUE(find_area("medellin").has_value());
  EXPECT_EQ(find_area("medellin")->west_deg, -75.57);
  EXPECT_FALSE(find_area("atlantis").has_value());
}

TEST(SwarmScenes, NoPointsIsAnEmptySwarm) {
  EXPECT_TRUE(uniform_box(0, {1.0, 1.0, 1.0}, 1).empty());
  EXPECT_TRUE(gaussian_clusters(0, 1, 1.0, 1.0, 1).empty());
  EXPECT_TRUE(geographic_area(0, kMedellin, 1).empty());
}

}  // namespace
}  // namespace beespace::scenes
