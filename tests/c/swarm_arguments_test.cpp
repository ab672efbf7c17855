// What callers of C can get wrong with a swarm becomes a code, a place and a message, and what they
// have told before stays as it was.
#include "tests/c/c_swarms.hpp"

#include <beespace.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

CReport report_at(std::int64_t id, double time_s, double x) {
  return {id, time_s, {x, 0, 0}, {kNan, kNan, kNan}, 0.0, 0.0};
}

class CSwarmArguments : public testing::Test {
 protected:
  void SetUp() override { begin(); }
  void begin() {
    beespace_swarm* made = nullptr;
    ASSERT_EQ(beespace_swarm_create(&options_, &made, &error_), BEESPACE_OK) << error_.message;
    swarm_.reset(made);
  }
  void expect_no_swarm(beespace_code expected, const std::string& words) {
    auto* made = reinterpret_cast<beespace_swarm*>(this);
    error_ = c_error();
    EXPECT_EQ(beespace_swarm_create(&options_, &made, &error_), expected) << words;
    EXPECT_EQ(made, nullptr);
    EXPECT_STREQ(error_.place, "options");
    EXPECT_NE(std::string(error_.message).find(words), std::string::npos) << error_.message;
    options_ = c_swarm_options(5.0);
  }
  beespace_code tell(const beespace_fixes& fixes, const beespace_points& positions,
                     const beespace_points* velocities = nullptr) {
    refused_ = -2;
    error_ = c_error();
    return beespace_swarm_update(swarm_.get(), &fixes, &positions, velocities, &refused_, &error_);
  }
  void expect_none_taken(beespace_code code, const std::string& place) {
    EXPECT_EQ(code, BEESPACE_INVALID_ARGUMENT) << place;
    EXPECT_EQ(refused_, -1);
    EXPECT_EQ(error_.place, place);
    EXPECT_EQ(counts().taken, 0U);
  }
  beespace_counts counts() {
    beespace_counts counts{};
    counts.struct_size = sizeof counts;
    EXPECT_EQ(beespace_swarm_counts(swarm_.get(), &counts, nullptr), BEESPACE_OK);
    return counts;
  }

  beespace_swarm_options options_ = c_swarm_options(5.0);
  Owned<beespace_swarm> swarm_;
  Owned<beespace_events> events_{beespace_events_create()};
  Owned<beespace_movers> movers_{beespace_movers_create()};
  std::int64_t refused_ = 0;
  beespace_error error_ = c_error();
  std::vector<CReport> reports_ = {report_at(-1, 0, 0), report_at(7, 0, 3), report_at(8, 0, 100)};
};

TEST_F(CSwarmArguments, OptionsThatMakeNoSenseAreRefused) {
  for (const double threshold_m : {0.0, -1.0, kNan, kInfinity}) {
    options_.threshold_m = threshold_m;
    expect_no_swarm(BEESPACE_INVALID_THRESHOLD, "threshold");
  }
  options_.leave_factor = 0.5;
  expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "leave_factor");
  options_.max_age_s = -1.0;
  expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "max_age_s");
  options_.horizon_s = 1.0;
  expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "without its flag");
  options_.vertical_m = kNan;
  expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "without its flag");
  options_.max_speed_mps = 1.0;
  expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "without its flag");
  options_.flags = BEESPACE_SWARM_VERTICAL;
  expect_no_swarm(BEESPACE_INVALID_THRESHOLD, "vertical");
  options_.flags = BEESPACE_SWARM_HEIGHTS_APART;
  expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "no vertical threshold");
  options_.flags = 16;
  expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "flags");
  options_.reserved = 1;
  expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "reserved");
  for (const std::size_t size : {std::size_t{0}, sizeof options_ - 8, std::size_t{5000}}) {
    options_.struct_size = size;
    expect_no_swarm(BEESPACE_INVALID_ARGUMENT, "struct_size");
  }
  EXPECT_EQ(beespace_swarm_create(&options_, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);
  beespace_swarm* made = nullptr;
  EXPECT_EQ(beespace_swarm_create(nullptr, &made, nullptr), BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CSwarmArguments, NullsAreRefused) {
  const CReports given(reports_, false);
  const beespace_fixes* const fixes = &given.fixes;
  const beespace_points* const places = &given.positions;
  constexpr beespace_code kRefused = BEESPACE_INVALID_ARGUMENT;
  EXPECT_EQ(beespace_swarm_update(nullptr, fixes, places, nullptr, nullptr, nullptr), kRefused);
  beespace_swarm* const swarm = swarm_.get();
  EXPECT_EQ(beespace_swarm_update(swarm, nullptr, places, nullptr, &refused_, nullptr), kRefused);
  EXPECT_EQ(refused_, -1);
  EXPECT_EQ(beespace_swarm_update(swarm, fixes, nullptr, nullptr, nullptr, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_remove(nullptr, nullptr, 0, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_remove(swarm, nullptr, 1, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_remove(swarm, &reports_[0].id, -1, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_remove(swarm, nullptr, 0, nullptr), BEESPACE_OK);
  EXPECT_EQ(beespace_swarm_lose(swarm, nullptr, 1, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_advance(nullptr, 0.0, events_.get(), nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_advance(swarm, 0.0, nullptr, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_finish(swarm, 0.0, nullptr, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_begin_anew(swarm, 0.0, 0.0, nullptr, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_counts(swarm, nullptr, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_movers(swarm, 0.0, nullptr, nullptr), kRefused);
  EXPECT_EQ(beespace_swarm_movers(nullptr, 0.0, movers_.get(), nullptr), kRefused);
  EXPECT_EQ(beespace_events_size(nullptr), 0);
  EXPECT_EQ(beespace_events_kinds(nullptr), nullptr);
  EXPECT_EQ(beespace_movers_size(nullptr), 0);
  EXPECT_EQ(beespace_movers_ids(nullptr), nullptr);
  beespace_swarm_free(nullptr);
  beespace_events_free(nullptr);
  beespace_movers_free(nullptr);
}

TEST_F(CSwarmArguments, ColumnsThatCannotBeReadTakeNothing) {
  const CReports good(reports_, false);
  CReports given = good;
  given.fixes.agents = nullptr;
  expect_none_taken(tell(given.fixes, given.positions), "agents");
  given = good;
  given.fixes.times_stride = 3;
  expect_none_taken(tell(given.fixes, given.positions), "times");
  given = good;
  given.fixes.agents_stride = std::numeric_limits<std::ptrdiff_t>::max() - 7;
  expect_none_taken(tell(given.fixes, given.positions), "agents");
  given = good;
  given.fixes.struct_size = 48;
  expect_none_taken(tell(given.fixes, given.positions), "fixes");
  given = good;
  given.fixes.heights_m = &reports_[0].height;
  expect_none_taken(tell(given.fixes, given.positions), "heights");
  given = good;
  given.fixes.climbs_mps = &reports_[0].climb;
  expect_none_taken(tell(given.fixes, given.positions), "heights");
  given = good;
  given.fixes.height_unit_m = 1.0;
  expect_none_taken(tell(given.fixes, given.positions), "reports");
  given = good;
  given.velocities.count = 2;
  expect_none_taken(tell(given.fixes, given.positions, &given.velocities), "velocities");
  given = good;
  given.velocities.type = 7;
  expect_none_taken(tell(given.fixes, given.positions, &given.velocities), "velocities");
}

TEST_F(CSwarmArguments, HeightsThatAreApartMustBeGiven) {
  options_.flags = BEESPACE_SWARM_VERTICAL | BEESPACE_SWARM_HEIGHTS_APART;
  options_.vertical_m = 2.0;
  begin();
  CReports given(reports_, false);
  expect_none_taken(tell(given.fixes, given.positions), "heights");
  given = CReports(reports_, true);
  given.fixes.heights_stride = 2;
  expect_none_taken(tell(given.fixes, given.positions), "heights");
  given = CReports(reports_, true);
  given.fixes.climbs_mps = nullptr;  // all fly level
  EXPECT_EQ(tell(given.fixes, given.positions), BEESPACE_OK) << error_.message;
  reports_[1].time_s = 1.0;
  reports_[1].climb = kInfinity;
  EXPECT_EQ(tell(CReports(reports_, true).fixes, given.positions), BEESPACE_NOT_FINITE);
  EXPECT_STREQ(error_.place, "climbs");
  reports_[1].climb = 0.0;
  reports_[1].height = 1e31;
  EXPECT_EQ(tell(CReports(reports_, true).fixes, given.positions), BEESPACE_OUTSIDE_DOMAIN);
  EXPECT_STREQ(error_.place, "heights");
}

TEST_F(CSwarmArguments, AReportThatCannotBeIsNamedAndTheOthersCount) {
  struct Bad {
    void (*spoil)(CReport&);
    beespace_code code;
    const char* place;
  };
  const std::array<Bad, 6> bad = {
      Bad{[](CReport& r) { r.position.y = kNan; }, BEESPACE_NOT_FINITE, "positions"},
      Bad{[](CReport& r) { r.position.z = -1e31; }, BEESPACE_OUTSIDE_DOMAIN, "positions"},
      Bad{[](CReport& r) { r.time_s = kInfinity; }, BEESPACE_NOT_FINITE, "times"},
      Bad{[](CReport& r) { r.time_s = 1e31; }, BEESPACE_OUTSIDE_DOMAIN, "times"},
      Bad{[](CReport& r) { r.velocity[0] = 1.0; }, BEESPACE_NOT_FINITE, "velocities"},
      Bad{[](CReport& r) { r.velocity[0] = r.velocity[1] = r.velocity[2] = 1e31; },
          BEESPACE_OUTSIDE_DOMAIN, "velocities"}};
  for (const Bad& each : bad) {
    begin();
    std::vector<CReport> reports = reports_;
    each.spoil(reports[1]);
    reports.push_back(reports[1]);
    const CReports given(reports, false);
    EXPECT_EQ(tell(given.fixes, given.positions, &given.velocities), each.code);
    EXPECT_EQ(refused_, 2);
    EXPECT_STREQ(error_.place, each.place);
    EXPECT_EQ(error_.record, 1);
    EXPECT_EQ(counts().taken, 2U);
  }
}

TEST_F(CSwarmArguments, TimesThatGoBackLeaveNoEvents) {
  const CReports given(reports_, false);
  ASSERT_EQ(tell(given.fixes, given.positions), BEESPACE_OK);
  ASSERT_EQ(beespace_swarm_advance(swarm_.get(), 20.0, events_.get(), &error_), BEESPACE_OK);
  EXPECT_GT(beespace_events_size(events_.get()), 0);  // they are stale
  EXPECT_EQ(beespace_swarm_advance(swarm_.get(), 19.0, events_.get(), &error_),
            BEESPACE_TIME_ORDER);
  EXPECT_EQ(beespace_events_size(events_.get()), 0);
  EXPECT_EQ(beespace_events_kinds(events_.get()), nullptr);
  EXPECT_EQ(beespace_swarm_advance(swarm_.get(), kNan, events_.get(), &error_),
            BEESPACE_NOT_FINITE);
  EXPECT_EQ(beespace_swarm_begin_anew(swarm_.get(), 21.0, 1e31, events_.get(), &error_),
            BEESPACE_OUTSIDE_DOMAIN);
  ASSERT_EQ(beespace_swarm_movers(swarm_.get(), 20.0, movers_.get(), &error_), BEESPACE_OK);
  EXPECT_EQ(beespace_movers_size(movers_.get()), 3);
  EXPECT_EQ(beespace_swarm_movers(swarm_.get(), kNan, movers_.get(), &error_), BEESPACE_NOT_FINITE);
  EXPECT_EQ(beespace_movers_size(movers_.get()), 0);
  EXPECT_EQ(beespace_swarm_movers(swarm_.get(), 1e31, movers_.get(), &error_),
            BEESPACE_OUTSIDE_DOMAIN);
  EXPECT_STREQ(error_.place, "time");
}

TEST_F(CSwarmArguments, CountsOfAnUnknownSizeAreLeftAsTheyWere) {
  beespace_counts counts{};
  for (const std::size_t size : {std::size_t{0}, sizeof counts - 8, std::size_t{5000}}) {
    counts.struct_size = size;
    counts.taken = 99;
    EXPECT_EQ(beespace_swarm_counts(swarm_.get(), &counts, &error_), BEESPACE_INVALID_ARGUMENT);
    EXPECT_EQ(counts.taken, 99U);
  }
}

// Floats, planes, and columns that go backwards or stand still.
TEST_F(CSwarmArguments, LayoutsOfAllKindsAreRead) {
  const std::array<float, 4> xy = {1.5F, 2.5F, 3.5F, 4.5F};
  const std::array<std::int64_t, 2> ids = {20, 10};
  const double time_s = 1.0;
  beespace_points places{};
  places.struct_size = sizeof places;
  places.type = BEESPACE_FLOAT32;
  places.count = 2;
  places.x = xy.data();
  places.y = xy.data() + 1;
  places.x_stride = places.y_stride = 2 * sizeof(float);
  const std::array<float, 4> unknown_first = {std::numeric_limits<float>::quiet_NaN(),
                                              std::numeric_limits<float>::quiet_NaN(), 1.0F, 2.0F};
  beespace_points speeds = places;
  speeds.x = unknown_first.data();
  speeds.y = unknown_first.data() + 1;
  beespace_fixes fixes{};
  fixes.struct_size = sizeof fixes;
  fixes.agents = ids.data() + 1;
  fixes.agents_stride = -static_cast<std::ptrdiff_t>(sizeof(std::int64_t));
  fixes.times_s = &time_s;
  ASSERT_EQ(tell(fixes, places, &speeds), BEESPACE_OK) << error_.message;
  ASSERT_EQ(beespace_swarm_movers(swarm_.get(), 2.0, movers_.get(), &error_), BEESPACE_OK);
  ASSERT_EQ(beespace_movers_size(movers_.get()), 2);
  EXPECT_EQ(beespace_movers_ids(movers_.get())[0], 10);
  EXPECT_EQ(beespace_movers_move(movers_.get())[0], 0);
  EXPECT_EQ(beespace_movers_positions(movers_.get())[0], 1.5);
  EXPECT_EQ(beespace_movers_move(movers_.get())[1], 1);
  EXPECT_EQ(beespace_movers_positions(movers_.get())[3], 4.5);
  EXPECT_EQ(beespace_movers_positions(movers_.get())[4], 6.5);
}

}  // namespace
}  // namespace beespace::test
