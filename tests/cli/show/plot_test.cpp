// Pictures: `beespace plot`.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"
#include "tests/cli/run/xml_check.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kBees =
    "id,x,y,z\nmaya,0,0,0\nwilli,60,0,0\n\"<b>&\"\"x\"\"]]>\",60,20,0\nflip,2000,900,100\n";
constexpr std::string_view kFlight =
    "id,time_s,x,y,z\na,0,0,0,10\na,100,100,0,10\nb,0,100,3,10\nb,100,0,3,10\n";

std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

bool draws_png() {
  const TemporaryFolder folder;
  const std::string bees = folder.file("bees.csv", kBees);
  const Finished finished = run({"plot", bees, "-o", folder.path("x.png")});
  return finished.err.find("cairo") == std::string::npos;
}

class Plot : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string bees_ = folder_.file("bees.csv", kBees);
  std::string flight_ = folder_.file("flight.csv", kFlight);
};

TEST_F(Plot, ItsSummaryPlaysNoTricksOnATerminal) {
  const std::string name = folder_.path("o\x1b[31mut.svg");
  const std::string bees = folder_.file("b\x1b[31mees.csv", "id,x,y,z\nmaya,0,0,0\nwilli,60,0,0\n");
  const Finished finished = run({"plot", bees, "-o", name});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.err.find('\x1b'), std::string::npos) << finished.err;
  expect_parts(finished.err, {"[31mut.svg"});
}

// Whatever the zone of a clock is, it is not UTC because none is named.
TEST_F(Plot, TellsTimesInTheZoneThatWasNamedOrAsTheyStandInTheFile) {
  const std::string table =
      "id,time,x_m,y_m\na,2024-07-01 12:00:00,0,0\na,2024-07-01 12:00:20,20,0\n"
      "b,2024-07-01 12:00:00,10,3\nb,2024-07-01 12:00:20,10,3\n";
  const Arguments question = {"--threshold", "5", "--max-gap", "never"};
  const std::string bare = run(Arguments{"plot"} + question, table).out;
  expect_parts(bare, {"Time (as in the file, from 2024-07-01)", " at 12:00:10,"});
  EXPECT_EQ(bare.find("Time (UTC"), std::string::npos);
  const Arguments berlin = question + Arguments{"--time-zone", "Europe/Berlin"};
  expect_parts(run(Arguments{"plot"} + berlin, table).out,
               {"Time (Europe/Berlin, +02:00, from 2024-07-01)", " at 12:00:10+02:00,"});
  expect_parts(run(Arguments{"export", "--format", "csv"} + question, table).out,
               {",begins,closest,ends,", ",2024-07-01 12:00:10,"});
  expect_parts(run(Arguments{"export", "--format", "csv"} + berlin, table).out,
               {",2024-07-01T12:00:10+02:00,"});
}

TEST_F(Plot, OfASnapshotMarksThoseAtRiskByTheirIds) {
  const Finished finished = run({"plot", bees_, "-o", folder_.path("bees.svg")});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, "");
  const std::string svg = folder_.read("bees.svg");
  EXPECT_TRUE(is_xml(svg));
  EXPECT_EQ(count_of(svg, "<title>maya</title>"), 2u);  // from above and from the side
  EXPECT_EQ(count_of(svg, "<title>&lt;b&gt;&amp;&quot;x&quot;]]&gt;</title>"), 2u);
  EXPECT_EQ(count_of(svg, "<title>flip</title>"), 0u);
  EXPECT_EQ(count_of(svg, "<circle"), 1u + 2u + 2u);  // the key, flip, and the rings
  expect_parts(svg, {"4 bees. 3 are at risk: 3 pairs closer than 100 m, in 1 group.",
                     "threshold 100 m", "closest: 20 m", "x (m)", "y (m)", "z (m)"});
  expect_parts(finished.err, {"bees.csv", "3 of 4", "bees.svg ("});
}

TEST_F(Plot, OfARecordingShowsPathsAndSeparation) {
  const Finished finished = run({"plot", flight_, "--threshold", "5", "--quiet"});
  ASSERT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.err, "");
  EXPECT_TRUE(is_xml(finished.out));
  expect_parts(finished.out, {"1 conflict of 1 pair: closer than 5 m", "closest: 3 m", "a \u2013 b",
                              "3.000 m at 50.0 s", "The closest two", "Time (s)"});
}

TEST_F(Plot, IsTheSameEveryTimeAndFromStandardInput) {
  const std::string once = run({"plot", bees_, "--quiet", "--title", "t"}).out;
  EXPECT_EQ(run({"plot", bees_, "--quiet", "--title", "t", "--threads", "3"}).out, once);
  EXPECT_EQ(run({"plot", "--quiet", "--title", "t", "-o", "-"}, kBees).out, once);
}

TEST_F(Plot, TakesATitleAndAWidth) {
  const std::string svg =
      run({"plot", bees_, "--quiet", "--title", "Opening <night>", "--width", "640"}).out;
  expect_parts(svg, {">Opening &lt;night&gt;</text>", " width=\"640\""});
  EXPECT_EQ(svg.find("bees.csv"), std::string::npos);
}

TEST_F(Plot, AsPngHasTheWidthAskedFor) {
  if (!draws_png()) GTEST_SKIP() << "there is no cairo";
  const Finished finished =
      run({"plot", bees_, "-o", folder_.path("bees.PNG"), "--width", "700", "--quiet"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const std::string png = folder_.read("bees.PNG");
  ASSERT_GT(png.size(), 1'000u);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1A\n");
  const auto byte = [&png](std::size_t i) { return static_cast<std::uint8_t>(png[i]); };
  EXPECT_EQ(byte(18) * 256u + byte(19), 700u);
}

TEST_F(Plot, FailsOnRiskWhereAskedTo) {
  EXPECT_EQ(run({"plot", bees_, "--quiet", "--fail-on-risk"}).exit_code, 1);
  EXPECT_EQ(run({"plot", bees_, "--quiet", "--fail-on-risk", "--threshold", "1"}).exit_code, 0);
}

TEST_F(Plot, RefusesWhatMakesNoPicture) {
  expect_usage_error({"plot", bees_, "-o", "x.pdf"},
                     "a picture's name ends in .svg or .png, unlike 'x.pdf'");
  expect_usage_error({"plot", bees_, "-o", "x"}, "a picture's name ends in .svg or .png");
  for (const char* width : {"199", "10001", "12.5", "-3", "wide"}) {
    expect_usage_error({"plot", bees_, "--width", width},
                       "--width must be a whole number of pixels from 200 to 10000");
  }
  EXPECT_TRUE(folder_.names() == (std::vector<std::string>{"bees.csv", "flight.csv"}));
}

TEST_F(Plot, OfBadInputNothingIsWritten) {
  const std::string bad = folder_.file("bad.csv", "id,x,y,z\na,1,2,three\n");
  const Finished finished = run({"plot", bad, "-o", folder_.path("bad.svg"), "--json"});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"bad.csv", "bees.csv", "flight.csv"}));
}

TEST_F(Plot, OfManyBeesStaysSmall) {
  const std::string many = folder_.path("many.csv");
  ASSERT_EQ(run({"generate", "--points", "50000", "--size", "2000", "--output", many, "--quiet"})
                .exit_code,
            0);
  const Finished finished = run({"plot", many, "--threshold", "30", "--quiet"});
  EXPECT_LT(finished.out.size(), 2'000'000u);
  EXPECT_TRUE(is_xml(finished.out));
  expect_parts(finished.out, {"50,000 bees.", "bees in a cell: 1 to ", "area by their number"});
}

}  // namespace
}  // namespace beespace::cli_test
