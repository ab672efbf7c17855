// `beespace report`: its pages agree with the answers of `detect` and `replay` for the same input.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/page_command.hpp"

namespace beespace::cli_test {
namespace {

using report_test::has;
using report_test::ParsedJson;
using report_test::text_of;

class Report : public PageCommand {};

std::string swarm_of(const char* bees, const char* size_m) {
  return run({"generate", "--points", bees, "--size", size_m}).out;
}

std::string flights() {
  return run({"generate", "--scene", "flight", "--points", "40", "--duration", "30", "--size",
              "100", "--interval", "2"})
      .out;
}

// The answer of a command as JSON.
ParsedJson answer(const Arguments& arguments, std::string_view input) {
  const Finished finished = run(arguments + Arguments{"--json"}, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return ParsedJson(finished.out);
}

std::vector<std::string> at_risk_in(const Page& page) {
  const auto bits = page.numbers(page.swarm()["at_risk"]);
  const auto names = page.names();
  std::vector<std::string> at_risk;
  for (std::size_t bee = 0; bee < names.size(); ++bee) {
    if (((bits.at(bee / 8) >> (bee % 8)) & 1u) != 0) at_risk.push_back(names[bee]);
  }
  return at_risk;
}

// The distances of the pairs.
using Apart = std::map<std::pair<std::string, std::string>, double>;

Apart pairs_in(const Page& page) {
  const auto firsts = page.numbers(page.swarm()["pairs"]["first"]);
  const auto seconds = page.numbers(page.swarm()["pairs"]["second"]);
  const auto distances_m = page.values(page.swarm()["pairs"]["distance_m"]);
  const auto names = page.names();
  Apart pairs;
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    pairs[{names.at(firsts[i]), names.at(seconds.at(i))}] = distances_m.at(i);
  }
  EXPECT_EQ(pairs.size(), firsts.size());
  EXPECT_TRUE(std::is_sorted(distances_m.begin(), distances_m.end()));
  return pairs;
}

Apart pairs_found(const Arguments& how, std::string_view input) {
  Apart pairs;
  for (const auto& row : rows_of(run(Arguments{"detect", "--report", "pairs"} + how, input).out)) {
    pairs[{row.at(0), row.at(1)}] = std::stod(row.at(2));
  }
  return pairs;
}

// "1,234".
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ',');
  return digits;
}

void expect_as_detect(const Arguments& how, const std::string& input) {
  const Page page = reported(how, input);
  EXPECT_EQ(text_of(page.swarm()["kind"]), "snapshot");
  EXPECT_EQ(at_risk_in(page), lines_of(run(Arguments{"detect"} + how, input).out));
  const Apart pairs = pairs_found(how, input);
  EXPECT_EQ(pairs_in(page), pairs);
  EXPECT_EQ(std::uint64_t(page.risk()["pairs"]), pairs.size());
  EXPECT_EQ(std::uint64_t(page.risk()["at_risk"]), at_risk_in(page).size());
  const auto groups = rows_of(run(Arguments{"detect", "--report", "groups"} + how, input).out);
  EXPECT_EQ(std::uint64_t(page.risk()["groups"]), groups.size());
  std::uint64_t largest = 0;
  for (const auto& row : groups) largest = std::max<std::uint64_t>(largest, std::stoul(row.at(1)));
  EXPECT_EQ(std::uint64_t(page.risk()["largest_group"]), largest);
  const ParsedJson closest = answer(Arguments{"detect"} + how, input);
  EXPECT_EQ(double(page.risk()["closest"]["distance_m"]),
            double(closest["closest_pair"]["distance_m"]));
  std::string said = grouped(at_risk_in(page).size()) + " of " + grouped(page.names().size());
  said += ": " + grouped(pairs.size()) + (pairs.size() == 1 ? " pair in " : " pairs in ");
  said += std::to_string(groups.size()) + (groups.size() == 1 ? " group\n" : " groups\n");
  expect_parts(run(Arguments{"report"} + how, input).err, {"at risk    " + said});
}

TEST_F(Report, OfASnapshotItAgreesWithDetect) {
  const std::string input = swarm_of("800", "60");
  expect_as_detect({"--threshold", "3"}, input);
  expect_as_detect({"--threshold", "3", "--vertical", "0.5", "--inclusive"}, input);
}

TEST_F(Report, BeesAreCalledByTheirIds) {
  expect_as_detect({"--threshold", "2"},
                   "id,x,y,z\nalpha,0,0,0\nbeta,1.5,0,0\n\"<gamma>\",50,0,0\n");
}

TEST_F(Report, ExactlyTheThresholdCountsOnlyWhenInclusive) {
  constexpr std::string_view input = "x,y,z\n0,0,0\n3,4,0\n";
  const Page without = reported({"--threshold", "5"}, input);
  EXPECT_TRUE(at_risk_in(without).empty());
  EXPECT_FALSE(bool(without.swarm()["inclusive"]));
  const Page with = reported({"--threshold", "5", "--inclusive"}, input);
  EXPECT_EQ(at_risk_in(with).size(), 2u);
  EXPECT_TRUE(bool(with.swarm()["inclusive"]));
}

TEST_F(Report, TheNearestAreThoseOfDetect) {
  const std::string input = swarm_of("300", "60");
  const Page page = reported({}, input);
  const auto codes = page.numbers(page.swarm()["nearest"]["code"]);
  const double least_m = double(page.swarm()["nearest"]["least_m"]);
  const double ratio = double(page.swarm()["nearest"]["ratio"]);
  const auto nearest = rows_of(run({"detect", "--report", "nearest"}, input).out);
  ASSERT_EQ(codes.size(), nearest.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const double told_m = least_m * std::pow(ratio, static_cast<double>(codes[i]) - 1.0);
    EXPECT_NEAR(told_m, std::stod(nearest[i].at(2)), told_m * (ratio - 1.0));
  }
}

// The same but for its name.
void expect_alike(const Page& page, const Page& other) {
  EXPECT_EQ(page.parts.elements, other.parts.elements);
  EXPECT_EQ(simdjson::minify(page.risk()), simdjson::minify(other.risk()));
}

TEST_F(Report, FromAFileAPipeAndCompressedItIsTheSame) {
  const std::string plain = swarm_of("200", "60");
  const std::string compressed =
      run({"generate", "--points", "200", "--size", "60", "--format", "csv.gz"}).out;
  const Page page = reported({folder_.file("bees.csv", plain), "--threshold", "9"});
  EXPECT_EQ(text_of(page.swarm()["title"]), "bees.csv");
  expect_alike(page, reported({folder_.file("bees.csv.gz", compressed), "--threshold", "9"}));
  const Page piped = reported({"--threshold", "9"}, plain);
  EXPECT_EQ(text_of(piped.swarm()["title"]), "standard input");
  expect_alike(page, piped);
  expect_alike(page, reported({"-", "--threshold", "9"}, compressed));
}

TEST_F(Report, APipeWithANameIsReadOnce) {
  for (const std::string_view input :
       {"x,y,z\n0,0,0\n1,0,0\n", "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\n"}) {
    const std::string pipe = folder_.path("pipe.csv");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { folder_.file("pipe.csv", input); });
    const Finished finished = run({"report", pipe});
    const int other_end = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);  // if it was not read
    writer.join();
    close(other_end);
    expect_alike(Page(finished.out), reported({}, input));
    std::filesystem::remove(pipe);
  }
}

// For a recording, the answer of `replay`.
void expect_as_replay(const Arguments& how, const std::string& input) {
  const Page page = reported(how, input);
  EXPECT_EQ(text_of(page.swarm()["kind"]), "recording");
  const auto replayed = rows_of(run(Arguments{"replay"} + how, input).out);
  const auto conflicts = page.swarm()["conflicts"].value();
  const auto names = page.names();
  const auto firsts = page.numbers(conflicts["first"]);
  const auto seconds = page.numbers(conflicts["second"]);
  const auto begins_s = page.values(conflicts["begins_s"]);
  const auto closest_s = page.values(conflicts["closest_s"]);
  const auto ends_s = page.values(conflicts["ends_s"]);
  const auto distances_m = page.values(conflicts["distance_m"]);
  EXPECT_TRUE(std::is_sorted(distances_m.begin(), distances_m.end()));
  ASSERT_EQ(firsts.size(), replayed.size());
  EXPECT_GT(replayed.size(), 0u);
  const double zero_s = double(page.swarm()["time"]["begins_s"]);
  const double tick_s = double(page.swarm()["fixes"]["time_s"]["scale"]);
  EXPECT_LE(tick_s, 1e-3);
  for (const auto& row : replayed) {
    const double distance_m = std::stod(row.at(4));
    const auto at = std::lower_bound(distances_m.begin(), distances_m.end(), distance_m);
    ASSERT_TRUE(at != distances_m.end() && *at == distance_m);
    const auto i = static_cast<std::size_t>(at - distances_m.begin());
    EXPECT_EQ(names.at(firsts[i]), row.at(0));
    EXPECT_EQ(names.at(seconds.at(i)), row.at(1));
    EXPECT_NEAR(begins_s.at(i), std::stod(row.at(2)) - zero_s, tick_s);
    EXPECT_NEAR(closest_s.at(i), std::stod(row.at(3)) - zero_s, tick_s);
    EXPECT_NEAR(ends_s.at(i), std::stod(row.at(5)) - zero_s, tick_s);
  }
}

double seconds_at_risk(const std::string& bees) {
  double sum_s = 0.0;
  for (const auto& row : rows_of(bees)) sum_s += std::stod(row.at(2));
  return sum_s;
}

TEST_F(Report, OfARecordingItAgreesWithReplay) {
  const std::string input = flights();
  const Arguments how = {"--threshold", "11"};
  expect_as_replay(how, input);
  const Page page = reported(how, input);
  const ParsedJson replayed = answer(Arguments{"replay"} + how, input);
  EXPECT_EQ(std::uint64_t(page.risk()["conflicts"]), std::uint64_t(replayed["conflict_count"]));
  EXPECT_EQ(std::uint64_t(page.risk()["pairs"]), std::uint64_t(replayed["pair_count"]));
  EXPECT_EQ(double(page.risk()["closest"]["distance_m"]),
            double(replayed["closest"]["distance_m"]));
  const std::string bees = run(Arguments{"replay", "--report", "bees"} + how, input).out;
  EXPECT_NEAR(double(page.risk()["bee_seconds"]), seconds_at_risk(bees), 1e-6);
  const auto separation_m = page.values(page.swarm()["separation"]["distance_m"]);
  EXPECT_EQ(*std::min_element(separation_m.begin(), separation_m.end()),
            double(page.risk()["closest"]["distance_m"]));
  const auto times_s = page.values(page.swarm()["separation"]["time_s"]);
  EXPECT_TRUE(std::is_sorted(times_s.begin(), times_s.end()));
}

TEST_F(Report, TheSummaryOfARecordingAgreesWithReplay) {
  const std::string input = flights();
  const std::string seen = run({"report", "--threshold", "11"}, input).err;
  const std::string replayed = run({"replay", "--threshold", "11"}, input).err;
  const std::string said = "does not keep its distance: ";
  const std::size_t at = replayed.find(said);
  ASSERT_NE(at, std::string::npos) << replayed;
  const std::size_t begin = at + said.size();
  const std::string conflicts = replayed.substr(begin, replayed.find('\n', begin) - begin);
  expect_parts(seen,
               {"bees       40\n", "threshold  11 m (closer than)\n", "at risk    " + conflicts});
}

TEST_F(Report, ARecordingMayBeAFolderOrSeveralFiles) {
  constexpr std::string_view a = "id,time_s,x,y,z\na,1,0,0,0\na,11,100,0,0\n";
  constexpr std::string_view b = "id,time_s,x,y,z\nb,1,100,3,0\nb,11,0,3,0\n";
  const Page piped = reported({"--threshold", "5"}, std::string(a) + std::string(b.substr(16)));
  const Page of_files =
      reported({folder_.file("a.csv", a), folder_.file("b.csv", b), "--threshold", "5"});
  const Page of_folder = reported({folder_.path(""), "--threshold", "5"});
  for (const Page* page : {&piped, &of_files, &of_folder}) {
    EXPECT_EQ(text_of(page->swarm()["kind"]), "recording");
    EXPECT_EQ(page->names(), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(page->values(page->swarm()["conflicts"]["distance_m"]), std::vector<double>{3.0});
    expect_alike(piped, *page);
  }
  EXPECT_EQ(text_of(of_files.swarm()["title"]), "a.csv and 1 more");
  EXPECT_NE(text_of(of_folder.swarm()["title"]), "");
}

TEST_F(Report, StretchesOfABeeThatTouchAreOne) {
  // b and c pass a 2 s and 3 s after the start: within 5 m for a second each way.
  constexpr std::string_view input =
      "id,time_s,x,y,z\na,0,0,0,0\na,10,0,0,0\nb,0,10,0,0\nb,4,-10,0,0\nc,0,0,15,0\nc,6,0,-15,0\n"
      "d,0,90,0,0\nd,9,90,0,0\n";
  const Page page = reported({"--threshold", "5"}, input);
  const auto at_risk = page.swarm()["at_risk"].value();
  const auto bees = page.numbers(at_risk["bee"]);
  ASSERT_EQ(bees, (std::vector<std::uint64_t>{0, 1, 2}));
  EXPECT_NEAR(page.values(at_risk["begins_s"])[0], 1.0, 1e-3);
  EXPECT_NEAR(page.values(at_risk["ends_s"])[0], 4.0, 1e-3);
  EXPECT_EQ(std::uint64_t(page.risk()["bees"]), 3u);
}

TEST_F(Report, GapsAreWrittenAndReported) {
  constexpr std::string_view input =
      "id,time_s,x,y,z\na,0,0,0,0\na,1,1,0,0\na,60,9,0,0\nb,0,0,50,0\nb,60,0,50,0\n";
  const Page joined = reported({"--max-gap", "never"}, input);
  EXPECT_TRUE(joined.numbers(joined.swarm()["absent_after"]).empty());
  const Page page = reported({"--max-gap", "10"}, input);
  EXPECT_EQ(page.numbers(page.swarm()["absent_after"]), (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(text_of(page.risk()["unknown"]), "2 bees unknown for 1 min 59 s in all");
  const auto notes = report_test::texts_of(page.swarm()["notes"]);
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note ==
           "bees are unknown between two fixes that are farther apart in time than 10 s "
           "(--max-gap); the longest such gap: b from 0.00 s for 1 min";
  }));
}

// One show of two, 3 m beside each other, that declares how far apart they are to be.
TEST_F(Report, AShowIsJudgedByWhatItDeclares) {
  const auto drone = [](const char* name, const char* y) {
    return std::string(R"({"type": "generic", "settings": {"name": ")") + name +
           R"(", "trajectory": {"version": 1, "points": [[0, [0, )" + y + R"(, 0], []], [2, [0, )" +
           y + R"(, 10], []], [9, [0, )" + y + ", 0], []]]}}}";
  };
  const std::string show = folder_.file(
      "show.json", R"({"version": 1, "settings": {"validation": {"minDistance": 3.5}}, )"
                   R"("swarm": {"drones": [)" +
                       drone("left", "0") + "," + drone("right", "3") + "]}}");
  const Page page = reported({show});
  EXPECT_EQ(double(page.swarm()["threshold_m"]), 3.5);
  EXPECT_EQ(std::uint64_t(page.risk()["conflicts"]), 1u);
  EXPECT_EQ(page.names(), (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(double(reported({show, "--threshold", "2"}).swarm()["threshold_m"]), 2.0);
}

TEST_F(Report, AircraftOfOneInstantAreASnapshot) {
  const std::string aircraft =
      R"({"now": 1000000.5, "messages": 7, "aircraft": [
        {"hex":"a","alt_geom":0,"gs":360,"track":90,"geom_rate":0,"lat":1,"lon":2,"seen_pos":10},
        {"hex":"b","alt_geom":0,"gs":0,"track":0,"geom_rate":0,"lat":1,"lon":2,"seen_pos":0}]})";
  const Page page = reported({"--threshold", "3000"}, aircraft);
  EXPECT_EQ(text_of(page.swarm()["kind"]), "snapshot");
  EXPECT_EQ(page.names(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(at_risk_in(page).size(), 2u);
  // 10 s at 360 knots, which the first has flown since.
  EXPECT_NEAR(double(page.risk()["closest"]["distance_m"]), 1'852.0, 1.0);
}

TEST_F(Report, DegreesAreShownEastNorthAndHeight) {
  const Page page = reported({"--threshold", "20"},
                             "lon,lat,height\n-75.5,6.25,1500\n-75.4999,6.25,1500\n"
                             "-75.5,6.2501,1500\n-75.5,6.25,1510\n");
  EXPECT_EQ(report_test::texts_of(page.swarm()["axes"]),
            (std::vector<std::string>{"east", "north", "height"}));
  const auto origin = page.swarm()["origin"].value();
  EXPECT_NEAR(double(origin["longitude_deg"]), -75.5, 1e-3);
  EXPECT_NEAR(double(origin["latitude_deg"]), 6.25, 1e-3);
  EXPECT_EQ(double(origin["height_m"]), 0.0);
  const auto x = page.values(page.swarm()["positions"]["x"]);
  const auto y = page.values(page.swarm()["positions"]["y"]);
  const auto z = page.values(page.swarm()["positions"]["z"]);
  const double error_m = 2.0 * double(page.swarm()["position_error_m"]) + 1e-6;
  EXPECT_LT(error_m, 0.01);
  // A ten-thousandth of a degree each: of the equator's 111.3 km less the latitude, of 110.6 km.
  EXPECT_NEAR(x.at(1) - x.at(0), 11.07, 0.01);
  EXPECT_NEAR(y.at(1) - y.at(0), 0.0, error_m);
  EXPECT_NEAR(y.at(2) - y.at(0), 11.06, 0.01);
  EXPECT_NEAR(z.at(3) - z.at(0), 10.0, error_m);
  EXPECT_NEAR(z.at(0), 1'500.0, 0.01);
}

TEST_F(Report, MetresHaveNoOrigin) {
  const Page page = reported({}, "x,y,z\n0,0,0\n1,2,3\n");
  EXPECT_EQ(report_test::texts_of(page.swarm()["axes"]), (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_FALSE(has(page.swarm(), "origin"));
}

TEST_F(Report, DegreesAreJudgedAsByDetectWithAVerticalThresholdToo) {
  const std::string input = run({"generate", "--area", "medellin", "--points", "500"}).out;
  expect_as_detect({"--threshold", "500"}, input);
  expect_as_detect({"--threshold", "700", "--vertical", "30"}, input);
}

TEST_F(Report, TwoAreShownBesideEachOther) {
  const std::string before = folder_.file("before.csv", "x,y,z\n0,0,0\n1,0,0\n");
  const std::string after = folder_.file("after.csv", "x,y,z\n0,0,0\n9,0,0\n5,0,0\n");
  const Page page = reported({before, "--compare", after, "--threshold", "2"});
  ASSERT_EQ(page.swarms(), 2u);
  EXPECT_EQ(text_of(page.swarm(0)["title"]), "before.csv");
  EXPECT_EQ(text_of(page.swarm(1)["title"]), "after.csv");
  EXPECT_EQ(std::uint64_t(page.swarm(0)["risk"]["at_risk"]), 2u);
  EXPECT_EQ(std::uint64_t(page.swarm(1)["risk"]["at_risk"]), 0u);
  const Page alone = reported({after, "--threshold", "2"});
  EXPECT_EQ(page.values(page.swarm(1)["positions"]["x"]),
            alone.values(alone.swarm()["positions"]["x"]));
  EXPECT_EQ(reported({"--compare", after}, "x,y,z\n0,0,0\n").swarms(), 2u);
  const std::string flown = folder_.file("flown.csv", flights());
  EXPECT_EQ(text_of(reported({flown, "--compare", flown}).swarm(1)["kind"]), "recording");
}

TEST_F(Report, TwoInDegreesAreShownInTheSamePlace) {
  const std::string before = folder_.file("before.csv", "lon,lat,height\n-75.5,6.25,1500\n");
  const std::string after = folder_.file("after.csv", "lon,lat,height\n-75.4999,6.25,1500\n");
  const Page page = reported({before, "--compare", after});
  const auto east = [&](std::size_t which) {
    return page.values(page.swarm(which)["positions"]["x"]).at(0);
  };
  EXPECT_NEAR(east(1) - east(0), 11.07, 0.01);
  EXPECT_EQ(simdjson::minify(page.swarm(0)["origin"].value()),
            simdjson::minify(page.swarm(1)["origin"].value()));
}

TEST_F(Report, TheSameInputMakesTheSameBytesWithAnyThreads) {
  for (const std::string& input : {swarm_of("3000", "100"), flights()}) {
    const std::string once = run({"report", "--threads", "1", "--threshold", "5"}, input).out;
    EXPECT_FALSE(once.empty());
    EXPECT_TRUE(once == run({"report", "--threads", "1", "--threshold", "5"}, input).out);
    EXPECT_TRUE(once == run({"report", "--threads", "2", "--threshold", "5"}, input).out);
    const std::string path = folder_.path("page.html");
    EXPECT_EQ(run({"report", "--threshold", "5", "-o", path, "--quiet"}, input).exit_code, 0);
    EXPECT_TRUE(once == folder_.read("page.html"));
  }
}

}  // namespace
}  // namespace beespace::cli_test
