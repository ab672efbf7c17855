// Globes, maps and spreadsheets: `beespace export`.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"
#include "tests/cli/run/xml_check.hpp"

namespace beespace::cli_test {
namespace {

// Two are 11 m apart, along a meridian; the third is far away.
constexpr std::string_view kBees =
    "id,longitude,latitude,height\nmaya,-75.5,6.25,1500\n\"<i>&\"\"]]>\",-75.5,6.2501,1500\n"
    "flip,-75.4,6.25,1500\n";
constexpr std::string_view kFlight =
    "id,time,longitude,latitude,height\n"
    "a,2024-05-01T12:00:00Z,-75.5,6.25,1500\na,2024-05-01T12:01:00Z,-75.49,6.25,1500\n"
    "=1+1,2024-05-01T12:00:00Z,-75.49,6.2501,1500\n"
    "=1+1,2024-05-01T12:01:00Z,-75.5,6.2501,1500\n";
constexpr std::string_view kMetres = "id,x,y,z\nmaya,0,0,0\nwilli,60,0,0.5\n";

class Export : public testing::Test {
 protected:
  std::string exported(const std::string& input, const std::string& format,
                       const Arguments& more = {}) {
    const Finished finished = run(Arguments{"export", input, "--format", format, "--quiet"} + more);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_EQ(finished.err, "");
    return finished.out;
  }

  TemporaryFolder folder_;
  std::string bees_ = folder_.file("bees.csv", kBees);
  std::string flight_ = folder_.file("flight.csv", kFlight);
  std::string metres_ = folder_.file("metres.csv", kMetres);
};

TEST_F(Export, KmlHasThoseAtRiskWhereTheyAre) {
  const std::string kml = exported(bees_, "kml");
  EXPECT_TRUE(is_xml(kml)) << kml;
  expect_parts(kml, {"<name>maya</name><description>11.1 m from &amp;lt;i&amp;gt;",
                     "<altitudeMode>absolute</altitudeMode><coordinates>-75.5,6.25,1500",
                     "<name>maya – &lt;i&gt;&amp;&quot;]]&gt;</name>",
                     "<coordinates>-75.5,6.25,1500 -75.5,6.2501,1500</coordinates>",
                     "above the WGS84 ellipsoid"});
  EXPECT_EQ(kml.find("flip"), std::string::npos);
}

TEST_F(Export, KmlOfARecordingHasTracksAndConflictsInTime) {
  const std::string kml = exported(flight_, "kml");
  EXPECT_TRUE(is_xml(kml)) << kml;
  expect_parts(kml, {"<gx:Track>", "<when>2024-05-01T12:01:00Z</when>",
                     "<gx:coord>-75.49 6.25 1500</gx:coord>", "<TimeSpan><begin>2024-05-01T12:00:2",
                     "11.1 m apart at 2024-05-01T12:00:30Z"});
}

TEST_F(Export, CzmlMovesBeesAndJoinsThoseInConflict) {
  const std::string snapshot = exported(bees_, "czml");
  EXPECT_TRUE(is_json(snapshot)) << snapshot;
  expect_parts(snapshot,
               {R"("id":"bee/0","name":"maya")", R"("cartographicDegrees":[-75.5,6.25,1500])"});
  const std::string czml = exported(flight_, "czml");
  EXPECT_TRUE(is_json(czml)) << czml;
  expect_parts(czml, {R"("id":"document","version":"1.0")",
                      R"("availability":"2024-05-01T12:00:00Z/2024-05-01T12:01:00Z")",
                      R"("epoch":"2024-05-01T12:00:00Z")",
                      R"("cartographicDegrees":[0,-75.5,6.25,1500,60,-75.49,6.25,1500])",
                      R"("references":["bee/0#position","bee/1#position"])",
                      R"("clock":{"interval":"2024-05-01T12:00:00Z/2024-05-01T12:01:00Z",)"
                      R"("currentTime":"2024-05-01T12:00:00Z","multiplier":1,"range":"LOOP_STOP")",
                      R"("label":{"text":"=1+1")"});
}

TEST_F(Export, GeojsonHasPointsAndLinesWithTheirProperties) {
  const std::string snapshot = exported(bees_, "geojson");
  EXPECT_TRUE(is_json(snapshot)) << snapshot;
  expect_parts(snapshot,
               {R"("type": "Point", "coordinates": [-75.5, 6.25, 1500])",
                R"("kind":"at risk","id":"maya","nearest":"<i>&\"]]>")",
                R"("kind":"pair","first":"maya","second":"<i>&\"]]>","distance_m":11.0)"});
  const std::string recording = exported(flight_, "geojson");
  EXPECT_TRUE(is_json(recording)) << recording;
  expect_parts(recording, {R"("type": "LineString")", R"("kind":"conflict","first":"a")",
                           R"("closest":"2024-05-01T12:00:30Z")", R"("certain":true)"});
}

TEST_F(Export, CsvHasOneRowAPairOrAConflict) {
  const auto pairs = rows_of(exported(bees_, "csv"), '\n');
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0][0],
            "first,second,distance_m,first_longitude,first_latitude,first_height_m,"
            "second_longitude,second_latitude,second_height_m");
  expect_parts(pairs[1][0], {"maya,\"<i>&\"\"]]>\",11.0", ",-75.5,6.25,1500,-75.5,6.2501,1500"});
  EXPECT_EQ(exported(metres_, "csv"),
            "first,second,distance_m,first_x,first_y,first_z,second_x,second_y,second_z\n"
            "maya,willi,60.002083297165605,0,0,0,60,0,0.5\n");
  const auto conflicts = rows_of(exported(flight_, "csv"), '\n');
  ASSERT_EQ(conflicts.size(), 2u);
  expect_parts(conflicts[1][0], {"a,'=1+1,17145648", ",yes,", ",2024-05-01T12:00:30Z,"});
  EXPECT_TRUE(conflicts[0][0].ends_with(",begins,closest,ends,lasts_s")) << conflicts[0][0];
}

TEST_F(Export, WithoutBeesAtRiskFilesAreEmptyButWhole) {
  EXPECT_TRUE(is_xml(exported(bees_, "kml", {"--threshold", "1"})));
  EXPECT_TRUE(is_json(exported(bees_, "czml", {"--threshold", "1"})));
  EXPECT_EQ(exported(bees_, "geojson", {"--threshold", "1"}),
            "{\"type\": \"FeatureCollection\", \"features\": [\n]}\n");
  EXPECT_EQ(rows_of(exported(metres_, "csv", {"--threshold", "1"}), '\n').size(), 1u);
}

TEST_F(Export, TheEndingSaysTheFormatUnlessFormatDoes) {
  ASSERT_EQ(run({"export", bees_, "-o", folder_.path("a.kml")}).exit_code, 0);
  EXPECT_TRUE(is_xml(folder_.read("a.kml")));
  ASSERT_EQ(run({"export", bees_, "-o", folder_.path("a.txt"), "--format", "geojson"}).exit_code,
            0);
  EXPECT_TRUE(is_json(folder_.read("a.txt")));
  expect_usage_error({"export", bees_}, "say in which format: --format kml, czml, geojson or csv");
  expect_usage_error({"export", bees_, "-o", "a.shp"},
                     "ends in .kml, .czml, .geojson or .csv, unlike 'a.shp'");
  expect_usage_error({"export", bees_, "--format", "kmz"},
                     "'kmz' is none of kml, czml, geojson, csv");
}

TEST_F(Export, MapsNeedDegreesAndLeaveWhatWasThere) {
  for (const char* format : {"kml", "czml", "geojson"}) {
    const std::string name = std::string("risk.") + format;
    const std::string before = folder_.file(name, "before");
    const Finished finished = run({"export", metres_, "-o", before, "--format", format, "--json"});
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_TRUE(is_json(finished.out));
    expect_parts(finished.err, {"needs longitudes and latitudes, but 'metres.csv' is in metres"});
    EXPECT_EQ(folder_.read(name), "before");
  }
}

TEST_F(Export, TakesBeesOnOppositeSidesOfTheEarth) {
  const std::string antipodes =
      folder_.file("antipodes.csv", "longitude,latitude,height\n1,0,100\n-179,0,100\n");
  const std::string flown = folder_.file("flown.csv",
                                         "id,time_s,longitude,latitude,height\na,0,0,90,100\n"
                                         "a,9,0,90,100\nb,0,0,-90,100\nb,9,0,-90,100\n");
  for (const char* format : {"kml", "czml", "geojson", "csv"}) {
    const std::string snapshot = exported(antipodes, format, {"--threshold", "20000000"});
    expect_parts(snapshot, {"-179,"});
    expect_parts(exported(flown, format, {"--threshold", "20000000"}), {"-90,"});
  }
}

TEST_F(Export, CsvQuotesWhatSpreadsheetsElsewhereWouldSplit) {
  const std::string bees = folder_.file("bees.csv", "id,x,y,z\na;=1+2,0,0,0\nb,1,0,0\n");
  EXPECT_EQ(lines_of(exported(bees, "csv")).at(1), "\"a;=1+2\",b,1,0,0,0,1,0,0");
}

// 640 in one place are 204,480 pairs.
std::string crowd(bool flying) {
  std::string text =
      flying ? "id,time_s,longitude,latitude,height\n" : "id,longitude,latitude,height\n";
  for (int bee = 0; bee < 640; ++bee) {
    for (const char* time : {"0,", "9,"}) {
      if (!flying && *time == '9') continue;
      text += std::to_string(bee) + "," + (flying ? time : "") + "-75.5,6.25,1500\n";
    }
  }
  return text;
}

TEST_F(Export, PairsThatAreLeftOutAreReported) {
  const std::string bees = folder_.file("crowd.csv", crowd(false));
  const std::string flown = folder_.file("flown.csv", crowd(true));
  const std::string pairs = "of 204,480 pairs, the closest 10,000 are ";
  const std::string conflicts = "of 204,480 conflicts, the closest 10,000 are ";
  for (const char* format : {"kml", "czml", "geojson"}) {
    const std::string snapshot = exported(bees, format);
    expect_parts(snapshot.substr(0, 2'000), {pairs});
    const std::string recording = exported(flown, format);
    expect_parts(recording.substr(0, 2'000), {conflicts});
    const bool xml = std::string_view(format) == "kml";
    EXPECT_TRUE(xml ? is_xml(snapshot) && is_xml(recording)
                    : is_json(snapshot) && is_json(recording));
  }
  const Finished table = run({"export", bees, "--format", "csv"});
  EXPECT_EQ(lines_of(table.out).size(), 10'001u);
  expect_parts(table.err, {pairs});
  expect_parts(run({"export", flown, "--format", "csv"}).err, {conflicts});
}

// A mast, a house and what is forbidden below it.
constexpr std::string_view kObstacles =
    R"({"obstacles":[{"kind":"cylinder","center":[10,0],"radius_m":2,"high_m":30},)"
    R"({"kind":"box","low":[20,20,0],"high":[30,40,12.5]},{"kind":"ground","height_m":0},)"
    R"({"kind":"prism","outline":[[0,0],[0,50],[50,0]],"low_m":60,"high_m":80},)"
    R"({"kind":"sphere","center":[0,0,90],"radius_m":5}]})";
constexpr const char* kPlace = "19.06,47.48,110,90";

class ExportObstacles : public Export {
 protected:
  std::string obstacles_ = folder_.file("obstacles.json", kObstacles);
  std::string flown_ =
      folder_.file("flown.csv", "id,time_s,x,y,z\na,0,0,0,5\na,9,3,0,5\nb,0,9,0,5\nb,9,9,0,5\n");

  std::string placed(const std::string& input, const std::string& format) {
    return exported(input, format, {"--origin", kPlace, "--obstacles", obstacles_});
  }
};

TEST_F(ExportObstacles, AreSolidsInKml) {
  for (const std::string& input : {metres_, flown_}) {
    const std::string kml = placed(input, "kml");
    EXPECT_TRUE(is_xml(kml)) << kml;
    expect_parts(kml,
                 {"<Folder><name>Obstacles</name>",
                  "<name>obstacles[0], a cylinder</name><description>radius 2 m, up to 140 m, with "
                  "no lower end</description><styleUrl>#obstacle</styleUrl><Polygon><extrude>1<",
                  "<name>obstacles[1], a box</name><description>110 m to 122.5 m high",
                  "obstacles[2], the ground, is everywhere, and is not drawn",
                  "<name>obstacles[3], a prism</name><description>170 m to 190 m high"});
  }
  EXPECT_EQ(exported(metres_, "kml", {"--origin", kPlace}).find("Obstacles"), std::string::npos);
}

TEST_F(ExportObstacles, AreShapesInCzml) {
  for (const std::string& input : {metres_, flown_}) {
    const std::string czml = placed(input, "czml");
    EXPECT_TRUE(is_json(czml)) << czml;
    expect_parts(czml,
                 {R"("id":"obstacle/0","name":"obstacles[0], a cylinder")",
                  R"("topRadius":2,"bottomRadius":2)", R"("name":"obstacles[1], a box")",
                  R"("height":110,"extrudedHeight":122.5)", R"("height":170,"extrudedHeight":190)",
                  R"("ellipsoid":{"radii":{"cartesian":[5,5,5]})"});
  }
}

TEST_F(ExportObstacles, ArePolygonsInGeojson) {
  for (const std::string& input : {metres_, flown_}) {
    const std::string geojson = placed(input, "geojson");
    EXPECT_TRUE(is_json(geojson)) << geojson;
    expect_parts(geojson,
                 {R"("kind":"obstacle","name":"obstacles[0], a cylinder","shape":"cylinder",)"
                  R"("radius_m":2,"high_m":140})",
                  R"("name":"obstacles[1], a box","shape":"box","low_m":110,"high_m":122.5})",
                  R"("note": "obstacles[2], the ground, is everywhere, and is not drawn")",
                  R"("shape":"sphere","radius_m":5,"low_m":195,"high_m":205})"});
  }
}

TEST_F(ExportObstacles, NeedMetresAndAPlace) {
  expect_failure({"export", bees_, "--format", "kml", "--obstacles", obstacles_}, {}, 3,
                 "obstacles are in metres, and 'bees.csv' is in degrees");
  expect_usage_error({"export", metres_, "--format", "csv", "--obstacles", obstacles_},
                     "a table of pairs has no place for --obstacles");
  expect_usage_error({"export", "-", "--format", "kml", "--obstacles", "-"}, "can be read once");
  expect_usage_error(
      {"export", metres_, "-o", obstacles_, "--format", "kml", "--obstacles", obstacles_},
      "is one of the inputs");
  const std::string wide = folder_.file(
      "wide.json", R"({"obstacles": [{"kind": "box", "low": [0, 0, 0], "high": [200000, 1, 1]}]})");
  expect_failure({"export", metres_, "--format", "kml", "--origin", kPlace, "--obstacles", wide},
                 {}, 3, "obstacles[0], a box, reaches farther than 100 km from the origin");
}

TEST_F(Export, PathsAreBrokenWhereBeesAreUnknown) {
  const std::string gap =
      folder_.file("gap.csv",
                   "id,time_s,longitude,latitude,height\na,0,19,47,0\na,1,19.0001,47,0\n"
                   "a,60,19.001,47,0\na,61,19.0011,47,0\nb,0,19,48,0\nb,61,19,48,0\n");
  const Arguments most = {"--max-gap", "10"};
  const std::string czml = exported(gap, "czml", most);
  expect_parts(czml, {R"("id":"path/0/0","name":"a")", R"("id":"path/0/1","name":"a")",
                      R"("cartographicDegrees":[19.001,47,0,19.0011,47,0])"});
  EXPECT_EQ(czml.find(R"("path":{)"), std::string::npos);
  expect_parts(exported(gap, "geojson", most),
               {R"("coordinates": [[19, 47, 0], [19.0001, 47, 0]]}, "properties": )"
                R"({"kind":"path","id":"a","begins_s":0,"ends_s":1})",
                R"({"kind":"path","id":"a","begins_s":60,"ends_s":61})"});
}

TEST_F(Export, TellsAcrossAndInHeightWithAVerticalThreshold) {
  const Arguments nmac = {"--separation", "nmac", "--units", "height=m"};
  expect_parts(exported(bees_, "kml", nmac), {"36 ft across, 0 ft in height"});
  expect_parts(exported(flight_, "geojson", nmac),
               {R"("horizontal_m":11.0)", R"("vertical_m":0,"horizontal_NM":0.00)",
                R"("vertical_ft":0,"begins_s")"});
}

TEST_F(Export, FailsOnRiskWhereAskedTo) {
  EXPECT_EQ(run({"export", bees_, "--format", "csv", "--fail-on-risk"}).exit_code, 1);
  EXPECT_EQ(
      run({"export", bees_, "--format", "csv", "--fail-on-risk", "--threshold", "1"}).exit_code, 0);
}

}  // namespace
}  // namespace beespace::cli_test
