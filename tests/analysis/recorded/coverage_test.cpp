// How far apart two fixes may be, and of how much time it is known where the bees were.
#include "analysis/recorded/coverage.hpp"

#include "analysis/recorded/jump_spans.hpp"
#include "analysis/recorded/track_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

io::RecordedBee bee_at(const std::string& id, const std::vector<double>& times_s) {
  io::RecordedBee bee;
  bee.id = id;
  for (const double time_s : times_s) bee.fixes.push_back({time_s, {0.0, 0.0, 0.0}});
  return bee;
}

TEST(MaxGap, IsFiveTimesTheTypicalInterval) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 1, 2, 3, 60}), bee_at("b", {0, 1, 2, 3})};
  const MaxGap max_gap = max_gap_of(recording, {});
  EXPECT_EQ(max_gap.seconds, 5.0);
  EXPECT_EQ(max_gap_text(max_gap), "5 s, 5 times the typical interval of 1 s (--max-gap)");
}

TEST(MaxGap, IsWhatIsAskedFor) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 1, 2, 3})};
  EXPECT_EQ(max_gap_of(recording, 7.5).seconds, 7.5);
}

TEST(MaxGap, OfFewFixesIsThatOfTheBeesWithMore) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 3600}), bee_at("b", {0, 7200}), bee_at("c", {0, 1, 2, 3})};
  EXPECT_EQ(max_gap_of(recording, {}).seconds, 5.0);
}

TEST(MaxGap, IsNeverWhereNoBeeHasTwoFixes) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0}), bee_at("b", {1})};
  const MaxGap max_gap = max_gap_of(recording, {});
  EXPECT_TRUE(std::isinf(max_gap.seconds));
  EXPECT_EQ(max_gap_text(max_gap), "never");
}

// As collars take them by a schedule: nearly all of the time lies between the bursts.
TEST(Coverage, OfBurstsOfFixesSaysTheMaxGapThatJoinsThem) {
  std::vector<double> times_s;
  std::vector<Gap> gaps;
  for (int burst = 0; burst < 6; ++burst) {
    for (int fix = 0; fix < 5; ++fix) times_s.push_back(1800.0 * burst + fix);
    if (burst > 0) gaps.push_back({0, 1800.0 * (burst - 1) + 4.0, 1800.0 * burst});
  }
  io::Recording recording;
  recording.bees = {bee_at("wolf", times_s)};
  const MaxGap max_gap = max_gap_of(recording, {});
  EXPECT_EQ(slow_text(coverage_of(recording, gaps, max_gap), recording),
            "wolf has bursts of fixes as far apart as 29 min 56 s, which is more than the max gap, "
            "and is "
            "unknown in between: --max-gap 8980 joins such fixes by straight lines");
  // Outages of any length are no schedule.
  gaps.clear();
  std::vector<double> log_s = {0.0, 0.1};
  for (const double outage_s : {10.0, 300.0, 45.0, 1200.0}) {
    const double begins_s = log_s.back();
    gaps.push_back({0, begins_s, begins_s + outage_s});
    log_s.insert(log_s.end(), {begins_s + outage_s, begins_s + outage_s + 0.1});
  }
  recording.bees = {bee_at("drone", log_s)};
  EXPECT_EQ(slow_text(coverage_of(recording, gaps, {0.5, 0.1}), recording), "");
}

TEST(Coverage, CountsGapsAndTheTimeBeforeTheFirstAndAfterTheLastFix) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 1, 50, 51}), bee_at("b", {10, 20})};
  const std::vector<Gap> gaps = {{0, 1.0, 50.0}};
  const Coverage coverage = coverage_of(recording, gaps, {5.0, 1.0});
  EXPECT_EQ(coverage.gaps, 1U);
  EXPECT_EQ(coverage.bees_with_gaps, 1U);
  EXPECT_EQ(coverage.in_gaps_s, 49.0);
  EXPECT_EQ(coverage.bees_partly, 1U);
  EXPECT_EQ(coverage.outside_s, 41.0);
  EXPECT_TRUE(coverage.may_hide_conflicts());
  EXPECT_FALSE(coverage.complete());
  EXPECT_EQ(unknown_times_s(recording, gaps, {5.0, 1.0}), (std::vector<double>{49.0, 41.0}));
  EXPECT_EQ(unknown_text(coverage),
            "1 bee unknown for 49 s in all, 1 bee known for a part of the recording only");
  EXPECT_EQ(gap_text(gaps.front(), recording), "a from 1.00 s for 49 s");
}

// The first fixes of drones never fall on one instant.
TEST(Coverage, LessThanATypicalIntervalIsNoPartOfItsOwn) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 1, 2, 3}), bee_at("b", {0.5, 1.5, 2.5})};
  const Coverage coverage = coverage_of(recording, {}, {5.0, 1.0});
  EXPECT_EQ(coverage.bees_partly, 0U);
  EXPECT_TRUE(coverage.complete());
  EXPECT_EQ(unknown_text(coverage), "");
  recording.bees[1].fixes.pop_back();
  EXPECT_EQ(coverage_of(recording, {}, {5.0, 1.0}).bees_partly, 1U);
  recording.bees[1].fixes = {{0.5, {}}};
  EXPECT_EQ(coverage_of(recording, {}, {5.0, 1.0}).bees_partly, 1U) << "an instant only";
}

// Also in the air, and where --max-gap is given: stamps never fall on one instant.
TEST(Coverage, LessThanATypicalIntervalInTheAirIsKnown) {
  io::Recording recording;
  recording.frame = io::Frame::kMetres;
  io::RecordedBee late;
  io::RecordedBee early;
  late.id = "late";
  early.id = "early";
  for (int i = 0; i < 20; ++i) {
    early.fixes.push_back({0.1 * i, {2.0 * i, 0.0, 10.0}});
    late.fixes.push_back({0.1 * i + 0.04, {2.0 * i, 30.0, 10.0}});
  }
  recording.bees = {early, late};
  const std::vector<std::optional<double>> asked = {std::nullopt, 0.5};
  for (const auto& max_gap_s : asked) {
    EXPECT_TRUE(coverage_of(recording, {}, max_gap_of(recording, max_gap_s)).complete());
  }
  // Who lacks one fix is not known for the whole interval.
  recording.bees[1] = early;
  recording.bees[1].fixes.pop_back();
  for (const auto& max_gap_s : asked) {
    EXPECT_EQ(coverage_of(recording, {}, max_gap_of(recording, max_gap_s)).bees_cut_off, 1U);
  }
}

// A drone of a show that lands stands there from then on; one whose path ends in the air may be
// anywhere.
TEST(Coverage, DronesOfAShowAreKnownWhileTheyStandOnTheGround) {
  io::Recording recording;
  recording.show = io::ShowFacts();
  recording.bees = {bee_at("a", {0, 30, 60}), bee_at("b", {10, 15, 20}), bee_at("c", {10, 15, 20})};
  recording.bees[0].fixes[1].position.z = recording.bees[1].fixes[1].position.z = 10.0;
  recording.bees[2].fixes[2].position.z = 0.2;
  const Coverage coverage = coverage_of(recording, {}, {5.0, 1.0});
  EXPECT_EQ(coverage.bees_partly, 1U);
  EXPECT_EQ(unknown_times_s(recording, {}, {5.0, 1.0}), (std::vector<double>{0.0, 0.0, 40.0}));
  EXPECT_EQ(coverage.bees_cut_off, 1U);
  EXPECT_TRUE(coverage.may_hide_conflicts());
  EXPECT_EQ(unknown_text(coverage),
            "1 bee known for a part of the recording only (1 of which begins or ends in the air "
            "while others fly)");
}

io::RecordedBee curve_at(const std::string& id, double ends_s, double first_m, double last_m) {
  io::RecordedBee bee;
  bee.id = id;
  bee.path = BezierPath{0.0, {0.0, 0.0, first_m}, {{ends_s, {0.0, 0.0, last_m}, {}, 0}}};
  return bee;
}

TEST(Coverage, CurvesThatEndInTheAirAreKnownForAPart) {
  io::Recording recording;
  recording.show = io::ShowFacts();
  recording.bees = {curve_at("a", 60.0, 0.0, 0.0), curve_at("b", 20.0, 0.0, 10.0),
                    curve_at("c", 30.0, 0.0, 0.05)};
  const Coverage coverage = coverage_of(recording, {}, {5.0, 1.0});
  EXPECT_EQ(coverage.bees_cut_off, 1U);
  EXPECT_EQ(unknown_times_s(recording, {}, {5.0, 1.0}), (std::vector<double>{0.0, 40.0, 0.0}));
}

// Where all begin and end is the ground only where the show says so, or near z = 0.
TEST(Coverage, AShowThatIsInTheAirThroughoutHasNoGround) {
  io::Recording recording;
  recording.show = io::ShowFacts();
  recording.bees = {curve_at("a", 60.0, 10.0, 10.0), curve_at("b", 20.0, 10.0, 10.0)};
  EXPECT_EQ(coverage_of(recording, {}, {5.0, 1.0}).bees_cut_off, 1U);
  recording.bees = {curve_at("a", 60.0, 0.3, 0.3), curve_at("b", 20.0, 0.3, 0.3)};
  EXPECT_EQ(coverage_of(recording, {}, {5.0, 1.0}).bees_cut_off, 0U);
  recording.show->ground_m = 0.0;
  EXPECT_EQ(coverage_of(recording, {}, {5.0, 1.0}).bees_cut_off, 1U);
  recording.show->ground_m.reset();
  recording.show.reset();
  const Coverage flight = coverage_of(recording, {}, {5.0, 1.0});
  EXPECT_EQ(flight.bees_partly, 1U);
  EXPECT_FALSE(flight.may_hide_conflicts());
}

// Faster than anything that flies: one of the two places is wrong.
// A longer --max-gap joins what is shorter than it already no better.
TEST(Coverage, RecordsWithoutAPlaceAreNoBurstsOfFixes) {
  io::Recording recording;
  recording.of_aircraft = true;
  recording.bees = {bee_at("a", {0, 10, 20, 40, 50, 70, 80, 100, 110, 130, 140, 160, 170})};
  recording.bees[0].lost = {{20, 40}, {50, 70}, {80, 100}, {110, 130}, {140, 160}};
  const MaxGap max_gap = max_gap_of(recording, {});
  EXPECT_EQ(max_gap.seconds, 50.0);
  const Coverage coverage = coverage_of(recording, {}, max_gap);
  EXPECT_EQ(coverage.gaps, 5u);
  EXPECT_TRUE(coverage.slow.empty());
  EXPECT_EQ(slow_text(coverage, recording), "");
  EXPECT_EQ(unknown_text(coverage, &recording).find("--max-gap"), std::string::npos);
}

TEST(Coverage, WhereABeeJumpsItIsUnknown) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 10, 20, 30}), bee_at("b", {0, 10, 20, 30})};
  recording.bees[1].fixes[2].position.x = 1e6;
  EXPECT_TRUE(unknown_spans(recording, {}, {50.0, 10.0}).empty());
  recording.missing.jumping = 1;
  EXPECT_EQ(unknown_spans(recording, {}, {50.0, 10.0}), (std::vector<Gap>{{1, 10.0, 30.0}}));
}

// Of an aircraft that has landed the time after that is no time in the air.
TEST(Coverage, AircraftThatHaveLandedAreNotCutOff) {
  io::Recording recording;
  recording.frame = io::Frame::kWgs84;
  recording.bees = {bee_at("a", {0, 30, 59, 60}), bee_at("b", {0, 15, 19, 20})};
  for (io::RecordedBee& bee : recording.bees) {
    for (Fix& fix : bee.fixes) fix.position = {8.0 + 0.001 * fix.time_s, 47.0, 500.0};
  }
  EXPECT_EQ(coverage_of(recording, {}, {5.0, 1.0}).bees_cut_off, 1U);
  recording.bees[1].on_ground_from_s = 24.0;
  const Coverage landed = coverage_of(recording, {}, {5.0, 1.0});
  EXPECT_EQ(landed.bees_cut_off, 0U);
  EXPECT_EQ(landed.outside_s, 0.0);
  EXPECT_FALSE(landed.may_hide_conflicts());
  // Half a minute of flight is unknown.
  recording.bees[1].on_ground_from_s = 50.0;
  const Coverage late = coverage_of(recording, {}, {5.0, 1.0});
  EXPECT_EQ(late.bees_cut_off, 1U);
  EXPECT_EQ(late.outside_s, 30.0);
}

// In metres with heights one whose fixes end in the air is cut off; what rests at the height of
// the others has landed.
TEST(Coverage, DronesThatEndInTheAirAreCutOff) {
  io::Recording recording;
  recording.frame = io::Frame::kMetres;
  recording.bees = {bee_at("a", {0, 30, 59, 60}), bee_at("b", {0, 15, 19, 20}),
                    bee_at("c", {0, 15, 19, 20})};
  for (io::RecordedBee& bee : recording.bees) bee.fixes[1].position.z = 10.0;
  recording.bees[1].fixes[2].position.z = recording.bees[1].fixes[3].position.z = 5.0;
  const Coverage coverage = coverage_of(recording, {}, {5.0, 1.0});
  EXPECT_EQ(coverage.bees_partly, 2U);
  EXPECT_EQ(coverage.bees_cut_off, 1U);
  EXPECT_TRUE(coverage.may_hide_conflicts());
  // What moves on at that height flies.
  recording.bees[2].fixes[3].position.x = 10.0;
  EXPECT_EQ(coverage_of(recording, {}, {5.0, 1.0}).bees_cut_off, 2U);
  // In degrees, too.
  recording.frame = io::Frame::kWgs84;
  EXPECT_EQ(coverage_of(recording, {}, {5.0, 1.0}).bees_cut_off, 2U);
}

// In gaps, and in the air before the first fix or after the last one; not where one has landed.
io::RecordedBee bee_along_x(const std::string& id, double from_s, double until_s, double from_m,
                            double mps, double y_m) {
  io::RecordedBee bee;
  bee.id = id;
  for (double time_s = from_s; time_s <= until_s; time_s += 0.5) {
    bee.fixes.push_back({time_s, {from_m + mps * (time_s - from_s), y_m, 0.0}});
  }
  return bee;
}

TEST(Coverage, WhoVanishesInTheMidstOfAPictureIsLostAndWhoLeavesItIsNot) {
  io::Recording recording;
  recording.flat = true;
  recording.bees = {bee_along_x("low", 0, 20, 0, 5, 0), bee_along_x("high", 0, 20, 0, 5, 50),
                    bee_along_x("vanishes", 0, 10, 0, 5, 25),
                    bee_along_x("appears", 12, 20, 30, 0, 25),
                    bee_along_x("leaves", 0, 5, 20, -4, 20)};
  const MaxGap max_gap{1.0, 0.5};
  const Coverage coverage = coverage_of(recording, {}, max_gap);
  EXPECT_EQ(coverage.bees_partly, 3U);
  EXPECT_EQ(coverage.bees_cut_off, 2U);
  EXPECT_TRUE(coverage.may_hide_conflicts());
  EXPECT_NE(unknown_text(coverage).find("2 of which appear or vanish on their way"),
            std::string::npos);
  EXPECT_EQ(unknown_spans(recording, {}, max_gap),
            (std::vector<Gap>{{2, 10.0, 20.0}, {3, 0.0, 12.0}}));
}

TEST(Coverage, ARobotAtHeightZeroThatEndsWhileItMovesIsLostAndOneThatStopsIsNot) {
  io::Recording recording;
  recording.bees = {bee_along_x("stays", 0, 20, 0, 0.6, 0),
                    bee_along_x("falls silent", 0, 10, 30, -0.6, 0),
                    bee_along_x("is parked", 0, 10, 5, 0, 9)};
  const Coverage coverage = coverage_of(recording, {}, {1.0, 0.5});
  EXPECT_EQ(coverage.bees_partly, 2U);
  EXPECT_EQ(coverage.bees_cut_off, 1U);
}

// The same on the Earth without heights: who moves does not stop in the midst of the others, as a
// collar does.
TEST(Coverage, OnTheEarthWithoutHeightsWhoVanishesOnItsWayIsLost) {
  io::Recording recording;
  recording.frame = io::Frame::kWgs84;
  recording.flat = true;
  recording.bees = {bee_along_x("low", 0, 20, 0, 5, 0), bee_along_x("high", 0, 20, 0, 5, 50),
                    bee_along_x("vanishes", 0, 10, 0, 5, 25), bee_along_x("collar", 0, 10, 9, 0, 9),
                    bee_along_x("leaves", 0, 5, 20, -4, 20)};
  for (io::RecordedBee& bee : recording.bees) {
    for (Fix& fix : bee.fixes) {
      fix.position.x = 179.9 + fix.position.x / 100'000;
      fix.position.y = 47.0 + fix.position.y / 100'000;
    }
  }
  const MaxGap max_gap{1.0, 0.5};
  const Coverage coverage = coverage_of(recording, {}, max_gap);
  EXPECT_EQ(coverage.bees_partly, 3U);
  EXPECT_EQ(unknown_spans(recording, {}, max_gap), (std::vector<Gap>{{2, 10.0, 20.0}}));
  EXPECT_NE(unknown_text(coverage).find("1 of which appears or vanishes on its way"),
            std::string::npos);
}

TEST(Coverage, WhereFixesFailedItIsUnknownUnlessTheGapIsAskedFor) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 10, 40}), bee_at("b", {0, 10, 40})};
  recording.bees[1].lost = {{10.0, 40.0}};
  const Coverage coverage = coverage_of(recording, {}, {50.0, 10.0});
  EXPECT_EQ(coverage.gaps, 1U);
  EXPECT_EQ(coverage.in_gaps_s, 30.0);
  EXPECT_TRUE(coverage.may_hide_conflicts());
  EXPECT_EQ(unknown_spans(recording, {}, {50.0, 10.0}), (std::vector<Gap>{{1, 10.0, 40.0}}));
  EXPECT_FALSE(coverage_of(recording, {}, {50.0, std::nullopt, true}).may_hide_conflicts());
}

// Its collar tells where it is each hour, but for a day; those of the others each 12 hours.
TEST(Coverage, WhoHasFixesFarMoreOftenHasGapsOfItsOwn) {
  io::Recording recording;
  const auto every = [](const char* id, double hours, double until) {
    std::vector<double> times_s;
    for (int i = 0; i * hours <= until; ++i) times_s.push_back(3600.0 * hours * i);
    return bee_at(id, times_s);
  };
  recording.bees = {every("hourly", 1, 96), every("b", 12, 96), every("c", 12, 96),
                    every("d", 12, 96)};
  const MaxGap max_gap = max_gap_of(recording, std::nullopt);
  EXPECT_EQ(max_gap.seconds, 216'000.0);
  EXPECT_TRUE(lost_spans(recording, max_gap).empty());
  std::vector<Fix>& fixes = recording.bees[0].fixes;
  fixes.erase(fixes.begin() + 20, fixes.begin() + 45);
  const std::vector<Gap> lost = {{0, 19 * 3600.0, 45 * 3600.0}};
  EXPECT_EQ(lost_spans(recording, max_gap), lost);
  const Coverage coverage = coverage_of(recording, {}, max_gap);
  EXPECT_EQ(coverage.gaps, 1u);
  EXPECT_FALSE(coverage.complete());
  EXPECT_FALSE(coverage.bridged);
  EXPECT_TRUE(lost_spans(recording, max_gap_of(recording, 216'000.0)).empty());
  recording.of_aircraft = true;
  EXPECT_TRUE(lost_spans(recording, max_gap).empty());
}

TEST(Coverage, TwoOfOneIdAreNeverKnown) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 10, 40}), bee_at("b", {0, 10, 40})};
  recording.bees[1].shared = true;
  EXPECT_EQ(unknown_spans(recording, {}, {50.0, 10.0}), (std::vector<Gap>{{1, 0.0, 40.0}}));
}

TEST(Coverage, TellsWhenItIsNotKnownWhereABeeIs) {
  io::Recording recording;
  recording.frame = io::Frame::kMetres;
  recording.bees = {bee_at("a", {0, 30, 59, 60}), bee_at("b", {5, 15, 19, 20}),
                    bee_at("c", {0, 15, 19, 20})};
  for (io::RecordedBee& bee : recording.bees) bee.fixes[1].position.z = 10.0;
  for (const std::size_t i : {0U, 2U, 3U}) recording.bees[1].fixes[i].position.z = 5.0;
  const std::vector<Gap> gaps = {{0, 30.0, 59.0}, {1, 5.0, 15.0}};
  EXPECT_EQ(unknown_spans(recording, gaps, {8.0, {}, true}),
            (std::vector<Gap>{{0, 30.0, 59.0}, {1, 0.0, 5.0}, {1, 5.0, 15.0}, {1, 20.0, 60.0}}));
  // There without a place, and in the air: both are one.
  recording.bees[1].unplaced_until_s = 40.0;
  EXPECT_EQ(unknown_spans(recording, {}, {8.0, {}, true}),
            (std::vector<Gap>{{1, 0.0, 5.0}, {1, 20.0, 60.0}}));
  recording.bees[2].unplaced_until_s = 30.0;
  EXPECT_EQ(unknown_spans(recording, {}, {8.0, {}, true}).back(), (Gap{2, 20.0, 30.0}));
}

// One slow log among fast ones: said is whose it is, and what joins its fixes.
TEST(Coverage, NamesWhoIsHeardOfSeldom) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 1, 2, 3, 4, 5}), bee_at("b", {0, 1, 2, 3, 4, 5}),
                    bee_at("c", {0, 10, 20, 30, 40}), bee_at("d", {0, 1, 2, 3, 90})};
  const MaxGap max_gap = max_gap_of(recording, {});
  ASSERT_EQ(max_gap.seconds, 5.0);
  std::vector<Gap> gaps;
  for (double time_s = 0.0; time_s < 40.0; time_s += 10.0) gaps.push_back({2, time_s, time_s + 10});
  gaps.push_back({3, 3.0, 90.0});
  const Coverage coverage = coverage_of(recording, gaps, max_gap);
  EXPECT_EQ(coverage.slow, (std::vector<PointId>{2}));
  EXPECT_EQ(slow_text(coverage, recording),
            "c has a fix every 10 s, which is more than the max gap, and is hardly ever known: "
            "--max-gap 50 joins such fixes by straight lines");
  EXPECT_EQ(slow_text(coverage_of(recording, {{3, 3.0, 90.0}}, max_gap), recording), "");
}

TEST(TrackEnds, AreTheFirstTwoAndTheLastTwo) {
  TrackEnds ends;
  for (const double time_s : {5.0, 3.0, 9.0, 3.0, 1.0, 7.0})
    ends.add(1, {time_s, {time_s, 0.0, 0.0}});
  ends.add(2, {4.0, {}});
  std::vector<double> times_s;
  for (const Fix& fix : ends.of(1)) times_s.push_back(fix.time_s);
  EXPECT_EQ(times_s, (std::vector<double>{1.0, 3.0, 7.0, 9.0}));
  EXPECT_EQ(ends.of(2).size(), 1U);
  EXPECT_TRUE(ends.of(0).empty());
  EXPECT_TRUE(ends.of(3).empty());
}

TEST(Coverage, NamesTheLongestGapsFirst) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 10, 30, 60, 100})};
  const std::vector<Gap> gaps = {
      {0, 0.0, 10.0}, {0, 10.0, 30.0}, {0, 30.0, 60.0}, {0, 60.0, 100.0}};
  const Coverage coverage = coverage_of(recording, gaps, {5.0, 1.0});
  ASSERT_EQ(coverage.longest.size(), Coverage::kMostNamed);
  EXPECT_EQ(length_of(coverage.longest.front()), 40.0);
  EXPECT_EQ(length_of(coverage.longest.back()), 20.0);
}

TEST(Coverage, OfRecordsThatWereLeftOutIsNotComplete) {
  io::Recording recording;
  recording.bees = {bee_at("a", {0, 1})};
  recording.missing.count = 6;
  recording.missing.nowhere = 1;
  const Coverage coverage = coverage_of(recording, {}, {5.0, 1.0});
  EXPECT_FALSE(coverage.complete());
  EXPECT_EQ(unknown_text(coverage), "1 bee is known nowhere, 6 records were left out");
}

}  // namespace
}  // namespace beespace::analysis
