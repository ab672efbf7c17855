// Tables of animals as their tools write them, by the first command that somebody would type. The
// distances are those that make-tables, beside the tables, finds by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

std::string table(const std::string& name) {
  return std::string(BEESPACE_ANIMAL_TABLES "/") + name;
}

// Of each row the closest instant and distance.
void expect_closest(const Finished& finished, const std::string& first, const std::string& second,
                    double closest_s, double closest_m) {
  for (const auto& row : rows_of(finished.out, ',')) {
    if (row.size() < 5 || row[0] != first || row[1] != second) continue;
    if (std::abs(std::stod(row[4]) - closest_m) > 1e-5) continue;
    EXPECT_NEAR(std::stod(row[3]), closest_s, 1e-4);
    return;
  }
  ADD_FAILURE() << first << " and " << second << " are not " << closest_m << " m apart in\n"
                << finished.out << finished.err;
}

// Movebank's times are UTC, its ids the individuals; outliers, records without a place and tags on
// no animal are counted.
// A collar that fails while its animal rests is known nowhere from then on: it does not land.
TEST(Animals, WhoseTrackEndsAtRestAreNotKnownFromThenOn) {
  std::string text = "timestamp,individual-local-identifier,location-long,location-lat\n";
  for (int hour = 0; hour < 48; ++hour) {
    const std::string time = (hour < 24 ? "2024-06-01 " : "2024-06-02 ") +
                             std::string(hour % 24 < 10 ? "0" : "") + std::to_string(hour % 24) +
                             ":00:00.000";
    if (hour < 20) text += time + ",deer1,13.4,48.9\n";
    text += time + ",deer2,13.5," + std::to_string(48.9 + 0.001 * hour) + "\n";
    text += time + ",deer3,13.6," + std::to_string(48.9 - 0.001 * hour) + "\n";
  }
  const Finished finished =
      run({"replay", "--threshold", "50", "--time-zone", "UTC", "--fail-on-risk"}, text);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"no conflict in the known time", "vanishes on its way: deer1"});
}

TEST(Animals, MovebankIsReadAsItComes) {
  const Finished finished = run({"replay", table("movebank.csv"), "--threshold", "100", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_closest(finished, "Anna", "Bert", 1441869883.778540, 54.132138);
  expect_parts(finished.err,
               {"are of UTC: the header is that of Movebank", "bees       2\n",
                "above the WGS84 ellipsoid", "heights in m",
                "1 record marked as outliers (visible=false, ...-marked-outlier=true) is left out",
                "1 record without a place (empty, NA or NaN) is left out",
                "1 record whose id of an animal is empty (of tags that are on none) is left",
                "1 record of unknown bees: it is not said whose they are",
                "from       2015-09-10T07:00:00.000Z to 2015-09-10T07:55:00.000Z",
                "at 2015-09-10T07:24:43.779Z"});
}

// Of one name in two studies, and a metre apart: two animals.
TEST(Animals, AnimalsOfOneNameInTwoStudiesAreTwo) {
  const std::string table =
      "event-id,visible,timestamp,location-long,location-lat,individual-local-identifier,"
      "study-name\n1,true,2015-09-10 07:00:00.000,9.17,47.7,x,S1\n"
      "2,true,2015-09-10 07:05:00.000,9.17,47.7,x,S1\n"
      "3,true,2015-09-10 07:01:00.000,9.17001,47.7,x,S2\n"
      "4,true,2015-09-10 07:06:00.000,9.17001,47.7,x,S2\n";
  const Finished finished = run({"replay", "--threshold", "5", "--csv", "--fail-on-risk"}, table);
  EXPECT_EQ(finished.exit_code, 1);
  expect_closest(finished, "x", "x (S2)", 1441868460.0, 0.750570);
  // Beyond memory, too.
  EXPECT_EQ(
      run({"replay", "--threshold", "5", "--fail-on-risk", "--memory", "17MB", "--threads", "1"},
          table)
          .exit_code,
      1);
}

// Outliers are no places: where an animal has no other, nothing is known of it.
TEST(Animals, AnAnimalOfOutliersOnlyIsNoAllClear) {
  const std::string header =
      "event-id,visible,timestamp,location-long,location-lat,individual-local-identifier\n";
  const std::string seen =
      "1,true,2015-09-10 07:00:00.000,9.17,47.7,b\n2,true,2015-09-10 07:05:00.000,9.17,47.7,b\n"
      "1,true,2015-09-10 07:00:00.000,9.18,47.7,c\n2,true,2015-09-10 07:05:00.000,9.18,47.7,c\n";
  const auto replayed = [&](const std::string& more) {
    return run({"replay", "--threshold", "5", "--fail-on-risk"}, header + seen + more);
  };
  const Finished nowhere = replayed("3,FALSE,2015-09-10 07:00:00.000,9.17,47.7,a\n");
  EXPECT_EQ(nowhere.exit_code, 1);
  expect_parts(nowhere.err,
               {"1 record marked as outliers (visible=false, ...-marked-outlier=true) is left out",
                "known nowhere: a"});
  const Finished one = replayed("3,FALSE,2015-09-10 07:02:00.000,9.17,47.7,c\n");
  EXPECT_EQ(one.exit_code, 0) << one.err;
  expect_parts(
      one.err,
      {"1 record marked as outliers (visible=false, ...-marked-outlier=true) is left out"});
}

TEST(Animals, TimesAreToldInTheZoneThatIsAskedFor) {
  const Finished finished =
      run({"replay", table("movebank.csv"), "--threshold", "100", "--time-zone", "+02:00"});
  // Movebank's are in UTC, whichever zone times are told in.
  expect_parts(finished.err, {"are of UTC: the header is that of Movebank",
                              "from       2015-09-10T09:00:00.000+02:00 to"});
  const Finished told =
      run({"replay", "--threshold", "1", "--time-zone", "+02:00"},
          "id,time,x_m,y_m\na,2015-09-10T07:00:00Z,0,0\na,2015-09-10T07:00:02Z,2,0\n"
          "b,2015-09-10T07:00:00Z,0,1.5\nb,2015-09-10T07:00:02Z,0,-1\n");
  expect_parts(told.err, {"from       2015-09-10T09:00:00.000+02:00 to"});
}

// Packages of R write dots for hyphens, and NA where nothing is known: of heights, of all of them.
TEST(Animals, MovebankFromRIsFlatWhereHeightsAreEmpty) {
  const Finished finished = run({"replay", table("movebank_r.csv"), "--threshold", "100", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_closest(finished, "Anna", "Bert", 1441869878.285584, 53.565826);
  expect_parts(finished.err, {"'height.above.ellipsoid' is empty throughout",
                              "WGS84 longitude, latitude, without heights"});
  const Finished json = run({"replay", table("movebank_r.csv"), "--json"});
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {"\"dimensions\": 2", "\"heights\": null"});
}

// What no header says is asked for, all at once; then the answer is right.
TEST(Animals, FramesAndPixelsAreAskedForAndThenRead) {
  const Finished asked = run({"replay", table("pixels.csv"), "--threshold", "3mm"});
  EXPECT_EQ(asked.exit_code, 2);
  expect_parts(asked.err, {"column 1 'frame' counts the frames of a video", "--fps 25",
                           "are they pixels?", "--scale 0.1mm"});
  const Finished picture =
      run({"plot"}, "frame,bee_id,x_mm,y_mm\n0,0,331.6,103.7\n1,0,331.7,103\n");
  EXPECT_EQ(picture.exit_code, 2);
  expect_parts(picture.err, {"column 1 'frame' counts the frames of a video", "--fps 25"});
  const Finished finished = run({"replay", table("pixels.csv"), "--threshold", "3mm", "--fps", "25",
                                 "--scale", "0.1mm", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_closest(finished, "1", "2", 1.871660, 0.002797);
  expect_closest(finished, "1", "3", 2.080000, 0.001867);
  EXPECT_EQ(rows_of(finished.out, ',').size(), 3u) << finished.out;
  expect_parts(finished.err, {"as frames, 25 a second (--fps)", "in px: 0.1 mm each",
                              "metres, in a plane", "2.8 mm apart", "1 bee in 1 gap"});
}

// Of a video, whose rows count downwards: pictures and pages are drawn so.
TEST(Animals, PicturesAndPagesOfPixelsAreDrawnAsTheVideoIs) {
  const Arguments of_pixels = {table("pixels.csv"), "--threshold", "3mm", "--fps", "25",
                               "--scale",           "0.1mm"};
  expect_parts(run(Arguments{"plot"} + of_pixels).out, {"As in the video, y downward"});
  const std::string said = R"("y_down":true)";
  EXPECT_NE(run(Arguments{"report"} + of_pixels).out.find(said), std::string::npos);
  EXPECT_EQ(run({"report", table("movebank.csv")}).out.find(said), std::string::npos);
}

TEST(Animals, AColumnOfFramesGoesWithFps) {
  const std::string rows = "time_s,id,x_cm,y_cm\n0,a,1,2\n1,a,2,2\n";
  expect_failure({"replay", "--fps", "25"}, rows, 2,
                 "<stdin>: --fps is given, but no column counts frames; leave it out, or say which "
                 "does with --columns frame=N (the columns are 1 'time_s', 2 'id', 3 'x_cm', 4 "
                 "'y_cm')");
  const Finished scaled = run({"replay", "--scale", "2"}, rows);
  EXPECT_EQ(scaled.exit_code, 2);
  expect_parts(scaled.err, {"'x_cm' names its unit, cm, but --scale is for pixels"});
  const Finished pixels = run({"replay"}, "time_s,id,x_px,y_px\n0,a,1,2\n1,a,2,2\n");
  EXPECT_EQ(pixels.exit_code, 2);
  expect_parts(pixels.err, {"column 'x_px' is in pixels: say how long one is"});
}

// A second without a place is a second without a record: what is longer than a gap is one.
TEST(Animals, TrackdfHasNaAndTimesOfAClock) {
  const Finished finished = run({"replay", table("trackdf.csv"), "--threshold", "30", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_closest(finished, "1", "2", 43246.791501, 27.968892);
  expect_closest(finished, "1", "3", 43252.000000, 18.673202);
  expect_parts(finished.err, {"22 records without a place (empty, NA or NaN) are left out",
                              "1 bee in 1 gap", "their time zone is not known",
                              "from       2021-03-01 12:00:00.000 to 2021-03-01 12:01:14.000",
                              "at 2021-03-01 12:00:52.000"});
  const Finished zoned =
      run({"replay", table("trackdf.csv"), "--threshold", "30", "--time-zone", "UTC", "--csv"});
  expect_closest(zoned, "1", "2", 1614556800.0 + 43246.791501, 27.968892);
  const Finished json = run({"replay", table("trackdf.csv"), "--json"});
  expect_parts(json.out, {R"("times": "seconds since 2021-03-01 00:00:00 of a clock whose time )"
                          R"(zone is not known")"});
}

TEST(Animals, WhoIsNowhereIsNoAllClear) {
  const Finished finished = run({"replay", "--fail-on-risk", "--threshold", "1"},
                                "id,time_s,x,y\na,0,0,0\na,1,1,0\nb,0,NA,NA\nb,1,,\n"
                                "c,0,50,0\nc,1,51,0\n");
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"2 records without a place", "known nowhere"});
}

TEST(Animals, IdtrackerHasColumnsForEachAnimal) {
  const Finished asked = run({"replay", table("idtracker.csv"), "--threshold", "3mm"});
  EXPECT_EQ(asked.exit_code, 2);
  expect_parts(asked.err, {"--scale 0.1mm"});
  const Finished finished =
      run({"replay", table("idtracker.csv"), "--threshold", "3mm", "--scale", "0.1mm", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_closest(finished, "1", "2", 1.871660, 0.002797);
  expect_closest(finished, "1", "3", 2.080000, 0.001867);
  expect_parts(finished.err,
               {"columns of 3 animals", "22 records without a place", "bees       3"});
  const Finished bad =
      run({"replay", "--scale", "1"}, "time,x1,y1,x2,y2\n0,1,2,3,4\n\n1,1,2,3,b\n");
  EXPECT_EQ(bad.exit_code, 3);
  expect_parts(bad.err, {"<stdin>:4: 'y': 'b' is not a number"});
  const Finished rows = run({"replay", "--scale", "1", "--fps", "2", "--threshold", "9"},
                            "x1,y1,x2,y2\n0,0,8,0\n2,0,6,0\n");
  expect_parts(rows.err, {"rows are taken for frames", "4.000 m apart at 0.50 s"});
  const Finished sure = run({"replay", "--scale", "1", "--fps", "2", "--threshold", "9"},
                            "X1\tY1\tProbId1\tX2\tY2\tProbId2\n0\t0\t0.99\t8\t0\t0.9\n"
                            "2\t0\t0.99\t6\t0\tNaN\n");
  expect_parts(sure.err, {"2 animals stand beside each other, as idTracker writes them",
                          "4.000 m apart at 0.50 s"});
  const Finished pictures = run({"replay", "--scale", "1", "--fps", "2", "--threshold", "9"},
                                "position,x0,y0,x1,y1\n0,0,0,8,0\n1,2,0,6,0\n");
  expect_parts(pictures.err, {"4.000 m apart at 0.50 s"});
}

// A file an individual; where it was not seen it is at infinity.
TEST(Animals, TrexHasAFileForEachFish) {
  const TemporaryFolder folder;
  const std::string header =
      "frame,time,X (cm),Y (cm),X#wcentroid (cm),Y#wcentroid (cm),SPEED (cm/s),missing\n";
  folder.file("tank_fish0.csv", header +
                                    "0,0,9,9,1,2,0,0\n1,0.04,9,9,1.1,2,2.5,0\n"
                                    "2,0.08,inf,inf,inf,inf,inf,1\n");
  folder.file("tank_fish1.csv", header + "0,0,9,9,1,3,0,0\n1,0.04,9,9,1.1,2.5,12.5,0\n");
  const Finished finished = run({"replay", folder.path(""), "--threshold", "6mm", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_closest(finished, "tank_fish0", "tank_fish1", 0.04, 0.005);
  expect_parts(finished.err, {"x and y in cm", "1 record without a place", "5.0 mm apart"});
}

TEST(Animals, DateAndTimeMayHaveColumnsOfTheirOwn) {
  const Finished finished = run({"replay", table("logger.csv"), "--threshold", "50", "--max-gap",
                                 "3000", "--time-zone", "Europe/Madrid", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_closest(finished, "rook", "crow", 1445745800.000099, 11.104232);
  expect_parts(finished.err, {"and the day from column 1 'date'", "Europe/Madrid",
                              "from       2015-10-25T04:30:00.000+01:00 to"});
}

TEST(Animals, TimesOfDayAloneAreOfOneDay) {
  const std::string rows =
      "time,id,x_m,y_m\n07:00:00,a,0,0\n07:00:02,a,2,0\n7:00:00,b,0,1\n"
      "07:00:02,b,2,-1\n";
  const Finished finished = run({"replay", "--threshold", "1", "--csv"}, rows);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_closest(finished, "a", "b", 25201.0, 0.0);
  expect_parts(finished.err, {"times of day", "from       07:00:00.000 to 07:00:02.000"});
  const Finished midnight = run({"replay"}, "time,id,x_m,y_m\n23:59:59,a,0,0\n00:00:01,a,2,0\n");
  EXPECT_EQ(midnight.exit_code, 3);
  expect_parts(midnight.err,
               {"<stdin>:3:1: ", "as if another day had begun", "column with the date"});
}

// An hour that clocks show twice, or never, is not guessed.
TEST(Animals, TimesThatAreTwiceOrNeverAreErrors) {
  const auto at = [](const std::string& time) {
    return run({"replay", "--time-zone", "Europe/Madrid"},
               "timestamp,id,x_m,y_m\n2015-03-28 00:00:00,a,0,0\n" + time + ",a,1,0\n");
  };
  const Finished twice = at("2015-10-25 02:30:00");
  EXPECT_EQ(twice.exit_code, 3);
  expect_parts(twice.err, {"<stdin>:3:1: '2015-10-25 02:30:00' is not a time: clocks of "
                           "Europe/Madrid show it twice",
                           "write +02:00 or +01:00 behind it"});
  const Finished never = at("2015-03-29 02:30:00");
  EXPECT_EQ(never.exit_code, 3);
  expect_parts(never.err, {"clocks of Europe/Madrid never show it", "--time-zone +01:00"});
  EXPECT_EQ(at("2015-10-25 02:30:00+01:00").exit_code, 0);
  EXPECT_EQ(at("2015-10-25 02:30:00 UTC").exit_code, 0);
  expect_usage_error({"replay", "--time-zone", "Europe/Nowhere", "x.csv"},
                     "--time-zone: 'Europe/Nowhere' is no time zone: the zone data of this system "
                     "has none of that name; write UTC, a place as in Europe/Madrid, or an offset "
                     "as in +02:00 (see 'beespace replay --help')");
}

TEST(Animals, ClocksDoNotMix) {
  const TemporaryFolder folder;
  const std::string zoned =
      folder.file("zoned.csv", "timestamp,id,x_m,y_m\n2015-03-28 00:00:00Z,a,0,0\n");
  const std::string bare =
      folder.file("bare.csv", "timestamp,id,x_m,y_m\n2015-03-28 00:00:00,b,0,0\n");
  const Finished finished = run({"replay", zoned, bare});
  EXPECT_EQ(finished.exit_code, 2);
  expect_parts(finished.err, {"--time-zone"});
  EXPECT_EQ(run({"replay", zoned, bare, "--time-zone", "UTC"}).exit_code, 0);
  // Files of one clock count from one midnight.
  const std::string next =
      folder.file("next.csv", "timestamp,id,x_m,y_m\n2015-03-29 00:00:00,b,0,0\n");
  const Finished days = run({"replay", bare, next});
  expect_parts(days.err, {"from       2015-03-28 00:00:00.000 to 2015-03-29 00:00:00.000"});
}

// A header that names its unit has no pixels, however its tool writes that; and speeds beside
// pixels are not taken for metres per second.
TEST(Animals, UnitsThatContradictAreRefused) {
  const TemporaryFolder folder;
  const std::string fish = folder.file(
      "fish.csv", "frame,X#wcentroid (cm),Y#wcentroid (cm),time,missing\n0,0,0,0,0\n1,0,0,0.1,0\n");
  EXPECT_EQ(run({"replay", fish}).exit_code, 0);
  const std::vector<std::vector<std::string>> contrary = {{"--scale", "2cm"},
                                                          {"--units", "position=m"}};
  for (const std::vector<std::string>& more : contrary) {
    std::vector<std::string> asked = {"replay", fish};
    asked.insert(asked.end(), more.begin(), more.end());
    const Finished finished = run(asked);
    EXPECT_EQ(finished.exit_code, 2) << more[0];
    expect_parts(finished.err, {"X#wcentroid (cm)", "names its unit, cm", more[0]});
  }
  const std::string header = "id,time_s,x_px,y_px,";
  const std::string rows = "\na,0,0,0,50,10\na,1,0,10,-50,10\n";
  const std::string silent = folder.file("silent.csv", header + "vx,vy" + rows);
  const Finished asks = run({"predict", silent, "--scale", "1mm"});
  EXPECT_EQ(asks.exit_code, 2);
  expect_parts(asks.err, {"'vx' holds the velocity, but in which unit?", "speed=mm/s"});
  EXPECT_EQ(run({"predict", silent, "--scale", "1mm", "--units", "speed=mm/s"}).exit_code, 0);
  const std::string stated = folder.file("stated.csv", header + "vx [mm/s],vy [mm/s]" + rows);
  EXPECT_EQ(run({"predict", stated, "--scale", "1mm"}).exit_code, 0);
}

// Who asks 'detect' is told whom to ask.
TEST(Animals, DetectNamesReplay) {
  for (const std::string name :
       {"movebank.csv", "pixels.csv", "trackdf.csv", "idtracker.csv", "logger.csv"}) {
    const Finished finished = run({"detect", table(name)});
    EXPECT_EQ(finished.exit_code, 3) << name;
    expect_parts(finished.err, {"this is a recording", "ask 'beespace replay' about it"});
  }
}

// No side is drawn of what has none, and times are rounded to what they say.
TEST(Animals, FlatTracksAreDrawnFlat) {
  const TemporaryFolder folder;
  const std::string svg = folder.path("flat.svg");
  EXPECT_EQ(run({"plot", table("movebank_r.csv"), "--output", svg}).exit_code, 0);
  const std::string drawn = folder.read("flat.svg");
  expect_parts(drawn, {"From above", " animals. "});
  EXPECT_NE(run({"report", table("movebank_r.csv")}).out.find(R"("one":"animal")"),
            std::string::npos);
  EXPECT_EQ(drawn.find("From the side"), std::string::npos);
  EXPECT_EQ(drawn.find("heights are above"), std::string::npos);
  const std::string czml = folder.path("flat.czml");
  EXPECT_EQ(run({"export", table("movebank_r.csv"), "--output", czml}).exit_code, 0);
  expect_parts(folder.read("flat.czml"), {"The input has no heights: all are shown at height 0.",
                                          R"("multiplier":20)", R"("label":{"text":"Anna")"});
}

// Pages and pictures need nothing more than the answer did.
TEST(Animals, AnswersHavePictures) {
  const TemporaryFolder folder;
  for (const std::string name : {"movebank.csv", "movebank_r.csv", "trackdf.csv"}) {
    const Finished plot = run({"plot", table(name), "--output", folder.path(name + ".svg")});
    EXPECT_EQ(plot.exit_code, 0) << plot.err;
  }
}

// Known for an instant each: who says so has no all-clear.
TEST(Animals, WhoSaysThatRecordsAreAnimalsHasNoAllClear) {
  const std::string rows =
      "id,animal,time_s,x_m,y_m\n1,a,0,0,0\n2,a,9,1,0\n3,b,1,90,0\n4,b,10,0,0.5\n";
  const Arguments replay = {"replay", "--threshold", "1", "--fail-on-risk"};
  expect_failure(replay, rows, 3, "say --columns id=2 for 'animal'");
  const Finished finished = run(replay + Arguments{"--columns", "id=1"}, rows);
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"4 bees known for an instant only, each"});
  // Where not all is in memory at once it is known at the end.
  const TemporaryFolder folder;
  std::string many = "id,animal,time_s,x_m,y_m\n";
  for (int row = 0; row < 120'000; ++row) {
    many += std::to_string(row) + "," + std::to_string(row % 10) + "," + std::to_string(row / 10) +
            ",0," + std::to_string(row % 10 * 100) + "\n";
  }
  expect_failure({"replay", folder.file("many.csv", many), "--memory", "40MB"}, {}, 3,
                 "say --columns id=2 for 'animal'");
}

// Of Argos, who may be kilometres away.
TEST(Animals, PlacesByArgosAreNoAllClear) {
  const auto storks = [](const std::string& sensor) {
    return "timestamp,location-long,location-lat,sensor-type,individual-local-identifier\n"
           "2015-09-10 07:00:00.000,9.17,47.7,gps,x\n2015-09-10 07:05:00.000,9.17,47.7,gps,x\n"
           "2015-09-10 07:00:00.000,9.18,47.7," +
           sensor +
           ",y\n"
           "2015-09-10 07:05:00.000,9.18,47.7," +
           sensor + ",y\n";
  };
  const Arguments replay = {"replay", "--threshold", "100", "--fail-on-risk"};
  EXPECT_EQ(run(replay, storks("gps")).exit_code, 0);
  const Finished finished = run(replay, storks("argos-doppler-shift"));
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"2 places are by the Doppler shift of Argos (sensor-type)",
                              "no conflict in the known time; 1 bee has places too rough to tell"});
}

// Collars of which some tell no height at all: over ground they can be compared.
TEST(Animals, WhoHasNoHeightAtAllIsAskedAbout) {
  TemporaryFolder folder;
  std::string text =
      "event-id,timestamp,location-long,location-lat,height-above-ellipsoid,"
      "individual-local-identifier,study-name\n";
  for (int i = 0; i < 40; ++i) {
    const std::string time = "2024-06-05 0" + std::to_string(i / 12) + ":" +
                             (i % 12 < 2 ? "0" : "") + std::to_string(i % 12 * 5) + ":00.000";
    text += std::to_string(2 * i) + "," + time + ",11.0,47.0,650,Deer1,Deer\n";
    text += std::to_string(2 * i + 1) + "," + time + ",11.0001,47.0,,Deer2,Deer\n";
  }
  const std::string file = folder.file("deer.csv", text);
  const Arguments question = {file, "--threshold", "50"};
  const std::string picture = folder.path("deer.svg");
  for (const Arguments& command : {Arguments{"replay"}, Arguments{"plot", "-o", picture},
                                   Arguments{"report", "-o", folder.path("deer.html")}}) {
    const Finished asked = run(command + question);
    EXPECT_EQ(asked.exit_code, 2) << command[0];
    expect_parts(asked.err, {"'Deer2' has no height in any of its 40 records, while others have",
                             "add --columns lon=3,lat=4; ", "add --columns lon=3,lat=4,height=5"});
  }
  const Finished flat = run(Arguments{"replay"} + question + Arguments{"--columns", "lon=3,lat=4"});
  EXPECT_EQ(flat.exit_code, 0) << flat.err;
  expect_parts(flat.err, {"1 conflict of 1 pair"});
  const Arguments meant = {"--columns", "lon=3,lat=4,height=5", "--fail-on-risk"};
  const Finished left_out = run(Arguments{"replay"} + question + meant);
  EXPECT_EQ(left_out.exit_code, 1) << left_out.err;
  expect_parts(left_out.err, {"bees       2, 1 of which known nowhere", "nothing to compare",
                              "40 records without a height are left out; --columns lon=3,lat=4"});
  const Finished drawn = run(Arguments{"plot", "-o", picture} + question + meant);
  EXPECT_EQ(drawn.exit_code, 1) << drawn.err;
  expect_parts(drawn.err, {"animals    2\n", "nothing to compare: no two animals are there"});
  expect_parts(folder.read("deer.svg"), {"2 animals. Nothing to compare"});
  // Who lacks some of them is known for a part of the time only, as before.
  const std::size_t gap = text.find(",,Deer2");
  text.replace(gap, 1, ",650");
  EXPECT_EQ(run({"replay", folder.file("some.csv", text), "--threshold", "50"}).exit_code, 0);
}

}  // namespace
}  // namespace beespace::cli_test
