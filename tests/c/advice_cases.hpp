// A flock that C and C++ advise, and what both say of it.
#pragma once

#include "tests/c/advice_scenes.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <tuple>
#include <vector>

namespace beespace::test {

template <class Found, class RowOf>
void expect_list(const beespace_advice* advice, std::int32_t what, const std::vector<Found>& all,
                 bool with_times, RowOf&& row_of) {
  const beespace_findings list = c_findings(advice, what);
  ASSERT_EQ(list.count, static_cast<std::int64_t>(all.size()));
  EXPECT_EQ(list.times_s != nullptr, with_times && !all.empty());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [first, second, distance_m, time_s] = row_of(all[i]);
    EXPECT_EQ(list.first[i], static_cast<std::int64_t>(first));
    EXPECT_EQ(list.second[i], static_cast<std::int64_t>(second));
    EXPECT_EQ(list.distances_m[i], distance_m);
    if (with_times) {
      EXPECT_EQ(list.times_s[i], time_s);
    }
  }
}

inline void expect_same(const beespace_advice* advice, const Advised& expected) {
  ASSERT_EQ(beespace_advice_size(advice), static_cast<std::int64_t>(expected.advice.size()));
  for (std::size_t i = 0; i < expected.advice.size(); ++i) {
    const Advice& one = expected.advice[i];
    EXPECT_EQ(
        std::memcmp(beespace_advice_velocities(advice) + 3 * i, &one.velocity, sizeof one.velocity),
        0);
    EXPECT_EQ(beespace_advice_kinds(advice)[i], static_cast<int>(one.kind));
    EXPECT_EQ(beespace_advice_certified(advice)[i], one.certified ? 1 : 0);
    EXPECT_EQ(beespace_advice_keeps_apart(advice)[i], one.keeps_apart ? 1 : 0);
    EXPECT_EQ(beespace_advice_clear_of_intruders(advice)[i], one.clear_of_intruders ? 1 : 0);
    EXPECT_EQ(beespace_advice_clear_of_unknown(advice)[i], one.clear_of_unknown ? 1 : 0);
    EXPECT_EQ(beespace_advice_clear_of_unknown_s(advice)[i], one.clear_of_unknown_s);
  }
  expect_list(advice, BEESPACE_TOO_CLOSE, expected.too_close, true, [](const TooClose& c) {
    return std::tuple(c.pair.first, c.pair.second, c.gap_m, c.clear_s);
  });
  expect_list(advice, BEESPACE_NEAR_OBSTACLE, expected.near_obstacle, false,
              [](const NearObstacle& n) { return std::tuple(n.agent, n.obstacle, n.gap_m, 0.0); });
  expect_list(advice, BEESPACE_NEAR_FENCE, expected.near_fence, false,
              [](const NearFence& n) { return std::tuple(n.agent, n.fence, n.gap_m, 0.0); });
  expect_list(advice, BEESPACE_INTRUDER_CONFLICTS, expected.intruder_conflicts, true,
              [](const IntruderConflict& c) {
                return std::tuple(c.agent, c.intruder, c.closest_m, c.begins_s);
              });
  expect_list(advice, BEESPACE_NEAR_UNKNOWN, expected.near_unknown, true, [](const NearUnknown& n) {
    return std::tuple(n.agent, n.unknown, n.gap_m, n.clear_s);
  });
  ASSERT_EQ(beespace_advice_refused_count(advice),
            static_cast<std::int64_t>(expected.refused.size()));
  for (std::size_t i = 0; i < expected.refused.size(); ++i) {
    const Refused& one = expected.refused[i];
    beespace_error why = c_error();
    EXPECT_EQ(beespace_advice_refused(advice, static_cast<std::int64_t>(i), &why),
              static_cast<int>(one.kind));
    EXPECT_EQ(why.record, static_cast<std::int64_t>(one.index));
    EXPECT_EQ(why.message, one.error.message);
    EXPECT_STREQ(beespace_code_name(why.code), to_string(one.error.code).data());
  }
}

class CAdvice : public testing::Test {
 protected:
  beespace_code ask(const beespace_run* run = nullptr) {
    const beespace_points positions = c_vectors(flock_.positions);
    const beespace_points velocities = c_vectors(flock_.velocities);
    const beespace_points preferred = c_vectors(flock_.preferred);
    const beespace_limits limits = c_limits(flock_.limits);
    error_ = c_error();
    return beespace_advise(adviser_.get(), &positions, &velocities, &preferred, &limits, &options_,
                           run, advice_.get(), &error_);
  }
  void expect_as_cpp(const AdviseOptions& options) {
    const auto expected = advise(flock_.movers(), flock_.preferred, flock_.limits, options);
    ASSERT_TRUE(expected) << expected.error().message;
    ASSERT_EQ(ask(), BEESPACE_OK) << error_.message;
    expect_same(advice_.get(), *expected);
  }
  void expect_refused(const std::string& place, beespace_code code = BEESPACE_INVALID_ARGUMENT) {
    EXPECT_EQ(ask(), code) << place;
    EXPECT_EQ(error_.place, place) << error_.message;
    EXPECT_STRNE(error_.message, "");
    EXPECT_EQ(beespace_advice_size(advice_.get()), 0);
    EXPECT_EQ(beespace_advice_velocities(advice_.get()), nullptr);
    EXPECT_EQ(beespace_advice_refused_count(advice_.get()), 0);
  }
  [[nodiscard]] std::size_t certified() const {
    const std::uint8_t* const flags = beespace_advice_certified(advice_.get());
    return static_cast<std::size_t>(
        std::count(flags, flags + beespace_advice_size(advice_.get()), 1));
  }

  Flock flock_{7, 60, 30.0};
  beespace_advise_options options_ = c_advise_options(2.0);
  AdviseOptions cpp_{.threshold_m = 2.0};
  beespace_error error_ = c_error();
  OwnedAdvice<beespace_adviser> adviser_{beespace_adviser_create()};
  OwnedAdvice<beespace_advice> advice_{beespace_advice_create()};
};

}  // namespace beespace::test
