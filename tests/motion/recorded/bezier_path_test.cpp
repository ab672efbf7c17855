// Curves as tracks: within the stated tolerance of the curve, with no more fixes than needed, and
// without missing a violation of the curves.
#include "tests/support/conflict_printer.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/mover.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace beespace {
namespace {

using Number = long double;
using ErrorLocation = std::array<Number, 3>;

ErrorLocation place_of(const Point& p) {
  return {p.x, p.y, p.z};
}

Number distance(const ErrorLocation& a, const ErrorLocation& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::vector<ErrorLocation> controls_of(const BezierPath& path, std::size_t piece) {
  std::vector<ErrorLocation> points{place_of(piece == 0 ? path.begin : path.pieces[piece - 1].end)};
  for (unsigned k = 0; k < path.pieces[piece].control_count; ++k) {
    points.push_back(place_of(path.pieces[piece].controls[k]));
  }
  points.push_back(place_of(path.pieces[piece].end));
  return points;
}

// The sum of Bernstein polynomials, in long doubles.
ErrorLocation curve_at(const BezierPath& path, double time_s) {
  std::size_t piece = 0;
  while (piece + 1 < path.pieces.size() && path.pieces[piece].ends_s < time_s) ++piece;
  const Number begins = piece == 0 ? path.begins_s : path.pieces[piece - 1].ends_s;
  const Number share = (time_s - begins) / (path.pieces[piece].ends_s - begins);
  const std::vector<ErrorLocation> points = controls_of(path, piece);
  const auto degree = static_cast<int>(points.size()) - 1;
  ErrorLocation sum{};
  Number binomial = 1;
  for (int k = 0; k <= degree; ++k) {
    const Number weight = binomial * std::pow(share, k) * std::pow(1 - share, degree - k);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum[axis] += weight * points[static_cast<std::size_t>(k)][axis];
    }
    binomial = binomial * (degree - k) / (k + 1);
  }
  return sum;
}

// How many fixes all pieces need whose chords stay within a tolerance by second differences.
std::size_t enough_fixes(const BezierPath& path, double tolerance_m) {
  Number fixes = 1;
  for (std::size_t piece = 0; piece < path.pieces.size(); ++piece) {
    const std::vector<ErrorLocation> p = controls_of(path, piece);
    Number most = 0;
    for (std::size_t k = 0; k + 2 < p.size(); ++k) {
      ErrorLocation second;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        second[axis] = p[k][axis] - 2 * p[k + 1][axis] + p[k + 2][axis];
      }
      most = std::max(most, distance(second, {}));
    }
    const auto degree = static_cast<Number>(p.size() - 1);
    fixes += std::sqrt(degree * (degree - 1) / 8 * most / tolerance_m) + 1;
  }
  return static_cast<std::size_t>(fixes);
}

BezierPath random_path(test::SceneMaker& make, std::size_t pieces, double size, double begins_s) {
  const auto place = [&] { return make.ragged_box(1, {0, 0, 0}, {size, size, 0.3 * size})[0]; };
  BezierPath path{begins_s, place(), {}};
  double time = begins_s;
  for (std::size_t i = 0; i < pieces; ++i) {
    time += make.between(0.5, 4.0);
    path.pieces.push_back({time,
                           place(),
                           {place(), place()},
                           static_cast<std::uint8_t>(make.below(4) == 0 ? 0 : 1 + make.below(2))});
  }
  return path;
}

TEST(BezierTrack, IsNowhereFartherFromTheCurveThanItsTolerance) {
  test::SceneMaker make(1962);
  for (const double tolerance_m : {1.0, 0.1, 1e-3, 1e-5}) {
    for (const double begins_s : {0.0, -5.0, 1.6e9}) {
      if (begins_s > 1.0 && tolerance_m < 1e-2) continue;  // too fine for clocks that coarse
      Number farthest = 0;
      for (int round = 0; round < test::rounds(20); ++round) {
        const BezierPath path = random_path(make, 4, 80.0, begins_s);
        const Result<Track> track = to_track(path, tolerance_m);
        ASSERT_TRUE(track.has_value()) << track.error().message;
        ASSERT_LT(track->tolerance_m, tolerance_m);
        ASSERT_LE(track->fixes.size(), 2 * enough_fixes(path, tolerance_m));
        const double lasts = path.pieces.back().ends_s - begins_s;
        for (int sample = 0; sample < 500; ++sample) {
          const double time = begins_s + make.between(0, 1) * lasts;
          const auto at = position_at(*track, time);
          ASSERT_TRUE(at.has_value());
          const Number off = distance(place_of(*at), curve_at(path, time));
          ASSERT_LE(off, track->tolerance_m + 1e-12) << time << " s, tolerance " << tolerance_m;
          farthest = std::max(farthest, off);
        }
      }
      EXPECT_TRUE(test::kSanitized || farthest > 0.3 * tolerance_m) << "more fixes than it takes";
    }
  }
}

TEST(BezierTrack, OfStraightPiecesIsTheirEndsExactly) {
  BezierPath path{1.0, {0, 0, 0}, {}};
  path.pieces.push_back({2.0, {3, 4, 5}, {}, 0});
  path.pieces.push_back({4.0, {3, 4, 9}, {{{1e9, 1, 1}, {1, 1e9, 1}}}, 0});  // of which none counts
  path.pieces.push_back({7.0, {0, 4, 12}, {{{2, 4, 10}, {1, 4, 11}}}, 2});   // even steps: straight
  const Result<Track> track = to_track(path, 1e-9);
  ASSERT_TRUE(track.has_value()) << track.error().message;
  EXPECT_EQ(track->tolerance_m, 0.0);
  EXPECT_TRUE(track->heights_m.empty());
  EXPECT_EQ(
      track->fixes,
      (std::vector<Fix>{{1.0, {0, 0, 0}}, {2.0, {3, 4, 5}}, {4.0, {3, 4, 9}}, {7.0, {0, 4, 12}}}));
  const Result<Track> nothing = to_track({3.0, {1, 2, 3}, {}});
  ASSERT_TRUE(nothing.has_value());
  EXPECT_EQ(nothing->fixes, (std::vector<Fix>{{3.0, {1, 2, 3}}}));
}

// Straight, but not evenly: where it is when is a curve.
TEST(BezierTrack, OfALineThatIsNotFlownEvenlyKeepsTheTimes) {
  const BezierPath path{0.0, {0, 0, 0}, {{10.0, {100, 0, 0}, {{{100, 0, 0}}}, 1}}};
  const Result<Track> track = to_track(path, 0.01);
  ASSERT_TRUE(track.has_value());
  EXPECT_GT(track->fixes.size(), 10U);
  EXPECT_NEAR(position_at(*track, 5.0)->x, 75.0, 0.01);
}

TEST(BezierTrack, BeginsAndEndsItsPiecesWhereTheyDo) {
  test::SceneMaker make(77);
  const BezierPath path = random_path(make, 6, 80.0, 3.0);
  const Track track = *to_track(path, 0.5);
  EXPECT_EQ(track.fixes.front(), (Fix{path.begins_s, path.begin}));
  EXPECT_EQ(track.fixes.back(), (Fix{path.pieces.back().ends_s, path.pieces.back().end}));
  for (const BezierPiece& piece : path.pieces) {
    EXPECT_EQ(std::count(track.fixes.begin(), track.fixes.end(), Fix{piece.ends_s, piece.end}), 1);
  }
}

// Positions on the curves at many instants, compared with their tracks.
TEST(BezierConflicts, MissNoViolationAndAreCertainOfNoneThatIsNotThere) {
  test::SceneMaker make(40320);
  constexpr double kThreshold = 12.0;
  std::size_t violations = 0;
  std::size_t certain = 0;
  std::size_t possible = 0;
  for (int round = 0; round < test::rounds(300); ++round) {
    SCOPED_TRACE(round);
    const BezierPath paths[] = {random_path(make, 3, 60.0, 0.0), random_path(make, 3, 60.0, 0.0)};
    const double tolerance_m = round % 3 == 0 ? 0.02 : 2.0;
    const std::vector<Track> tracks = {*to_track(paths[0], tolerance_m),
                                       *to_track(paths[1], tolerance_m)};
    ConflictOptions options;
    options.threshold_m = kThreshold;
    const std::vector<Conflict> found = find_conflicts(tracks, options).value().conflicts;
    const double ends = std::min(paths[0].pieces.back().ends_s, paths[1].pieces.back().ends_s);
    std::vector<Number> least(found.size(), std::numeric_limits<Number>::infinity());
    constexpr int kSamples = 1000;
    for (int sample = 0; sample <= kSamples; ++sample) {
      const double time = ends * sample / kSamples;
      const Number apart = distance(curve_at(paths[0], time), curve_at(paths[1], time));
      bool said = false;
      for (std::size_t k = 0; k < found.size(); ++k) {
        if (time < found[k].begins_s - 1e-9 || time > found[k].ends_s + 1e-9) continue;
        said = true;
        least[k] = std::min(least[k], apart);
      }
      if (apart >= kThreshold - 1e-9) continue;
      ++violations;
      ASSERT_TRUE(said) << "at " << time << " s they are at " << apart << " m";
    }
    // No faster than 3 times the longest move between control points, in half a second: each.
    const Number unseen = 2.0L * 3.0L * 110.0L / 0.5L * (ends / kSamples);
    for (std::size_t k = 0; k < found.size(); ++k) {
      (found[k].certain ? certain : possible) += 1;
      // Certain is only what is there; not certain, only what is not too close by all tolerances.
      if (found[k].certain) {
        ASSERT_LT(least[k], kThreshold + unseen);
      } else {
        ASSERT_GT(least[k], kThreshold - 4.0 * tolerance_m - 1e-9);
      }
    }
  }
  EXPECT_GT(violations, static_cast<std::size_t>(test::rounds(10'000)));
  EXPECT_GT(certain, static_cast<std::size_t>(test::rounds(100)));
  EXPECT_GT(possible, static_cast<std::size_t>(test::rounds(5)));
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

BezierPath plain_path() {
  return {0.0,
          {0, 0, 0},
          {{1.0, {1, 0, 0}, {{{1, 5, 0}, {2, 5, 0}}}, 2},
           {2.0, {2, 0, 0}, {{{1, -5, 0}, {2, 5, 0}}}, 2}}};
}

void expect_error(const BezierPath& path, ErrorCode code, std::optional<std::uint64_t> record,
                  double tolerance_m = 0.1) {
  const Result<Track> track = to_track(path, tolerance_m);
  ASSERT_FALSE(track.has_value());
  EXPECT_EQ(track.error().code, code) << track.error().message;
  EXPECT_EQ(track.error().location.record, record) << track.error().message;
  EXPECT_FALSE(track.error().message.empty());
}

TEST(BezierRefusal, AnInvalidOrTooFineTolerance) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity}) {
    expect_error(plain_path(), ErrorCode::kInvalidArgument, {}, bad);
  }
  expect_error(plain_path(), ErrorCode::kInvalidArgument, 0, 1e-14);
  BezierPath path = plain_path();
  path.begins_s = 1.6e9;
  path.pieces[0] = {1.6e9 + 1.0, {1, 0, 0}, {}, 0};
  path.pieces[1].ends_s = 1.6e9 + 2.0;
  expect_error(path, ErrorCode::kInvalidArgument, 1, 1e-6);  // by the clock
}

TEST(BezierRefusal, MoreControlPointsThanTwo) {
  BezierPath path = plain_path();
  path.pieces[1].control_count = 3;
  expect_error(path, ErrorCode::kInvalidArgument, 1);
}

TEST(BezierRefusal, TimesThatDoNotAscend) {
  for (const double bad : {1.0, 0.5, -3.0}) {
    BezierPath path = plain_path();
    path.pieces[1].ends_s = bad;
    expect_error(path, ErrorCode::kTimeOrder, 1);
  }
  BezierPath path = plain_path();
  path.begins_s = 1.0;
  expect_error(path, ErrorCode::kTimeOrder, 0);
}

TEST(BezierRefusal, NumbersThatAreNotFiniteOrOutsideTheDomain) {
  for (const double bad : {kNan, kInfinity, -kInfinity, 0x1.1p+100, 0x1p-101}) {
    const ErrorCode code = std::isfinite(bad) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite;
    double BezierPiece::*const time = &BezierPiece::ends_s;
    BezierPath path = plain_path();
    path.pieces[1].*time = bad;
    expect_error(path, code, 1);
    path = plain_path();
    path.pieces[1].end.y = bad;
    expect_error(path, code, 1);
    path = plain_path();
    path.pieces[1].controls[1].z = bad;
    expect_error(path, code, 1);
    path.pieces[1].control_count = 1;  // then it does not count
    EXPECT_TRUE(to_track(path, 0.1).has_value());
    path = plain_path();
    path.begin.x = bad;
    expect_error(path, code, 0);
    path = plain_path();
    path.begins_s = bad;
    expect_error(path, code, 0);
  }
}

}  // namespace
}  // namespace beespace
