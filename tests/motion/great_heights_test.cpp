// Two movers meet in the corner of their cylinder, one ulp inside the horizontal threshold and just
// below the vertical one, where neighbouring doubles of heights are far apart: at rest, in passing,
// in recordings and live. Rounding must not lose them.
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/engine.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/predict_conflicts.hpp>
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace beespace {
namespace {

struct Setting {
  double height;
  double threshold;
  double vertical;

  friend void PrintTo(const Setting& s, std::ostream* out) {  // NOLINT: GoogleTest's name
    *out << "z " << s.height << ", X " << s.threshold << ", V " << s.vertical;
  }
};

// The flight of `lasts` seconds that passes a mover that stands at `other`.
struct Meeting {
  Point other;
  Point from;
  Velocity velocity;
  double lasts = 0.0;
};

// The last double above `from` that is less than `apart` above it. Differences of doubles so near
// to each other, or to 0, are exact.
double last_inside(double from, double apart) {
  double value = from + apart;
  while (value - from >= apart) value = std::nextafter(value, from);
  return value;
}

class GreatHeights : public testing::TestWithParam<Setting> {
 protected:
  static constexpr double kLasts = 8.0;

  // On the level from (0, -2^k 4, ...) to (0, 2^k 4, ...) in 8 s, past (x, 0, ...) where x is one
  // ulp inside the threshold; nothing is rounded.
  Meeting corner(bool at_rest) {
    const Setting& s = GetParam();
    const double threshold = s.threshold * make_.between(1.0, 2.0);
    threshold_ = threshold;
    vertical_ = s.vertical * make_.between(1.0, 2.0);
    const double z = s.height * make_.between(1.0, 2.0);
    Meeting meeting;
    meeting.other = {std::nextafter(threshold, 0.0), 0.0, last_inside(z, vertical_)};
    meeting.lasts = at_rest ? 0.0 : kLasts;
    const double speed = at_rest ? 0.0 : std::ldexp(1.0, std::ilogb(threshold) + 1);
    meeting.from = {0.0, -0.5 * kLasts * speed, z};
    meeting.velocity = {0.0, speed, 0.0};
    return meeting;
  }

  [[nodiscard]] PredictOptions options(const Meeting& meeting) const {
    PredictOptions options;
    options.threshold_m = threshold_;
    options.vertical_m = vertical_;
    options.horizon_s = meeting.lasts;
    return options;
  }

  test::SceneMaker make_{7};
  double threshold_ = 0.0;
  double vertical_ = 0.0;
};

TEST_P(GreatHeights, ArePredicted) {
  Engine engine;
  for (int round = 0; round < test::rounds(2000); ++round) {
    const Meeting m = corner(round % 2 == 0);
    const std::vector<Mover> movers = {{m.other, {}}, {m.from, m.velocity}};
    ASSERT_EQ(brute_force::predict_conflicts(movers, options(m)).value().size(), 1U) << round;
    ASSERT_EQ(predict_conflicts(movers, options(m)).value().size(), 1U) << round;
    ASSERT_EQ(predict_pairs(movers, options(m)).value().size(), 1U) << round;
    std::vector<Pair> pairs;
    ASSERT_TRUE(engine.predict_pairs(movers, options(m), pairs).has_value());
    ASSERT_EQ(pairs.size(), 1U) << round;
  }
}

// Exactly at the thresholds they are not in conflict, unless the options are inclusive.
TEST_P(GreatHeights, AtTheThresholdItselfAreNone) {
  for (int round = 0; round < test::rounds(500); ++round) {
    Meeting m = corner(round % 2 == 0);
    m.other.x = threshold_;
    const std::vector<Mover> movers = {{m.other, {}}, {m.from, m.velocity}};
    PredictOptions o = options(m);
    ASSERT_EQ(predict_pairs(movers, o).value().size(), 0U) << round;
    o.inclusive = true;
    ASSERT_EQ(predict_pairs(movers, o).value().size(), 1U) << round;
  }
}

std::vector<Track> tracks_of(const Meeting& m) {
  const double begin = 0.0;
  const double end = m.lasts > 0.0 ? m.lasts : 1.0;
  const Point to{m.from.x, m.from.y + m.velocity.y * m.lasts, m.from.z};
  return {{{{begin, m.other}, {end, m.other}}}, {{{begin, m.from}, {end, to}}}};
}

TEST_P(GreatHeights, AreFoundInRecordings) {
  for (int round = 0; round < test::rounds(1000); ++round) {
    const Meeting m = corner(round % 2 == 0);
    ConflictOptions o;
    o.threshold_m = threshold_;
    o.vertical_m = vertical_;
    ASSERT_EQ(find_conflicts(tracks_of(m), o).value().conflicts.size(), 1U) << round;
  }
}

TEST_P(GreatHeights, AreHeardOfLive) {
  for (int round = 0; round < test::rounds(1000); ++round) {
    const Meeting m = corner(round % 2 == 0);
    SwarmOptions o;
    o.threshold_m = threshold_;
    o.vertical_m = vertical_;
    o.leave_factor = 1.0;
    o.horizon_s = 0.0;
    o.max_age_s = 100.0;
    Swarm swarm(o);
    const std::vector<Track> tracks = tracks_of(m);
    for (std::size_t fix = 0; fix < 2; ++fix) {
      for (PointId id = 0; id < 2; ++id) {
        const Fix& at = tracks[id].fixes[fix];
        ASSERT_TRUE(swarm.update({id, at.time_s, at.position}).has_value());
      }
    }
    std::size_t entered = 0;
    const auto events = swarm.finish(tracks[0].fixes[1].time_s);
    ASSERT_TRUE(events.has_value()) << events.error().message;
    for (const SwarmEvent& event : *events) entered += event.kind == EventKind::kEntered ? 1 : 0;
    ASSERT_EQ(entered, 1U) << round;
  }
}

INSTANTIATE_TEST_SUITE_P(Corners, GreatHeights,
                         testing::Values(Setting{1e15, 142.0, 1.0}, Setting{1e12, 100.0, 1e-3},
                                         Setting{1e11, 50.0, 1.0}, Setting{1e9, 5.0, 0.1},
                                         Setting{6.37e6, 100.0, 1e-4}, Setting{6.37e6, 5.0, 1e-3},
                                         Setting{0x1p+98, 0x1p+20, 0x1p+60},
                                         Setting{0x1p-80, 0x1p-98, 0x1p-98},
                                         Setting{0x1p+40, 0x1p-98, 0x1p+96}));

}  // namespace
}  // namespace beespace
