// --separation: minima that are usual in aviation, by name, in every command that takes two
// thresholds.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

struct Usual {
  const char* name;
  const char* threshold;
  const char* vertical;
  const char* said;
};

constexpr Usual kUsual[] = {
    {"enroute", "5NM", "1000ft",
     "threshold  horizontally 9260 m, 5 NM (closer than), and in height 304.8 m, 1000 ft (closer "
     "than), which is enroute (ICAO Doc 4444)\n"},
    {"terminal", "3NM", "1000ft",
     "threshold  horizontally 5556 m, 3 NM (closer than), and in height 304.8 m, 1000 ft (closer "
     "than), which is terminal (ICAO Doc 4444)\n"},
    {"well-clear-suas", "2000ft", "250ft",
     "threshold  horizontally 609.6 m, 2000 ft (closer than), and in height 76.2 m, 250 ft (closer "
     "than), which is well-clear-suas (ASTM F3442)\n"},
    {"nmac", "500ft", "100ft",
     "threshold  horizontally 152.4 m, 500 ft (closer than), and in height 30.48 m, 100 ft (closer "
     "than), which is nmac (RTCA DO-365)\n"}};

// One second of flight side by side: so many metres apart along the equator (a degree is 111,319.49
// m there), and so many feet in height.
std::string two(double metres, double feet) {
  const std::string apart = std::to_string(1.0 + metres / 111'319.49079);
  const std::string above = std::to_string(10'000 + feet);
  std::string text = "id,time_s,lon,lat,alt_ft,ve,vn,vu\n";
  for (const char* const time : {"0", "1"}) {
    text.append("a,").append(time).append(",1,0,10000,0,0,0\n");
    text.append("b,").append(time).append(",").append(apart).append(",0,").append(above);
    text.append(",0,0,0\n");
  }
  return text;
}

// Whether `beespace predict` and `replay` find a conflict of the two.
void expect_conflict(const char* name, double metres, double feet, bool conflict) {
  for (const char* const command : {"predict", "replay"}) {
    const Finished finished = run({command, "--separation", name}, two(metres, feet));
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_EQ(rows_of(finished.out).size(), conflict ? 1u : 0u)
        << command << " " << name << " " << metres << " m " << feet << " ft";
  }
}

TEST(Separation, InConflictIsWhoIsHorizontallyAndVerticallyCloser) {
  const struct {
    const char* name;
    double metres;
    double feet;
  } minima[] = {{"enroute", 9260, 1000},
                {"terminal", 5556, 1000},
                {"well-clear-suas", 609.6, 250},
                {"nmac", 152.4, 100}};
  for (const auto& of : minima) {
    expect_conflict(of.name, of.metres - 1, of.feet - 1, true);
    expect_conflict(of.name, of.metres + 1, of.feet - 1, false);
    expect_conflict(of.name, of.metres - 1, of.feet + 1, false);
    expect_conflict(of.name, of.metres - 1, of.feet, false);
    expect_conflict(of.name, of.metres + 1, 0, false);
    expect_conflict(of.name, 0, of.feet + 1, false);
  }
}

TEST(Separation, IsWhatItsTwoThresholdsAreInEveryCommand) {
  const std::string input = two(100, 50);
  for (const Usual& usual : kUsual) {
    for (const char* const command : {"predict", "replay", "watch"}) {
      const Finished named = run({command, "--separation", usual.name}, input);
      const Finished typed =
          run({command, "--threshold", usual.threshold, "--vertical", usual.vertical}, input);
      EXPECT_EQ(named.exit_code, 0) << named.err;
      EXPECT_EQ(named.out, typed.out) << command;
      EXPECT_GE(lines_of(named.out).size(), 2u) << named.out;
      expect_parts(named.err, {usual.said});
    }
  }
}

TEST(Separation, OfASnapshot) {
  const std::string input = "id,lon,lat,alt_ft\na,0,0,10000\nb,0.0008,0,10099\nc,0,0,10100\n";
  const Finished pairs =
      run({"detect", "--separation", "nmac", "--report", "pairs", "--quiet"}, input);
  ASSERT_EQ(rows_of(pairs.out).size(), 2u) << pairs.err;
  EXPECT_EQ(rows_of(pairs.out)[0][0] + rows_of(pairs.out)[0][1], "ab");
  EXPECT_EQ(rows_of(pairs.out)[1][0] + rows_of(pairs.out)[1][1], "bc");
  for (const Usual& usual : kUsual) {
    expect_parts(run({"detect", "--separation", usual.name}, input).err, {usual.said});
  }
  expect_parts(run({"detect", "--separation", "nmac", "--inclusive"}, input).err,
               {"horizontally 152.4 m, 500 ft or closer, and in height 30.48 m, 100 ft or closer, "
                "which is nmac (RTCA DO-365)\n",
                "at risk    3 (100.0 %)"});
}

TEST(Separation, OfPicturesAndFilesForMaps) {
  const TemporaryFolder folder;
  const std::string input = folder.file("two.csv", two(100, 50));
  for (const char* const command : {"plot", "export"}) {
    const std::string output = folder.path(std::string(command) == "plot" ? "two.svg" : "two.kml");
    const Finished finished =
        run({command, input, "--separation", "enroute", "--output", output, "--fail-on-risk"});
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    expect_parts(finished.err, {kUsual[0].said});
  }
}

TEST(Separation, IsRefusedBesideAThreshold) {
  const std::string both =
      "--separation enroute is --threshold '5 NM' and --vertical '1000 ft', but ";
  for (const char* const command :
       {"detect", "predict", "replay", "watch", "report", "plot", "export", "view"}) {
    const std::string help = std::string(" (see 'beespace ") + command + " --help')\n";
    Arguments some = {command, "-", "--separation", "enroute"};
    if (std::string(command) == "plot") some = some + Arguments{"--output", "x.svg"};
    if (std::string(command) == "export") some = some + Arguments{"--output", "x.kml"};
    expect_failure(some + Arguments{"--threshold", "5NM"}, two(1, 1), 2,
                   both + "--threshold is given too; leave one of the two out" + help);
    expect_failure(some + Arguments{"--vertical", "1000ft"}, two(1, 1), 2,
                   both + "--vertical is given too; leave one of the two out" + help);
  }
}

TEST(Separation, OtherNamesAndReportsWithoutAHeightAreRefused) {
  const Finished other = run({"predict", "--separation", "en-route"}, two(1, 1));
  EXPECT_EQ(other.exit_code, 2);
  expect_parts(other.err, {"'en-route' is none of enroute, terminal, well-clear-suas, nmac; did "
                           "you mean 'enroute'?"});
  const Finished closest =
      run({"detect", "--separation", "nmac", "--report", "closest-pair"}, two(1, 1));
  EXPECT_EQ(closest.exit_code, 2);
  expect_parts(closest.err, {"--separation does not apply to --report closest-pair"});
  const Finished advice = run({"watch", "--separation", "nmac", "--advise"}, two(1, 1));
  EXPECT_EQ(advice.exit_code, 2);
  expect_parts(advice.err, {"leave --separation out"});
}

}  // namespace
}  // namespace beespace::cli_test
