// Invalid obstacles and queries: the error's code and sentence, and which of many obstacles it
// names.
#include "tests/obstacles/outlines.hpp"

#include <beespace/obstacle.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace beespace {
namespace {

using enum ErrorCode;
using test::Corners;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const double kTooLarge = std::nextafter(kLargestInMotion, kInfinity);
const double kTooSmall = std::nextafter(kSmallestInMotion, 0.0);

void expect_error(const Error& error, ErrorCode code, const std::string& words) {
  EXPECT_EQ(error.code, code) << error.message;
  EXPECT_NE(error.message.find(words), std::string::npos) << error.message;
}

// By each function that takes an obstacle; a map says which obstacle it is.
void expect_refused(const Obstacle& obstacle, ErrorCode code, const std::string& words) {
  const auto nearest = nearest_surface(obstacle, {});
  ASSERT_FALSE(nearest) << words;
  expect_error(nearest.error(), code, words);
  EXPECT_FALSE(nearest.error().location.record);
  const auto contact = first_contact_s(obstacle, {}, 1.0, 1.0);
  ASSERT_FALSE(contact) << words;
  expect_error(contact.error(), code, words);
  EXPECT_FALSE(contact.error().location.record);
  const auto map = ObstacleMap::of({Ground{0}, Sphere{{}, 1}, obstacle, Sphere{{}, -1}});
  ASSERT_FALSE(map) << words;
  expect_error(map.error(), code, words);
  EXPECT_EQ(map.error().location.record, 2U);
}

Obstacle prism(const Corners& outline) {
  return UprightPrism{outline, {}};
}

void expect_good(const Obstacle& obstacle) {
  const auto nearest = nearest_surface(obstacle, {1, 2, 3});
  EXPECT_TRUE(nearest) << nearest.error().message;
  EXPECT_TRUE(ObstacleMap::of({obstacle}));
}

TEST(ObstacleRefusals, OfNumbersThatAreNone) {
  for (const double none : {kNan, kInfinity, -kInfinity}) {
    expect_refused(Sphere{{1, none, 1}, 1}, kNotFinite, "the center y is ");
    expect_refused(Sphere{{}, none}, kNotFinite, "the radius is ");
    expect_refused(Box{{0, 0, none}, {1, 1, 1}}, kNotFinite, "the lowest corner z is ");
    expect_refused(Box{{0, 0, 0}, {none, 1, 1}}, kNotFinite, "the highest corner x is ");
    expect_refused(Ground{none}, kNotFinite, "the height is ");
    expect_refused(UprightCylinder{none, 0, 1, {}}, kNotFinite, "the axis x is ");
    expect_refused(UprightCylinder{0, none, 1, {}}, kNotFinite, "the axis y is ");
    expect_refused(UprightCylinder{0, 0, none, {}}, kNotFinite, "the radius is ");
    expect_refused(prism({{0, 0}, {1, 0}, {none, 1}}), kNotFinite, "corner 2 x is ");
    expect_refused(prism({{0, 0}, {1, none}, {1, 1}}), kNotFinite, "corner 1 y is ");
  }
  expect_refused(UprightCylinder{0, 0, 1, {kNan, 1}}, kNotFinite, "a height is nan; it must be");
  expect_refused(UprightPrism{test::square(), {0, kNan}}, kNotFinite, "a height is nan");
}

TEST(ObstacleRefusals, OfNumbersOutsideTheDomain) {
  for (const double outside : {kTooLarge, -kTooLarge, kTooSmall, -kTooSmall}) {
    expect_refused(Sphere{{outside, 1, 1}, 1}, kOutsideDomain, "the center x is ");
    expect_refused(Sphere{{}, outside}, kOutsideDomain, "outside the motion domain");
    expect_refused(Box{{0, 0, 0}, {1, outside, 1}}, kOutsideDomain, "the highest corner y is ");
    expect_refused(Ground{outside}, kOutsideDomain, "scale the units");
    expect_refused(UprightCylinder{0, outside, 1, {}}, kOutsideDomain, "the axis y is ");
    expect_refused(UprightCylinder{0, 0, 1, {outside, kInfinity}}, kOutsideDomain, "a height is ");
    expect_refused(prism({{0, 0}, {1, 0}, {outside, 1}}), kOutsideDomain, "corner 2 x is ");
    expect_refused(UprightPrism{test::square(), {-kInfinity, outside}}, kOutsideDomain,
                   "a height is ");
  }
  expect_good(Sphere{{kLargestInMotion, 0, kSmallestInMotion}, kLargestInMotion});
}

TEST(ObstacleRefusals, OfRadiiBelowZero) {
  expect_refused(Sphere{{}, -2}, kInvalidArgument, "the radius is -2 m; give zero or more");
  expect_refused(UprightCylinder{0, 0, -2, {}}, kInvalidArgument, "the radius is -2 m");
  expect_good(Sphere{{}, 0});
  expect_good(UprightCylinder{0, 0, 0, {}});
}

TEST(ObstacleRefusals, OfWhatIsUpsideDown) {
  expect_refused(Box{{1, 0, 0}, {0, 1, 1}}, kInvalidArgument,
                 "the box goes from x 1 m to 0 m; give the lowest corner first");
  expect_refused(Box{{0, 1, 0}, {1, 0, 1}}, kInvalidArgument, "from y 1 m to 0 m");
  expect_refused(Box{{0, 0, 1}, {1, 1, 0}}, kInvalidArgument, "from z 1 m to 0 m");
  expect_good(Box{{1, 2, 3}, {1, 2, 3}});
  const auto with = [](const Heights& heights) { return UprightCylinder{0, 0, 1, heights}; };
  expect_refused(with({5, 3}), kInvalidArgument, "the heights go from 5 m to 3 m; give a lower");
  expect_refused(with({3, 3}), kInvalidArgument, "the heights go from 3 m to 3 m");
  expect_refused(with({kInfinity, kInfinity}), kInvalidArgument, "the heights go from inf m");
  expect_refused(with({-kInfinity, -kInfinity}), kInvalidArgument, "the heights go from -inf m");
  expect_refused(with({kInfinity, -kInfinity}), kInvalidArgument, "the heights go from inf m");
  expect_refused(UprightPrism{test::square(), {1, 0}}, kInvalidArgument, "the heights go from 1 m");
  expect_good(with({3, kInfinity}));
  expect_good(with({-kInfinity, 3}));
}

TEST(ObstacleRefusals, OfOutlinesThatEncloseNothing) {
  expect_refused(prism({}), kInvalidArgument, "the outline has 0 corners; give three or more");
  expect_refused(prism({{1, 1}}), kInvalidArgument, "the outline has 1 corners");
  expect_refused(prism({{1, 1}, {2, 2}}), kInvalidArgument, "the outline has 2 corners");
  expect_refused(prism({{1, 1}, {2, 2}, {1, 1}}), kInvalidArgument, "the outline has 2 corners");
  expect_refused(prism({{0, 0}, {1, 1}, {5, 5}}), kInvalidArgument, "the outline encloses nothing");
  expect_refused(prism({{0, 0}, {1, 1}, {5, 5}, {2, 2}}), kInvalidArgument, "encloses nothing");
  expect_good(prism({{0, 0}, {1, 1}, {5, std::nextafter(5, 6)}}));
}

TEST(ObstacleRefusals, OfCornersGivenTwice) {
  expect_refused(prism({{0, 0}, {1, 0}, {1, 0}, {1, 1}}), kInvalidArgument,
                 "corners 1 and 2 of the outline are at one place; give it once");
  expect_refused(prism({{0, 0}, {0, 0}, {0, 0}, {0, 0}}), kInvalidArgument, "corners 0 and 1");
  // The last may be the first again; but once only.
  expect_good(prism({{0, 0}, {1, 0}, {1, 1}, {0, 0}}));
  expect_refused(prism({{0, 0}, {1, 0}, {1, 1}, {0, 0}, {0, 0}}), kInvalidArgument,
                 "corners 3 and 4");
}

TEST(ObstacleRefusals, OfOutlinesThatCrossThemselves) {
  expect_refused(prism({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), kInvalidArgument,
                 "the outline crosses or touches itself: its edges from corner 0 and from corner 2 "
                 "meet; give the corners in their order");
  expect_refused(prism({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), kInvalidArgument, "touches");
  Corners twice = test::letter_l();
  twice.insert(twice.begin() + 3, {4, 2});  // out of a straight wall and back
  twice.insert(twice.begin() + 3, {4, 3});
  expect_refused(prism(twice), kInvalidArgument, "touches itself");
}

TEST(ObstacleRefusals, OfPlacesAndFlights) {
  const Sphere good{{0, 0, 0}, 1};
  const auto place = nearest_surface(good, {0, kNan, 0});
  ASSERT_FALSE(place);
  expect_error(place.error(), kNotFinite, "position y is nan; it must be a finite number");
  const auto far = nearest_surface(good, {kTooLarge, 0, 0});
  ASSERT_FALSE(far);
  expect_error(far.error(), kOutsideDomain, "position x is ");

  const auto refused = [&](const Mover& ball, double radius, double horizon, ErrorCode code,
                           const std::string& words) {
    const auto contact = first_contact_s(good, ball, radius, horizon);
    ASSERT_FALSE(contact) << words;
    expect_error(contact.error(), code, words);
  };
  refused({{kInfinity, 0, 0}, {}}, 1, 1, kNotFinite, "position x is inf");
  refused({{}, {0, 0, kNan}}, 1, 1, kNotFinite, "velocity z is nan");
  refused({{}, {0, kTooSmall, 0}}, 1, 1, kOutsideDomain, "m/s, outside the motion domain");
  refused({}, -1, 1, kInvalidArgument, "the radius is -1 m; give zero or more");
  refused({}, kNan, 1, kNotFinite, "the radius is nan");
  refused({}, kTooLarge, 1, kOutsideDomain, "the radius is ");
  refused({}, 1, -1, kInvalidArgument, "the horizon is -1 s; give a finite time, zero or more");
  refused({}, 1, kInfinity, kInvalidArgument, "the horizon is inf s");
  refused({}, 1, kNan, kInvalidArgument, "the horizon is nan s");
  EXPECT_TRUE(first_contact_s(good, {}, 0, 0));
}

}  // namespace
}  // namespace beespace
