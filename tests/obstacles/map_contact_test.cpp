// The first contact of a ball with a whole map, compared with a loop over all obstacles.
#include "tests/obstacles/random_obstacles.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/obstacle.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;

struct Flight {
  Mover ball;
  double radius;
  double horizon;
};

std::optional<ObstacleContact> first_of_all(const std::vector<Obstacle>& obstacles,
                                            const Flight& flight) {
  std::optional<ObstacleContact> first;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const auto contact = *first_contact_s(obstacles[i], flight.ball, flight.radius, flight.horizon);
    if (contact && (!first || *contact < first->begins_s)) first = {i, *contact};
  }
  return first;
}

struct Tally {
  int at_once = 0;
  int later = 0;
  int never = 0;
};

void expect_same(const std::vector<Obstacle>& obstacles, const ObstacleMap& map,
                 const Flight& flight, Tally& tally) {
  const auto expected = first_of_all(obstacles, flight);
  const auto found = *map.first_contact(flight.ball, flight.radius, flight.horizon);
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!found) {
    ++tally.never;
    return;
  }
  ASSERT_EQ(found->begins_s, expected->begins_s);
  ASSERT_EQ(found->obstacle, expected->obstacle);
  ++(found->begins_s > 0.0 ? tally.later : tally.at_once);
}

// From outside as often as from inside, towards a place where obstacles stand; some stop short.
Flight random_flight(RandomStream& random, double spread) {
  const Point from = test::random_place(random, 3.0 * spread);
  const Point to = test::random_place(random, spread);
  const double radius = random.index(3) == 0 ? 0.0 : random.uniform(0.0, 1.0);
  return {{from, {0.1 * (to.x - from.x), 0.1 * (to.y - from.y), 0.1 * (to.z - from.z)}},
          radius,
          random.uniform(0.0, 20.0)};
}

TEST(MapContact, IsTheFirstOfALoop) {
  RandomStream random(1);
  Tally tally;
  for (int round = 0; round < test::rounds(400); ++round) {
    const double spread = std::exp(random.uniform(2.0, 6.0));
    const auto obstacles = test::random_obstacles(random, random.index(200), spread);
    const auto map = *ObstacleMap::of(obstacles);
    for (int flight = 0; flight < 10; ++flight) {
      ASSERT_NO_FATAL_FAILURE(expect_same(obstacles, map, random_flight(random, spread), tally))
          << "round " << round;
    }
  }
  EXPECT_GT(tally.at_once, test::rounds(400) / 4);
  EXPECT_GT(tally.later, test::rounds(400));
  EXPECT_GT(tally.never, test::rounds(400));
}

// Many stand at one place, and are touched at one time: the first of them counts.
TEST(MapContact, IsTheFirstOfEquals) {
  RandomStream random(2);
  Tally tally;
  for (int round = 0; round < test::rounds(400); ++round) {
    const auto whole = [&] { return static_cast<double>(random.index(4)); };
    std::vector<Obstacle> obstacles;
    for (int i = 0; i < 60; ++i) {
      const Point at{whole(), whole(), whole()};
      obstacles.push_back(Box{at, {at.x + 0.5, at.y + 0.5, at.z + 0.5}});
    }
    const Flight flight{{{-10, whole(), whole()}, {1, 0, 0}}, 0.25, 30.0};
    ASSERT_NO_FATAL_FAILURE(expect_same(obstacles, *ObstacleMap::of(obstacles), flight, tally))
        << "round " << round;
  }
  EXPECT_GT(tally.later, test::rounds(400) / 2);
}

TEST(MapContact, OfNothing) {
  const auto contact = ObstacleMap().first_contact({{0, 0, 0}, {1, 0, 0}}, 1.0, 1e9);
  ASSERT_TRUE(contact);
  EXPECT_FALSE(*contact);
}

TEST(MapContact, RefusesWhatIsNoFlight) {
  const auto map = *ObstacleMap::of({Ground{0}});
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto code = [&](const Mover& ball, double radius, double horizon) {
    const auto contact = map.first_contact(ball, radius, horizon);
    EXPECT_FALSE(contact);
    return contact ? std::nullopt : std::optional(contact.error().code);
  };
  EXPECT_EQ(code({{none, 0, 0}, {}}, 1, 1), ErrorCode::kNotFinite);
  EXPECT_EQ(code({{0, 0, 0}, {0, 1e31, 0}}, 1, 1), ErrorCode::kOutsideDomain);
  EXPECT_EQ(code({}, -1, 1), ErrorCode::kInvalidArgument);
  EXPECT_EQ(code({}, 1, -1), ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace beespace
