#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;

// A drone that stands for a second, climbs along a cubic, turns along a quadratic, and ends there.
constexpr const char* kTrajectory =
    R"({"version": 1, "takeoffTime": 0, "landingTime": 9,
        "points": [[0, [1, 2, 0], []],
                   [1, [1, 2, 0], []],
                   [5, [1, 2, 5], [[1, 2, 0], [1.5, 2.5, 2]]],
                   [9.5, [4, 2, 5], [[2, 3, 5]]]]})";

std::string drone(const std::string& name, const std::string& trajectory,
                  const std::string& more = "") {
  return R"({"type": "generic", "settings": {"name": ")" + name + R"(", "trajectory": )" +
         trajectory + more + "}}";
}

std::string show(const std::string& drones, const std::string& settings = "{}") {
  return R"({"version": 1, "settings": )" + settings + R"(, "swarm": {"drones": [)" + drones +
         "]}}";
}

Result<Recording> load_show(const std::string& json, const RecordingOptions& options = {}) {
  return load_recording_from_memory(json, "show.json", options);
}

// The path of the only drone, on the ground too or not.
BezierPath path_of(const std::string& trajectory, bool grounded, const std::string& more = "") {
  RecordingOptions options;
  options.grounded = grounded;
  const auto recording = recording_of(load_show(show(drone("a", trajectory, more)), options));
  if (recording.bees.size() != 1 || !recording.bees[0].path) {
    ADD_FAILURE() << "no path";
    return {};
  }
  return *recording.bees[0].path;
}

TEST(Show, EachEntryEndsAPieceWithItsControlPoints) {
  const BezierPath path = path_of(kTrajectory, true);
  EXPECT_EQ(path.begins_s, 0.0);
  EXPECT_EQ(path.begin, (Point{1, 2, 0}));
  ASSERT_EQ(path.pieces.size(), 3u);
  EXPECT_EQ(path.pieces[0].control_count, 0);
  EXPECT_EQ(path.pieces[1].ends_s, 5.0);
  EXPECT_EQ(path.pieces[1].end, (Point{1, 2, 5}));
  EXPECT_EQ(path.pieces[1].control_count, 2);
  EXPECT_EQ(path.pieces[1].controls[1], (Point{1.5, 2.5, 2}));
  EXPECT_EQ(path.pieces[2].control_count, 1);
  EXPECT_EQ(path.pieces[2].controls[0], (Point{2, 3, 5}));
}

TEST(Show, IsInMetresAboveHomeAndDeclaresItsThreshold) {
  const auto recording = recording_of(
      load_show(show(drone("a", kTrajectory), R"({"validation": {"minDistance": 2.5}})")));
  EXPECT_EQ(ids_of(recording), Ids{"a"});
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_EQ(recording.frame_reason, "a Skybrush show is in metres");
  EXPECT_EQ(recording.format_description, "Skybrush show");
  EXPECT_EQ(recording.heights, HeightDatum::kHome);
  EXPECT_EQ(recording.declared_threshold_m, 2.5);
  EXPECT_FALSE(recording.since_1970);
  EXPECT_EQ(recording_of(load_show(show(drone("a", kTrajectory)))).declared_threshold_m,
            std::nullopt);
}

TEST(Show, ReferencesLeadThroughTheArchive) {
  const std::string json = show(drone("a", R"({"$ref": "./drones/a/trajectory.json#"})") + "," +
                                    drone("b", R"({"$ref": "drones/../all.json#/list/1"})") + "," +
                                    drone("c", R"({"$ref": "#/shared"})"),
                                R"({"$ref": "settings.json"})");
  const std::string zip = zipped(
      {{"show.json", json.substr(0, json.size() - 1) + R"(, "shared": )" + kTrajectory + "}"},
       {"drones/a/trajectory.json", R"({"$ref": "../../all.json#/list/0"})"},
       {"all.json", std::string("{\"list\": [") + kTrajectory + "," + kTrajectory + "]}"},
       {"settings.json", R"({"validation": {"minDistance": 3}})"}});
  const auto recording = recording_of(load_recording_from_memory(zip, "show.skyc"));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "b", "c"}));
  for (const RecordedBee& bee : recording.bees) EXPECT_EQ(bee.path->pieces.size(), 2u) << bee.id;
  EXPECT_EQ(recording.declared_threshold_m, 3.0);
}

TEST(Show, TheTimeOnTheGroundIsLeftOutAndThatIsReported) {
  const BezierPath path = path_of(kTrajectory, false);
  EXPECT_EQ(path.begins_s, 1.0);
  EXPECT_EQ(path.begin, (Point{1, 2, 0}));
  EXPECT_EQ(path.pieces.size(), 2u);
  EXPECT_TRUE(has_note(recording_of(load_show(show(drone("a", kTrajectory)))),
                       "the time on the ground of 1 drone is left out"));
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_TRUE(recording_of(load_show(show(drone("a", kTrajectory)), grounded)).notes.empty());
}

TEST(Show, PiecesThatOverlapTheFlightStayWhole) {
  const BezierPath path = path_of(
      R"({"takeoffTime": 2, "landingTime": 5,
          "points": [[0, [0, 0, 3]], [1, [1, 0, 3]], [2, [2, 0, 3]], [4, [3, 0, 3]],
                     [6, [4, 0, 3]], [7, [5, 0, 3]]]})",
      false);
  EXPECT_EQ(path.begins_s, 2.0);
  EXPECT_EQ(path.begin, (Point{2, 0, 3}));
  ASSERT_EQ(path.pieces.size(), 2u);
  EXPECT_EQ(path.pieces.back().ends_s, 6.0);
}

TEST(Show, HoveringIsNoStanding) {
  // In the air before the end, and before its first motion higher than home.
  const std::string hovering =
      R"({"points": [[0, [0, 0, 3]], [1, [0, 0, 3]], [2, [5, 0, 3]], [9, [5, 0, 3]]]})";
  EXPECT_EQ(path_of(hovering, false, R"(, "home": [0, 0, 0])").pieces.size(), 3u);
  EXPECT_EQ(path_of(hovering, false, R"(, "home": [0, 0, 0], "landAt": [5, 0, 0])").pieces.size(),
            3u);
  // On a pad of its own, and where it is to land.
  EXPECT_EQ(path_of(hovering, false, R"(, "home": [0, 0, 3], "landAt": null)").pieces.size(), 1u);
  EXPECT_EQ(path_of(hovering, false, R"(, "home": [0, 0, 0], "landAt": [5, 0, 3])").pieces.size(),
            2u);
}

TEST(Show, StandingInTheMiddleStays) {
  const BezierPath path = path_of(
      R"({"points": [[0, [0, 0, 0]], [1, [0, 0, 0]], [2, [0, 0, 5]], [3, [0, 0, 0]],
                     [9, [0, 0, 0]], [10, [0, 0, 5]], [11, [0, 0, 0]], [12, [0, 0, 0]]]})",
      false);
  EXPECT_EQ(path.begins_s, 1.0);
  EXPECT_EQ(path.pieces.size(), 5u);
  EXPECT_EQ(path.pieces.back().ends_s, 11.0);
}

TEST(Show, ADroneThatNeverFliesIsLeftOut) {
  const std::string still = R"({"points": [[0, [0, 0, 0]], [100, [0, 0, 0]]]})";
  const std::string json = show(drone("a", kTrajectory) + "," + drone("b", still));
  const auto flying = recording_of(load_show(json));
  EXPECT_EQ(ids_of(flying), Ids{"a"});
  EXPECT_TRUE(has_note(flying, "1 drone never leaves the ground and is left out"));
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_EQ(ids_of(recording_of(load_show(json, grounded))), (Ids{"a", "b"}));
}

TEST(Show, DronesGetNamesThatTellThemApart) {
  const std::string nameless = std::string(R"({"settings": {"trajectory": )") + kTrajectory + "}}";
  const auto recording = recording_of(
      load_show(show(drone("a", kTrajectory) + "," + drone("a", kTrajectory) + "," +
                     drone("", kTrajectory) + "," + nameless + "," + drone("a#2", kTrajectory))));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "a#2", "drone 3", "drone 4", "a#2#2"}));
  EXPECT_TRUE(has_note(recording, "2 bees have the name of another one"));
}

TEST(Show, IsRecognisedByItsContent) {
  const TemporaryFolder folder;
  const std::string json = show(drone("a", kTrajectory));
  const auto named_csv = folder.write("show.csv", "\xEF\xBB\xBF\n " + json);
  EXPECT_EQ(ids_of(recording_of(load_recording({named_csv}))), Ids{"a"});
  const auto named_txt = folder.write("show.txt", zipped({{"show.json", json}}));
  EXPECT_EQ(ids_of(recording_of(load_recording({named_txt}))), Ids{"a"});
}

TEST(Show, MayStandBesideTables) {
  const TemporaryFolder folder;
  const auto recording = recording_of(
      load_recording({folder.write("show.json", show(drone("a", kTrajectory))),
                      folder.write("bees.csv", "id,time_s,x,y,z\na,0,1,2,3\nb,0,1,2,3\n")}));
  EXPECT_EQ(ids_of(recording), (Ids{"a#2", "a", "b"}));
  EXPECT_EQ(recording.format_description, "several formats");
}

}  // namespace
}  // namespace beespace::io
