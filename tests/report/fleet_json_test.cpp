// What a planner said of a fleet, in the page's JSON: as docs/page-format.md has it.
#include "report/recording_json.hpp"

#include "tests/report/page_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::report {
namespace {

using report_test::has;
using report_test::Json;
using report_test::numbers_of;
using report_test::ParsedJson;
using report_test::text_of;
using report_test::values_of;

using Numbers = std::vector<std::uint64_t>;
using Values = std::vector<double>;

// Two bees that are there from 100 to 102 s; the second is no one's.
RecordingFacts two_bees() {
  RecordingFacts facts;
  for (const double x : {0.0, 50.0}) {
    Track track;
    track.fixes = {{100.0, {x, 0, 0}}, {102.0, {x, 0, 0}}};
    facts.tracks.push_back(track);
  }
  return facts;
}

FleetFacts told() {
  FleetFacts fleet;
  fleet.title = "fleet.ndjson";
  fleet.period_s = 0.5;
  fleet.bees.resize(2);
  FleetBee& bee = fleet.bees[0];
  bee.branches = {{199, {0, 0, 0}, {0, 0, 0}, 0.0, {}}, {203, {1, 0, 0}, {2, 0, 0}, 0.8, 0}};
  bee.states = {{200, {0, 0, 0}, 0.5, Contract::kKept, ContractReason::kNone, true, 1, 0},
                {201, {0.5, 0, 0}, 0.5, Contract::kOut, ContractReason::kRate, false, 2, 1},
                {204, {1.5, 0, 0}, 0.25, Contract::kDoubted, ContractReason::kSilent, true, 1, {}}};
  return fleet;
}

struct Written {
  explicit Written(const RecordingFacts& facts) : json(text_of_json(facts, columns)) {}

  static std::string text_of_json(const RecordingFacts& facts, Columns& columns) {
    std::string text;
    io::JsonWriter json(text);
    write_swarm(json, facts, columns);
    return text;
  }
  [[nodiscard]] Numbers numbers(Json column) const {
    return numbers_of(column, columns.elements());
  }
  [[nodiscard]] Values values(Json column) const { return values_of(column, columns.elements()); }

  Columns columns;
  ParsedJson json;
};

TEST(FleetJson, ARecordingWithoutALogSaysNothingOfAFleet) {
  const Written written(two_bees());
  EXPECT_FALSE(has(written.json.root(), "fleet"));
}

TEST(FleetJson, ALogOnlyAddsToWhatIsWrittenOfARecording) {
  RecordingFacts facts = two_bees();
  Columns plain;
  const std::string without = Written::text_of_json(facts, plain);
  facts.fleet = told();
  Columns columns;
  const std::string with = Written::text_of_json(facts, columns);
  EXPECT_TRUE(with.starts_with(without.substr(0, without.size() - 1)));
  ASSERT_GE(columns.elements().size(), plain.elements().size());
  for (std::size_t i = 0; i < plain.elements().size(); ++i) {
    EXPECT_EQ(columns.elements()[i], plain.elements()[i]);
  }
}

TEST(FleetJson, StatesAreWhatWasSaid) {
  RecordingFacts facts = two_bees();
  facts.fleet = told();
  const Written written(facts);
  const Json fleet = written.json["fleet"];
  EXPECT_EQ(text_of(fleet["title"]), "fleet.ndjson");
  EXPECT_EQ(double(fleet["tick_s"]), 0.5);
  const Json states = fleet["states"];
  EXPECT_EQ(written.numbers(states["counts"]), (Numbers{3, 0}));
  EXPECT_EQ(written.values(states["time_s"]), (Values{0.0, 0.5, 2.0}));  // from 100 s on
  const Values x = written.values(states["x"]);
  ASSERT_EQ(x.size(), 3U);
  EXPECT_NEAR(x[1], 0.5, 1e-4);
  EXPECT_NEAR(x[2], 1.5, 1e-4);
  EXPECT_EQ(written.numbers(states["absent_after"]), (Numbers{1}));
  EXPECT_EQ(written.values(states["tube_m"]), (Values{0.5, 0.5, 0.25}));
  EXPECT_EQ(written.numbers(states["contract"]), (Numbers{0, 2, 1}));
  EXPECT_EQ(written.numbers(states["reason"]), (Numbers{0, 2, 3}));
  EXPECT_EQ(written.numbers(states["certified"]), (Numbers{1, 0, 1}));
  EXPECT_EQ(written.numbers(states["branches"]), (Numbers{1, 2, 1}));
  EXPECT_EQ(written.numbers(states["newest"]), (Numbers{1, 2, 0}));
}

TEST(FleetJson, BranchesAreWhatTheyHaveOfTheirOwn) {
  RecordingFacts facts = two_bees();
  facts.fleet = told();
  const Written written(facts);
  const Json branches = written.json["fleet"]["branches"];
  EXPECT_EQ(written.numbers(branches["counts"]), (Numbers{2, 0}));
  EXPECT_EQ(written.values(branches["time_s"]), (Values{-0.5, 1.5}));
  EXPECT_NEAR(written.values(branches["x"])[1], 1.0, 1e-4);
  EXPECT_NEAR(written.values(branches["stop"]["x"])[1], 2.0, 1e-4);
  EXPECT_EQ(written.values(branches["braking_s"]), (Values{0.0, 0.8}));
  EXPECT_EQ(written.numbers(branches["back"]), (Numbers{0, 1}));
}

TEST(FleetJson, AFleetOfWhichNothingIsSaidIsWrittenToo) {
  RecordingFacts facts = two_bees();
  facts.fleet = FleetFacts{"fleet.ndjson", 0.5, std::vector<FleetBee>(2)};
  const Written written(facts);
  const Json states = written.json["fleet"]["states"];
  EXPECT_EQ(written.numbers(states["counts"]), (Numbers{0, 0}));
  EXPECT_EQ(double(states["time_s"]["offset"]), -100.0);
}

}  // namespace
}  // namespace beespace::report
