// Advice of C is that of C++ bit by bit, with all that there may be around; what callers get wrong
// becomes an error that says where, and what is wrong about one agent is listed and clears no
// other.
#include "tests/c/advice_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <tuple>

namespace beespace::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST_F(CAdvice, IsThatOfCppStepAfterStep) {
  for (int step = 0; step < 20; ++step) {
    expect_as_cpp(cpp_);
    if (step == 0) {
      EXPECT_GT(c_findings(advice_.get(), BEESPACE_TOO_CLOSE).count, 0);
    }
    const double* const advised = beespace_advice_velocities(advice_.get());
    for (std::size_t i = 0; i < flock_.positions.size(); ++i) {
      Velocity& old = flock_.velocities[i];
      const Velocity now{advised[3 * i], advised[3 * i + 1], advised[3 * i + 2]};
      flock_.positions[i].x += (old.x + now.x) / 2.0 * 0.1;
      flock_.positions[i].y += (old.y + now.y) / 2.0 * 0.1;
      flock_.positions[i].z += (old.z + now.z) / 2.0 * 0.1;
      old = now;
    }
  }
}

TEST_F(CAdvice, ShapesStepsMethodsAndLimitsAreThoseOfCpp) {
  options_.step_s = cpp_.step_s = 0.25;
  options_.uncertainty_m = cpp_.uncertainty_m = 0.125;
  options_.shape = BEESPACE_FREE_ELLIPSOID;
  options_.vertical_factor = 3.0;
  cpp_.separation = {SeparationShape::kEllipsoid, 3.0};
  expect_as_cpp(cpp_);
  options_.shape = BEESPACE_FREE_CYLINDER;
  options_.vertical_factor = 0.0;
  options_.vertical_m = 1.5;
  cpp_.separation = {SeparationShape::kCylinder, 3.0, 1.5};
  expect_as_cpp(cpp_);
  flock_.limits = {{.max_speed_mps = 4.0}};
  const beespace_points positions = c_vectors(flock_.positions);
  const beespace_points velocities = c_vectors(flock_.velocities);
  const beespace_points preferred = c_vectors(flock_.preferred);
  beespace_limits limits = c_limits(flock_.limits);
  limits.max_accelerations_mps2 = nullptr;  // without a limit
  ASSERT_EQ(beespace_advise(nullptr, &positions, &velocities, &preferred, &limits, &options_,
                            nullptr, advice_.get(), &error_),
            BEESPACE_OK)
      << error_.message;
  expect_same(advice_.get(), *advise(flock_.movers(), flock_.preferred, flock_.limits, cpp_));
  for (const std::int32_t method : {BEESPACE_ORCA, BEESPACE_MVP}) {
    options_.method = method;
    cpp_.method = static_cast<AdviseMethod>(method);
    expect_as_cpp(cpp_);
    EXPECT_EQ(certified(), 0U);
  }
}

TEST_F(CAdvice, FencesIntrudersAndUnknownAgentsAreThoseOfCpp) {
  const std::vector<Point> inward = {{0.0, 0.0, 1.0}, {0.6, 0.8, 0.0}};
  const std::vector<double> offsets_m = {5.0, 8.0};
  const std::vector<Fence> fences = {{inward[0], 5.0}, {inward[1], 8.0}};
  const std::vector<Mover> intruders = {{{15.0, 15.0, 0.0}, {0.0, 1.0, 5.0}},
                                        {{0.0, 0.0, 15.0}, {3.0, 3.0, 0.0}}};
  const std::vector<Point> intruder_positions = {intruders[0].position, intruders[1].position};
  const std::vector<Velocity> intruder_velocities = {intruders[0].velocity, intruders[1].velocity};
  const std::vector<double> margins_m = {0.5, 1.0};
  const std::vector<Point> centers = {{20.0, 20.0, 20.0}, {10.0, 20.0, 10.0}};
  const std::vector<double> radii_m = {1.0, 2.0};
  const std::vector<double> growths_mps = {0.0, 0.5};
  const std::vector<std::int64_t> agents = {-1, 4};
  const std::vector<UnknownAgent> unknown = {{centers[0], 1.0, 0.0, {}}, {centers[1], 2.0, 0.5, 4}};
  const beespace_points c_inward = c_vectors(inward);
  const beespace_points c_positions = c_vectors(intruder_positions);
  const beespace_points c_velocities = c_vectors(intruder_velocities);
  const beespace_points c_centers = c_vectors(centers);
  options_.fence_directions = &c_inward;
  options_.fence_offsets_m = offsets_m.data();
  options_.clearance_m = cpp_.clearance_m = 1.0;
  options_.intruder_positions = &c_positions;
  options_.intruder_velocities = &c_velocities;
  options_.intruder_margins_m = margins_m.data();
  options_.intruder_horizon_s = cpp_.intruder_horizon_s = 6.0;
  options_.unknown_centers = &c_centers;
  options_.unknown_radii_m = radii_m.data();
  options_.unknown_growths_mps = growths_mps.data();
  options_.unknown_agents = agents.data();
  options_.unknown_horizon_s = cpp_.unknown_horizon_s = 4.0;
  cpp_.fences = fences;
  cpp_.intruders = intruders;
  cpp_.intruder_margins_m = margins_m;
  cpp_.unknown = unknown;
  expect_as_cpp(cpp_);
  EXPECT_GT(c_findings(advice_.get(), BEESPACE_NEAR_FENCE).count, 0);
  EXPECT_GT(c_findings(advice_.get(), BEESPACE_INTRUDER_CONFLICTS).count, 0);
  EXPECT_GT(c_findings(advice_.get(), BEESPACE_NEAR_UNKNOWN).count, 0);
  EXPECT_EQ(beespace_advice_kinds(advice_.get())[4], BEESPACE_NO_ADVICE);
  options_.unknown_agents = nullptr;
  options_.intruder_margins_m = nullptr;
  std::vector<UnknownAgent> none = unknown;
  none[1].agent.reset();
  cpp_.unknown = none;
  cpp_.intruder_margins_m = std::span<const double>();
  expect_as_cpp(cpp_);
}

TEST_F(CAdvice, ObstaclesAreThoseOfCpp) {
  const std::vector<Obstacle> all = {Sphere{{15.0, 15.0, 15.0}, 4.0}, Ground{1.0}};
  const ObstacleMap map = *ObstacleMap::of(all);
  std::array<beespace_obstacle, 2> given{};
  for (beespace_obstacle& one : given) one.struct_size = sizeof one;
  given[0].kind = BEESPACE_SPHERE;
  std::fill(std::begin(given[0].center), std::end(given[0].center), 15.0);
  given[0].radius_m = 4.0;
  given[1].kind = BEESPACE_GROUND;
  given[1].high[2] = 1.0;
  beespace_obstacles* made = nullptr;
  ASSERT_EQ(beespace_obstacles_create(given.data(), 2, &made, nullptr), BEESPACE_OK);
  const Owned<beespace_obstacles> kept(made);
  options_.obstacles = made;
  expect_refused("");  // no clearance
  options_.clearance_m = cpp_.clearance_m = 1.5;
  cpp_.obstacles = &map;
  expect_as_cpp(cpp_);
  EXPECT_GT(c_findings(advice_.get(), BEESPACE_NEAR_OBSTACLE).count, 0);
}

// Each claims its place, one behind it and one above that.
TEST_F(CAdvice, ClaimsRadiiAndRememberedPlanesAreThoseOfCpp) {
  const std::size_t size = flock_.positions.size();
  std::vector<double> radii_m(size, 0.5);
  std::vector<double> tubes_m(size, 0.25);
  std::vector<std::uint8_t> holds(size, 0);
  std::vector<Point> places;
  std::vector<std::int64_t> offsets = {0};
  for (std::size_t i = 0; i < size; ++i) {
    radii_m[i] += 0.03125 * static_cast<double>(i % 50);
    holds[i] = i % 7 == 0 ? 1 : 0;
    Point place = flock_.positions[i];
    for (std::size_t k = 0; k < i % 3; ++k) {
      place.z += 0.25;
      places.push_back(place);
    }
    offsets.push_back(static_cast<std::int64_t>(places.size()));
  }
  const beespace_points c_places = c_vectors(places);
  options_.radii_m = radii_m.data();
  std::vector<Claim> claims(size);
  for (std::size_t i = 0; i < size; ++i) claims[i].radius_m = radii_m[i];
  cpp_.claims = claims;
  expect_as_cpp(cpp_);
  options_.tubes_m = tubes_m.data();
  options_.holds = holds.data();
  options_.claim_places = &c_places;
  options_.claim_offsets = offsets.data();
  options_.flags = BEESPACE_REMEMBER;
  for (std::size_t i = 0; i < size; ++i) {
    const auto begin = static_cast<std::size_t>(offsets[i]);
    claims[i] = {std::span(places).subspan(begin, i % 3), 0.25, radii_m[i], holds[i] != 0};
  }
  PlaneMemory planes;
  cpp_.planes = &planes;
  for (int step = 0; step < 8; ++step) {
    if (step == 5) {
      beespace_adviser_forget(adviser_.get(), 3);
      planes.forget(3);
    }
    expect_as_cpp(cpp_);
    EXPECT_EQ(beespace_advice_kinds(advice_.get())[7], BEESPACE_BRAKING);
    for (std::size_t i = 0; i < size; ++i) flock_.preferred[i].x = -flock_.preferred[i].x;
  }
  beespace_adviser_forget(nullptr, 3);
  beespace_adviser_forget(adviser_.get(), -1);
  beespace_adviser_forget(adviser_.get(), std::numeric_limits<std::int64_t>::max());
  radii_m[4] = kNaN;
  ASSERT_EQ(ask(), BEESPACE_OK);
  beespace_error why = c_error();
  EXPECT_EQ(beespace_advice_refused(advice_.get(), 0, &why), BEESPACE_REFUSED_STATE);
  EXPECT_STREQ(why.place, "claims");
  EXPECT_EQ(why.record, 4);
  EXPECT_EQ(certified(), 0U);
  offsets[4] = 1000;
  expect_refused("claim_offsets");
  EXPECT_EQ(error_.record, 5);  // from there on they do not ascend
  offsets[4] = offsets[3];
  offsets[0] = -1;
  expect_refused("claim_offsets");
  offsets[0] = 0;
  offsets.back() += 1;
  expect_refused("claim_offsets");
  options_.claim_offsets = nullptr;
  expect_refused("claim_offsets");
  options_.claim_offsets = offsets.data();
  options_.claim_places = nullptr;
  expect_refused("claim_places");
}

TEST_F(CAdvice, InAPlaneIsThatOfCpp) {
  for (Point& place : flock_.positions) place.z = 10.0;
  for (Velocity& velocity : flock_.velocities) velocity.z = 0.0;
  flock_.positions[3].z = 11.0;
  options_.flags = BEESPACE_PLANAR;
  cpp_.planar = true;
  expect_as_cpp(cpp_);
  beespace_error why = c_error();
  ASSERT_EQ(beespace_advice_refused(advice_.get(), 0, &why), BEESPACE_REFUSED_STATE);
  EXPECT_STREQ(why.place, "positions");
  EXPECT_EQ(why.record, 3);
}

// One that may be anywhere clears none; what is refused says of which array.
TEST_F(CAdvice, AStateThatCannotBeUsedIsListedAndCertifiesNoOther) {
  expect_as_cpp(cpp_);
  ASSERT_GT(certified(), 0U);
  const auto expect_listed = [&](std::int32_t kind, const char* place, beespace_code code) {
    expect_as_cpp(cpp_);
    beespace_error why = c_error();
    ASSERT_EQ(beespace_advice_refused_count(advice_.get()), 1);
    EXPECT_EQ(beespace_advice_refused(advice_.get(), 0, &why), kind);
    EXPECT_STREQ(why.place, place);
    EXPECT_EQ(why.code, code);
    EXPECT_EQ(why.record, 9);
    if (kind == BEESPACE_REFUSED_STATE) {
      EXPECT_EQ(certified(), 0U);
      EXPECT_EQ(beespace_advice_kinds(advice_.get())[9], BEESPACE_NO_ADVICE);
    }
  };
  const Flock good = flock_;
  flock_.positions[9].y = kNaN;
  expect_listed(BEESPACE_REFUSED_STATE, "positions", BEESPACE_NOT_FINITE);
  flock_ = good;
  flock_.velocities[9].x = 1e200;
  expect_listed(BEESPACE_REFUSED_STATE, "velocities", BEESPACE_OUTSIDE_DOMAIN);
  flock_ = good;
  flock_.limits[9].max_speed_mps = -1.0;
  expect_listed(BEESPACE_REFUSED_STATE, "limits", BEESPACE_INVALID_ARGUMENT);
  flock_ = good;
  flock_.preferred[9].z = std::numeric_limits<double>::infinity();
  expect_listed(BEESPACE_REFUSED_PREFERRED, "preferred", BEESPACE_NOT_FINITE);
  beespace_error why = c_error();
  EXPECT_EQ(beespace_advice_refused(advice_.get(), 1, &why), -1);
  EXPECT_EQ(beespace_advice_refused(advice_.get(), -1, &why), -1);
  EXPECT_EQ(beespace_advice_refused(nullptr, 0, &why), -1);
}

TEST_F(CAdvice, AStopEndsIt) {
  const Owned<beespace_stop> stop(beespace_stop_create());
  beespace_stop_request(stop.get());
  beespace_run run{};
  run.struct_size = sizeof run;
  run.stop = stop.get();
  EXPECT_EQ(ask(&run), BEESPACE_STOPPED);
  EXPECT_EQ(beespace_advice_size(advice_.get()), 0);
  run.stop = nullptr;
  run.threads = 2;
  ASSERT_EQ(ask(&run), BEESPACE_OK);
  expect_same(advice_.get(), *advise(flock_.movers(), flock_.preferred, flock_.limits, cpp_));
}

TEST_F(CAdvice, VelocitiesToGoalsAreThoseOfCpp) {
  const std::size_t size = flock_.positions.size();
  const std::vector<Point> goals(flock_.positions.rbegin(), flock_.positions.rend());
  const beespace_points positions = c_vectors(flock_.positions);
  beespace_points to = c_vectors(goals);
  const beespace_limits limits = c_limits(flock_.limits);
  std::vector<Velocity> found(size);
  ASSERT_EQ(beespace_velocity_to_goal(&positions, &to, &limits, 0.0, &found.front().x, &error_),
            BEESPACE_OK);
  for (std::size_t i = 0; i < size; ++i) {
    EXPECT_EQ(found[i], *velocity_to_goal(flock_.positions[i], goals[i], flock_.limits[i], 0.1));
  }
  const auto refused = [&](const beespace_points& at, double step_s, const char* place,
                           std::int64_t record) {
    error_ = c_error();
    EXPECT_NE(
        beespace_velocity_to_goal(&positions, &at, &limits, step_s, &found.front().x, &error_),
        BEESPACE_OK);
    EXPECT_STREQ(error_.place, place) << error_.message;
    EXPECT_EQ(error_.record, record);
  };
  refused(to, -1.0, "", -1);
  flock_.limits[7].max_speed_mps = kNaN;
  refused(to, 0.1, "limits", 7);
  const Point nowhere{0.0, kNaN, 0.0};
  to.x = &nowhere.x;
  to.y = &nowhere.y;
  to.z = &nowhere.z;
  to.x_stride = to.y_stride = to.z_stride = 0;
  refused(to, 0.1, "goals", 0);
  to.count = 3;
  refused(to, 0.1, "goals", -1);
  EXPECT_EQ(beespace_velocity_to_goal(&positions, &positions, &limits, 0.1, nullptr, nullptr),
            BEESPACE_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace beespace::test
