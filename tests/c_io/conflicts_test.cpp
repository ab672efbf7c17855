// Conflicts of recordings for C, and of how much it is known where agents were.
#include "tests/c_io/test_file.hpp"

#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace beespace::test {
namespace {

struct FreeConflicts {
  void operator()(beespace_io_conflicts* conflicts) const { beespace_io_conflicts_free(conflicts); }
};

struct Found {
  std::unique_ptr<beespace_io_conflicts, FreeConflicts> conflicts;
  beespace_code code = BEESPACE_OK;
  beespace_io_error error = io_error();
  beespace_io_conflict_facts facts{};
  beespace_io_coverage coverage{};
};

beespace_io_conflict_options within(double threshold_m) {
  beespace_io_conflict_options options{};
  options.struct_size = sizeof options;
  options.threshold_m = threshold_m;
  return options;
}

Found find(const Recording& recording, const beespace_io_conflict_options* options) {
  Found found;
  beespace_io_conflicts* conflicts = nullptr;
  found.code = beespace_io_find_conflicts(recording.get(), options, &conflicts, &found.error);
  found.conflicts.reset(conflicts);
  found.facts.struct_size = sizeof found.facts;
  found.coverage.struct_size = sizeof found.coverage;
  if (conflicts == nullptr) return found;
  EXPECT_EQ(beespace_io_conflicts_facts_of(conflicts, &found.facts, nullptr), BEESPACE_OK);
  EXPECT_EQ(beespace_io_conflicts_coverage(conflicts, &found.coverage, nullptr), BEESPACE_OK);
  return found;
}

std::string unknown_in(const beespace_io_coverage& coverage) {
  std::string text(beespace_io_coverage_text(&coverage, nullptr, 0) + 1, ' ');
  beespace_io_coverage_text(&coverage, text.data(), text.size());
  return text.substr(0, text.size() - 1);
}

class CIoConflicts : public testing::Test {
 protected:
  [[nodiscard]] Recording table(const std::string& text,
                                const beespace_io_options* options = nullptr) const {
    auto read = read_recording({folder_.file("flight.csv", text)}, options);
    EXPECT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    return std::move(read.recording);
  }

  TestFolder folder_;
};

constexpr const char* kHeader = "id,time_s,x [m],y [m],z [m]\n";

// One passes 3 m beside the other, half way between two fixes.
TEST_F(CIoConflicts, StandInColumns) {
  const Recording flight =
      table(std::string(kHeader) + "a,0,0,0,0\na,10,100,0,0\nb,0,100,3,0\nb,10,0,3,0\n");
  const auto options = within(5.0);
  const Found found = find(flight, &options);
  ASSERT_EQ(found.code, BEESPACE_OK) << text_of(found.error);
  const auto* const c = found.conflicts.get();
  ASSERT_EQ(beespace_io_conflicts_size(c), 1);
  EXPECT_EQ(beespace_io_conflicts_first(c)[0], 0);
  EXPECT_EQ(beespace_io_conflicts_second(c)[0], 1);
  EXPECT_NEAR(beespace_io_conflicts_begins_s(c)[0], 4.8, 1e-9);
  EXPECT_NEAR(beespace_io_conflicts_ends_s(c)[0], 5.2, 1e-9);
  EXPECT_NEAR(beespace_io_conflicts_closest_s(c)[0], 5.0, 1e-9);
  EXPECT_NEAR(beespace_io_conflicts_closest_m(c)[0], 3.0, 1e-9);
  EXPECT_EQ(beespace_io_conflicts_certain(c)[0], 1);
  EXPECT_EQ(found.facts.risky, 1);
  EXPECT_EQ(found.facts.threshold_m, 5.0);
  EXPECT_EQ(found.coverage.complete, 1);
  EXPECT_EQ(unknown_in(found.coverage), "");
  const auto near = within(2.0);
  const Found none = find(flight, &near);
  EXPECT_EQ(none.facts.risky, 0);
  EXPECT_EQ(beespace_io_conflicts_first(none.conflicts.get()), nullptr);
  EXPECT_NEAR(none.facts.closest_m, 3.0, 1e-9);
}

TEST_F(CIoConflicts, WhatIsUnknownIsNoAllClear) {
  const Recording flight =
      table(std::string(kHeader) +
            "a,0,0,0,0\na,1,1,0,0\na,2,2,0,0\na,3,3,0,0\na,30,9,0,0\nb,0,0,90,0\nb,1,0,90,0\n"
            "b,2,0,90,0\nb,30,0,90,0\n");
  const auto options = within(2.0);
  const Found found = find(flight, &options);
  ASSERT_EQ(found.code, BEESPACE_OK) << text_of(found.error);
  const auto* const c = found.conflicts.get();
  EXPECT_EQ(beespace_io_conflicts_size(c), 0);
  EXPECT_EQ(found.facts.risky, 1);
  EXPECT_EQ(found.coverage.may_hide, 1);
  EXPECT_EQ(found.coverage.gaps, 2);
  EXPECT_EQ(found.coverage.max_gap_s, 5.0);
  EXPECT_EQ(found.coverage.typical_interval_s, 1.0);
  EXPECT_EQ(unknown_in(found.coverage), "2 bees unknown for 55 s in all");
  ASSERT_EQ(beespace_io_conflicts_gaps(c), 2);
  EXPECT_EQ(beespace_io_conflicts_gap_agent(c)[1], 1);
  EXPECT_EQ(beespace_io_conflicts_gap_begins_s(c)[0], 3.0);
  EXPECT_EQ(beespace_io_conflicts_gap_ends_s(c)[0], 30.0);
  auto joined = options;
  joined.max_gap_s = INFINITY;
  EXPECT_EQ(find(flight, &joined).facts.risky, 0);
  beespace_io_coverage coverage{};
  coverage.struct_size = sizeof coverage;
  EXPECT_EQ(beespace_io_recording_coverage(flight.get(), 0.0, &coverage, nullptr), BEESPACE_OK);
  EXPECT_EQ(coverage.gaps, 2);
  EXPECT_EQ(beespace_io_recording_coverage(flight.get(), INFINITY, &coverage, nullptr),
            BEESPACE_OK);
  EXPECT_EQ(coverage.complete, 1);
  EXPECT_EQ(beespace_io_recording_coverage(flight.get(), -1.0, &coverage, nullptr),
            BEESPACE_INVALID_ARGUMENT);
}

// The curve of the first leads it over to the second's side, 9.5 m of the 10.
TEST_F(CIoConflicts, VelocitiesAreLookedAt) {
  const Recording flight = table(
      "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,10,1,3.8,0\na,10,10,0,10,1,-3.8,0\nb,0,0,10,10,1,0,0\n"
      "b,10,10,10,10,1,0,0\n");
  auto options = within(2.0);
  const Found found = find(flight, &options);
  ASSERT_EQ(found.code, BEESPACE_OK) << text_of(found.error);
  EXPECT_EQ(beespace_io_conflicts_size(found.conflicts.get()), 1);
  EXPECT_EQ(beespace_io_conflicts_certain(found.conflicts.get())[0], 0);
  EXPECT_EQ(found.facts.possible, 1);
  EXPECT_EQ(found.facts.velocities, 1);
  EXPECT_GE(found.facts.most_off_m, 9.5);
  EXPECT_LE(found.facts.most_off_m, 12.0);
  options.flags = BEESPACE_IO_ALONG_LINES;
  EXPECT_EQ(find(flight, &options).facts.risky, 0);
  options.flags = 0;
  options.vertical = "1ft";
  EXPECT_EQ(beespace_io_conflicts_size(find(flight, &options).conflicts.get()), 1);
}

TEST_F(CIoConflicts, NothingComparedIsNoAllClear) {
  const Recording flight =
      table(std::string(kHeader) + "a,0,0,0,0\na,1,0,0,0\nb,2,9,0,0\nb,3,9,0,0\n");
  const auto options = within(2.0);
  const Found found = find(flight, &options);
  EXPECT_EQ(found.facts.compared, 0);
  EXPECT_EQ(found.facts.risky, 1);
  EXPECT_EQ(found.facts.closest_first, -1);
}

TEST_F(CIoConflicts, OptionsThatMakeNoSenseAreRefused) {
  const Recording flight =
      table(std::string(kHeader) + "a,0,0,0,0\na,1,0,0,0\nb,0,1,0,0\nb,1,1,0,0\n");
  EXPECT_EQ(find(flight, nullptr).code, BEESPACE_INVALID_THRESHOLD);
  const auto code_of = [&](auto&& change) {
    auto options = within(5.0);
    change(options);
    return find(flight, &options).code;
  };
  EXPECT_EQ(code_of([](auto&) {}), BEESPACE_OK);
  EXPECT_EQ(code_of([](auto& o) { o.threshold_m = -1; }), BEESPACE_INVALID_THRESHOLD);
  EXPECT_EQ(code_of([](auto& o) { o.flags = 4; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.limited = 2; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.max_results = 9; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.limited = 1; }), BEESPACE_TOO_MANY_RESULTS);
  EXPECT_EQ(code_of([](auto& o) { o.max_gap_s = -1; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.vertical = "high"; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.ignore_below_m = -1; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.struct_size = 8; }), BEESPACE_INVALID_ARGUMENT);
  auto error = io_error();
  EXPECT_EQ(beespace_io_find_conflicts(flight.get(), nullptr, nullptr, &error),
            BEESPACE_INVALID_ARGUMENT);
  beespace_io_conflicts* conflicts = nullptr;
  EXPECT_EQ(beespace_io_find_conflicts(nullptr, nullptr, &conflicts, &error),
            BEESPACE_INVALID_ARGUMENT);
  beespace_io_conflicts_free(nullptr);
  EXPECT_EQ(beespace_io_conflicts_size(nullptr), 0);
  EXPECT_EQ(beespace_io_coverage_text(nullptr, nullptr, 0), 0U);
}

// Two that begin 1 m apart on the ground of a show, as a table of colours tells it.
TEST_F(CIoConflicts, OfTwoThatAreLowAreLeftOutWhenAskedAndCounted) {
  const Recording show = table(
      "id,time_s,x [m],y [m],z [m],red,green,blue\na,0,0,0,0,1,1,1\na,4,0,0,2,1,1,1\n"
      "a,8,-20,0,2,1,1,1\nb,0,1,0,0,1,1,1\nb,4,1,0,0,1,1,1\nb,8,1,0,9,1,1,1\n");
  auto options = within(2.0);
  const Found all = find(show, &options);
  ASSERT_EQ(all.code, BEESPACE_OK) << text_of(all.error);
  EXPECT_EQ(beespace_io_conflicts_size(all.conflicts.get()), 1);
  EXPECT_EQ(all.facts.risky, 1);
  options.ignore_below_m = 3.0;
  const Found low = find(show, &options);
  EXPECT_EQ(beespace_io_conflicts_size(low.conflicts.get()), 0);
  EXPECT_EQ(low.facts.ignored, 1);
  EXPECT_EQ(low.facts.risky, 0);
  EXPECT_EQ(low.facts.takeoff_unknown, 0);
}

}  // namespace
}  // namespace beespace::test
