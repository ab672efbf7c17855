// What find_conflicts refuses: the error's code, place and sentence; and the position of a bee by
// its track.
#include <beespace/brute_force.hpp>
#include <beespace/find_conflicts.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const ConflictOptions kSome{.threshold_m = 100.0};
const std::vector<double> kNotFiniteValues = {kNan, kInfinity, -kInfinity};
const std::vector<double> kOutsideValues = {
    std::nextafter(kLargestInMotion, kInfinity), -std::nextafter(kLargestInMotion, kInfinity),
    std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};

using Tracks = std::vector<Track>;

Tracks plain_tracks() {
  Tracks tracks(5);
  for (std::size_t id = 0; id < tracks.size(); ++id) {
    if (id == 3) continue;  // never appears
    for (int i = 0; i < 4; ++i) tracks[id].fixes.push_back({1.0 * i, {1.0, 2.0, 3.0 * i}});
  }
  return tracks;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void expect_error(const Tracks& tracks, const ConflictOptions& options, ErrorCode code,
                  std::optional<std::uint64_t> record, const std::string& words) {
  for (const auto& found :
       {find_conflicts(tracks, options), brute_force::find_conflicts(tracks, options)}) {
    ASSERT_FALSE(found.has_value()) << words;
    EXPECT_EQ(found.error().code, code) << found.error().message;
    EXPECT_EQ(found.error().location.record, record) << found.error().message;
    EXPECT_TRUE(contains(found.error().message, words))
        << found.error().message << " lacks " << words;
  }
}

TEST(RecordingRefusal, InvalidThresholds) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity, 0x1p-101, 0x1.1p+100}) {
    SCOPED_TRACE(bad);
    ConflictOptions options;
    options.threshold_m = bad;
    expect_error(plain_tracks(), options, ErrorCode::kInvalidThreshold, {}, "the threshold is ");
    options.threshold_m = 1.0;
    options.vertical_m = bad;
    expect_error(plain_tracks(), options, ErrorCode::kInvalidThreshold, {},
                 "the vertical threshold is ");
  }
}

TEST(RecordingRefusal, AGapThatIsNotAboveZero) {
  for (const double bad : {0.0, -1.0, kNan, -kInfinity}) {
    ConflictOptions options{.threshold_m = 100.0};
    options.max_gap_s = bad;
    expect_error(plain_tracks(), options, ErrorCode::kInvalidArgument, {}, "gap");
  }
}

TEST(RecordingRefusal, AToleranceThatIsNegativeOrNotFinite) {
  for (const double bad : {-1.0, kNan, kInfinity, -kInfinity, 0x1.1p+100}) {
    Tracks tracks = plain_tracks();
    tracks[2].tolerance_m = bad;
    expect_error(tracks, kSome, ErrorCode::kInvalidArgument, 2, "tolerance");
  }
}

TEST(RecordingRefusal, NumbersThatAreNotFiniteOrOutsideTheDomainWithTheirTrackAndFix) {
  struct Field {
    const char* name;
    double& (*of)(Fix&);
  };
  const Field fields[] = {{"position x", [](Fix& fix) -> double& { return fix.position.x; }},
                          {"position y", [](Fix& fix) -> double& { return fix.position.y; }},
                          {"position z", [](Fix& fix) -> double& { return fix.position.z; }},
                          {"time", [](Fix& fix) -> double& { return fix.time_s; }}};
  for (const Field& field : fields) {
    for (const std::size_t record : {0U, 2U, 4U}) {
      for (const std::size_t fix : {0U, 3U}) {
        const std::string words = "fix " + std::to_string(fix) + ": " + field.name;
        Tracks tracks = plain_tracks();
        for (const double bad : kNotFiniteValues) {
          field.of(tracks[record].fixes[fix]) = bad;
          expect_error(tracks, kSome, ErrorCode::kNotFinite, record, words);
        }
        for (const double bad : kOutsideValues) {
          field.of(tracks[record].fixes[fix]) = bad;
          expect_error(tracks, kSome, ErrorCode::kOutsideDomain, record, words);
        }
      }
    }
  }
}

TEST(RecordingRefusal, TimesThatDoNotAscendWithTheirTrackAndFix) {
  for (const double bad : {1.0, 0.5, -7.0}) {
    Tracks tracks = plain_tracks();
    tracks[4].fixes[2].time_s = bad;
    expect_error(tracks, kSome, ErrorCode::kTimeOrder, 4, "fix 2: ");
  }
}

TEST(RecordingRefusal, HeightsOfTheWrongNumberOrOfSomeOrWithoutAQuestion) {
  ConflictOptions with_height{.threshold_m = 100.0};
  with_height.vertical_m = 10.0;
  Tracks all = plain_tracks();
  for (Track& track : all) track.heights_m.assign(track.fixes.size(), 7.0);
  EXPECT_TRUE(find_conflicts(all, with_height).has_value());
  expect_error(all, kSome, ErrorCode::kInvalidArgument, {}, "no vertical threshold");
  Tracks some = all;
  some[2].heights_m.clear();
  expect_error(some, with_height, ErrorCode::kInvalidArgument, 2, "some tracks have heights");
  Tracks few = all;
  few[1].heights_m.pop_back();
  expect_error(few, with_height, ErrorCode::kInvalidArgument, 1, "3 heights for 4 fixes");
  Tracks bad = all;
  bad[4].heights_m[1] = kNan;
  expect_error(bad, with_height, ErrorCode::kNotFinite, 4, "fix 1: height");
}

TEST(RecordingRefusal, OneResultMoreThanAllowed) {
  ConflictOptions options = kSome;  // all four with each other
  options.max_results = 6;
  EXPECT_EQ(find_conflicts(plain_tracks(), options).value().conflicts.size(), 6U);
  options.max_results = 5;
  expect_error(plain_tracks(), options, ErrorCode::kTooManyResults, {}, "more than 5");
}

TEST(RecordingRefusal, TheEndsOfTheDomainAreInsideIt) {
  for (const double value : {kSmallestInMotion, kLargestInMotion}) {
    for (const double sign : {-1.0, 1.0}) {
      const double v = sign * value;
      const Tracks tracks = {{{{-value, {v, v, v}}, {value, {-v, v, 0}}}},
                             {{{-value, {v, v, v}}, {0.0, {v, -v, v}}}, {}, value}};
      ConflictOptions options;
      options.threshold_m = value;
      options.vertical_m = value;
      const auto brute = brute_force::find_conflicts(tracks, options);
      ASSERT_TRUE(brute.has_value()) << brute.error().message;
      EXPECT_EQ(brute->conflicts.size(), 1U);
      EXPECT_EQ(find_conflicts(tracks, options).value().conflicts, brute->conflicts);
    }
  }
}

TEST(PositionAt, AFixIsThatFixAndInBetweenIsTheStraightLine) {
  const Track track{{{1.0, {1, 2, 3}}, {2.0, {5, 0, 3}}, {6.0, {5, 8, -1}}}};
  EXPECT_EQ(position_at(track, 1.0), (Point{1, 2, 3}));
  EXPECT_EQ(position_at(track, 1.25), (Point{2, 1.5, 3}));
  EXPECT_EQ(position_at(track, 2.0), (Point{5, 0, 3}));
  EXPECT_EQ(position_at(track, 5.0), (Point{5, 6, 0}));
  EXPECT_EQ(position_at(track, 6.0), (Point{5, 8, -1}));
}

TEST(PositionAt, ThereIsNoneBeforeTheFirstFixOrAfterTheLast) {
  const Track track{{{1.0, {1, 2, 3}}, {2.0, {5, 0, 3}}}};
  EXPECT_FALSE(position_at(track, std::nextafter(1.0, 0.0)).has_value());
  EXPECT_FALSE(position_at(track, std::nextafter(2.0, 3.0)).has_value());
  EXPECT_FALSE(position_at(track, kInfinity).has_value());
  EXPECT_FALSE(position_at(track, -kInfinity).has_value());
  EXPECT_FALSE(position_at(track, kNan).has_value());
  EXPECT_FALSE(position_at({}, 0.0).has_value());
  const Track instant{{{1.0, {1, 2, 3}}}};
  EXPECT_EQ(position_at(instant, 1.0), (Point{1, 2, 3}));
  EXPECT_FALSE(position_at(instant, 1.5).has_value());
}

TEST(PositionAt, ThereIsNoneInAGapExceptAtItsEnds) {
  const Track track{{{1.0, {1, 2, 3}}, {2.0, {5, 0, 3}}, {6.0, {5, 8, -1}}}};
  EXPECT_TRUE(position_at(track, 3.0, 4.0).has_value()) << "as long as allowed";
  const double less = std::nextafter(4.0, 0.0);
  EXPECT_FALSE(position_at(track, 3.0, less).has_value());
  EXPECT_TRUE(position_at(track, 2.0, less).has_value());
  EXPECT_TRUE(position_at(track, 6.0, less).has_value());
  EXPECT_TRUE(position_at(track, 1.5, less).has_value());
}

}  // namespace
}  // namespace beespace
