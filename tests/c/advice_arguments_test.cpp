// What callers of advice get wrong becomes an error that says where.
#include "tests/c/advice_cases.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST_F(CAdvice, OptionsThatMakeNoSenseAreRefused) {
  const beespace_advise_options good = options_;
  const auto refuse = [&](auto&& change, const char* place,
                          beespace_code code = BEESPACE_INVALID_ARGUMENT) {
    options_ = good;
    change(options_);
    expect_refused(place, code);
  };
  using Options = beespace_advise_options;
  refuse([](Options& o) { o.struct_size = 0; }, "options");
  refuse([](Options& o) { o.struct_size -= 8; }, "options");
  refuse([](Options& o) { o.reserved = 1; }, "options");
  refuse([](Options& o) { o.flags = 4; }, "options");
  refuse([](Options& o) { o.method = 3; }, "options");
  refuse([](Options& o) { o.shape = 3; }, "options");
  refuse([](Options& o) { o.shape = 77; }, "options");
  // What a shape has no use for was meant for another one.
  refuse([](Options& o) { o.vertical_factor = 3.0; }, "options");
  refuse([](Options& o) { o.vertical_m = 3.0; }, "options");
  refuse(
      [](Options& o) {
        o.shape = BEESPACE_FREE_ELLIPSOID;
        o.vertical_factor = o.vertical_m = 3.0;
      },
      "options");
  refuse(
      [](Options& o) {
        o.shape = BEESPACE_FREE_CYLINDER;
        o.vertical_factor = o.vertical_m = 3.0;
      },
      "options");
  refuse([](Options& o) { o.shape = BEESPACE_FREE_CYLINDER; }, "");
  refuse([](Options& o) { o.step_s = -0.1; }, "");
  refuse([](Options& o) { o.uncertainty_m = kNaN; }, "");
  refuse([](Options& o) { o.threshold_m = 0.0; }, "", BEESPACE_INVALID_THRESHOLD);
  refuse([](Options& o) { o.threshold_m = kNaN; }, "", BEESPACE_INVALID_THRESHOLD);
  const std::vector<Point> one = {{0.0, 0.0, 2.0}};
  const beespace_points points = c_vectors(one);
  const double number = -1.0;
  const std::int64_t far = 60;
  refuse([&](Options& o) { o.fence_directions = &points; }, "fence_offsets");
  refuse([&](Options& o) { o.fence_offsets_m = &number; }, "fence_directions");
  refuse(
      [&](Options& o) {
        o.fence_directions = &points;
        o.fence_offsets_m = &number;
        o.clearance_m = 1.0;
      },
      "fence_directions");
  refuse([&](Options& o) { o.intruder_positions = &points; }, "intruder_velocities");
  refuse([&](Options& o) { o.intruder_velocities = &points; }, "intruder_positions");
  refuse([&](Options& o) { o.intruder_margins_m = &number; }, "intruder_positions");
  refuse(
      [&](Options& o) {
        o.intruder_positions = o.intruder_velocities = &points;
        o.intruder_margins_m = &number;
      },
      "intruder_margins");
  refuse([&](Options& o) { o.unknown_centers = &points; }, "unknown_radii");
  refuse([&](Options& o) { o.unknown_agents = &far; }, "unknown_centers");
  refuse(
      [&](Options& o) {
        o.unknown_centers = &points;
        o.unknown_radii_m = &number;
      },
      "unknown_growths");
  refuse(
      [&](Options& o) {
        o.unknown_centers = &points;
        o.unknown_radii_m = o.unknown_growths_mps = &number;
        o.unknown_agents = &far;
      },
      "unknown_agents");
}

TEST_F(CAdvice, ArraysThatDoNotFitAreRefused) {
  const Flock good = flock_;
  flock_.velocities.pop_back();
  expect_refused("velocities");
  flock_ = good;
  flock_.preferred.pop_back();
  expect_refused("preferred");
  flock_ = good;
  flock_.limits = {{.max_speed_mps = -1.0}};
  expect_refused("limits");
  flock_ = good;
  beespace_points points = c_vectors(flock_.positions);
  beespace_limits limits = c_limits(flock_.limits);
  const auto refused = [&](const beespace_points* p, const beespace_limits* l, const char* place) {
    error_ = c_error();
    EXPECT_EQ(beespace_advise(adviser_.get(), p, &points, &points, l, &options_, nullptr,
                              advice_.get(), &error_),
              BEESPACE_INVALID_ARGUMENT);
    EXPECT_STREQ(error_.place, place);
  };
  refused(nullptr, &limits, "positions");
  refused(&points, nullptr, "limits");
  limits.max_speeds_mps = nullptr;
  refused(&points, &limits, "limits");
  limits = c_limits(flock_.limits);
  limits.max_accelerations_stride = 4;
  refused(&points, &limits, "limits");
  limits.max_accelerations_stride = std::numeric_limits<std::ptrdiff_t>::max() - 7;
  refused(&points, &limits, "limits");
  limits = c_limits(flock_.limits);
  limits.reserved = 1;
  refused(&points, &limits, "limits");
  EXPECT_EQ(beespace_advise(adviser_.get(), &points, &points, &points, &limits, nullptr, nullptr,
                            nullptr, nullptr),
            BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CAdvice, MoreAgentsThanIdsAreRefusedBeforeOneIsCopied) {
  beespace_points points = c_vectors(flock_.positions);
  points.count = std::numeric_limits<std::int64_t>::max();
  points.x_stride = points.y_stride = points.z_stride = 0;
  const beespace_limits limits = c_limits(flock_.limits);
  EXPECT_EQ(beespace_advise(adviser_.get(), &points, &points, &points, &limits, &options_, nullptr,
                            advice_.get(), &error_),
            BEESPACE_TOO_MANY_POINTS);
  EXPECT_STREQ(error_.place, "positions");
}

TEST_F(CAdvice, NoAgentAndNoPointerAreNoCrash) {
  const beespace_points none = beespace_points_interleaved(nullptr, 0);
  beespace_limits limits{};
  limits.struct_size = sizeof limits;
  ASSERT_EQ(beespace_advise(adviser_.get(), &none, &none, &none, &limits, &options_, nullptr,
                            advice_.get(), &error_),
            BEESPACE_OK)
      << error_.message;
  EXPECT_EQ(beespace_advice_size(advice_.get()), 0);
  EXPECT_EQ(beespace_advice_size(nullptr), 0);
  EXPECT_EQ(beespace_advice_velocities(nullptr), nullptr);
  EXPECT_EQ(beespace_advice_refused_count(nullptr), 0);
  beespace_findings list{};
  EXPECT_EQ(beespace_advice_findings(advice_.get(), 0, &list, nullptr), BEESPACE_INVALID_ARGUMENT);
  list.struct_size = sizeof list;
  EXPECT_EQ(beespace_advice_findings(nullptr, 0, &list, nullptr), BEESPACE_INVALID_ARGUMENT);
  for (const std::int32_t what : {-1, 5}) {
    EXPECT_EQ(beespace_advice_findings(advice_.get(), what, &list, nullptr),
              BEESPACE_INVALID_ARGUMENT);
  }
}

}  // namespace
}  // namespace beespace::test
