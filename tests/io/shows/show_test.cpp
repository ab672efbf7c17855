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

TEST(Show, LimitsAreReadInBothWaysOfWriting) {
  const auto with = [](const std::string& limits) {
    return load_show(show(drone("a", kTrajectory), R"({"validation": {)" + limits + "}}"));
  };
  const auto recording = recording_of(
      with(R"("min_distance": 5, "max_altitude": 120, "max_velocity_xy": 8, "max_velocity_z": 2,
             "max_velocity_z_up": 3, "max_acceleration_xy": 4, "min_nav_altitude": 2.5)"));
  EXPECT_EQ(recording.declared_threshold_m, 5.0);
  ASSERT_TRUE(recording.show);
  const ShowLimits& limits = recording.show->limits;
  EXPECT_EQ(limits.height_m, 120.0);
  EXPECT_EQ(limits.horizontal_mps, 8.0);
  EXPECT_EQ(limits.descent_mps, 2.0);
  EXPECT_EQ(limits.climb_mps, 3.0);
  EXPECT_EQ(limits.accelerations,
            (std::vector<ShowAcceleration>{
                {"max_acceleration_xy", 4.0, ShowAcceleration::Direction::kHorizontal}}));
  ASSERT_EQ(limits.navigation_m.size(), 1u);
  EXPECT_EQ(limits.navigation_m[0].second, 2.5);
  EXPECT_TRUE(limits.not_looked_at.empty());
  // In both, they must not differ.
  EXPECT_EQ(recording_of(with(R"("minDistance": 3, "min_distance": 3.0)")).declared_threshold_m,
            3.0);
  const auto differ = with(R"("minDistance": 3, "min_distance": 5)");
  ASSERT_FALSE(differ);
  EXPECT_NE(differ.error().message.find("minDistance is 3, and min_distance 5"), std::string::npos)
      << differ.error().message;
  // 0 limits nothing; upwards apart from downwards it is not known which way is meant.
  EXPECT_TRUE(recording_of(with(R"("minNavAltitude": 0)")).show->limits.navigation_m.empty());
  const auto apart = recording_of(with(R"("maxAccelerationZ": 2, "maxAccelerationZUp": 3)"));
  for (const ShowAcceleration& limit : apart.show->limits.accelerations) {
    EXPECT_EQ(limit.direction, ShowAcceleration::Direction::kNotKnown);
  }
}

TEST(Show, AnOrientationOfMoreThanATurnIsNoneInDegrees) {
  const auto at = [](const std::string& orientation) {
    std::string json = show(drone("a", kTrajectory));
    json.insert(json.size() - 1, R"(, "environment": {"location": {"origin":
                [474729200, 190620700], "orientation": )" +
                                     orientation + "}}");
    return recording_of(load_show(json));
  };
  EXPECT_TRUE(at("270").show->place);
  const Recording tenths = at("2700");
  EXPECT_FALSE(tenths.show->place);
  EXPECT_TRUE(has_note(tenths, "its orientation of 2700 is more than a full turn in degrees"));
  const Recording text = at(R"("59")");
  ASSERT_TRUE(text.show->place);
  EXPECT_EQ(text.show->place->heading_deg, 59.0);
  EXPECT_TRUE(has_note(at(R"("north")"), "is a string, and no number of degrees"));
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
                       "1 drone stands on the ground before take-off or after landing: compared "
                       "with those that fly then, and not with others that stand; --grounded"));
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_TRUE(recording_of(load_show(show(drone("a", kTrajectory)), grounded)).notes.empty());
}

TEST(Show, TimesCountFromTakeoff) {
  const std::string late = R"({"takeoffTime": 12, "points": [[0, [9, 0, 0]], [2, [9, 0, 5]]]})";
  const BezierPath path = path_of(late, false);
  EXPECT_EQ(path.begins_s, 12.0);
  ASSERT_EQ(path.pieces.size(), 1u);
  EXPECT_EQ(path.pieces[0].ends_s, 14.0);
  const BezierPath waiting = path_of(late, true);
  EXPECT_EQ(waiting.begins_s, 0.0);
  ASSERT_EQ(waiting.pieces.size(), 2u);
  EXPECT_EQ(waiting.pieces[0].end, (Point{9, 0, 0}));
  EXPECT_TRUE(has_note(recording_of(load_show(show(drone("a", late)))),
                       "the times of the points of 1 drone count from takeoffTime, which is not 0, "
                       "as Skybrush plays them"));
  EXPECT_TRUE(
      has_note(recording_of(load_show(show(drone("a", late) + "," + drone("b", kTrajectory)))),
               "which is not 0 and not the same for all, as"));
}

TEST(Show, WaitingInTheAirUntilTakeoffIsFlight) {
  const BezierPath path =
      path_of(R"({"takeoffTime": 12, "points": [[0, [9, 0, 10]], [2, [9, 0, 5]]]})", false);
  EXPECT_EQ(path.begins_s, 0.0);
  EXPECT_EQ(path.pieces.size(), 2u);
}

TEST(Show, LandingTimeCutsNothing) {
  EXPECT_EQ(path_of(R"({"landingTime": 1, "points": [[0, [9, 0, 0]], [2, [9, 0, 5]],
                                                     [4, [0, 0, 5]], [6, [0, 0, 0]]]})",
                    false)
                .pieces.size(),
            3u);
}

TEST(Show, HoveringIsNoStanding) {
  // In the air before the end, and before its first motion higher than home.
  const std::string hovering =
      R"({"points": [[0, [0, 0, 3]], [1, [0, 0, 3]], [2, [5, 0, 3]], [9, [5, 0, 3]]]})";
  EXPECT_EQ(path_of(hovering, false, R"(, "home": [0, 0, 0])").pieces.size(), 3u);
  EXPECT_EQ(path_of(hovering, false, R"(, "home": [0, 0, 0], "landAt": [5, 0, 0])").pieces.size(),
            3u);
  // Where it is to land, without a home, and at home beside a drone that starts lower.
  EXPECT_EQ(path_of(hovering, false, R"(, "home": [0, 0, 0], "landAt": [5, 0, 3])").pieces.size(),
            3u);
  EXPECT_EQ(path_of(hovering, false).pieces.size(), 3u);
  const auto beside = recording_of(load_show(
      show(drone("a", kTrajectory) + "," + drone("b", hovering, R"(, "home": [0, 0, 3])"))));
  ASSERT_EQ(beside.bees.size(), 2u);
  EXPECT_EQ(beside.bees[1].path->pieces.size(), 3u);
  // Where all of the show is that high it is all in the air.
  EXPECT_EQ(path_of(hovering, false, R"(, "home": [0, 0, 3], "landAt": null)").pieces.size(), 3u);
  // The lowest of the whole show is the ground, up to 1 m.
  const std::string low =
      R"({"points": [[0, [0, 0, 1]], [1, [0, 0, 1]], [2, [5, 0, 3]], [9, [5, 0, 3]]]})";
  EXPECT_EQ(path_of(low, false, R"(, "home": [0, 0, 1], "landAt": null)").pieces.size(), 2u);
}

TEST(Show, AConstantTrajectoryInTheAirIsFlight) {
  const std::string still = R"({"points": [[0, [50, 0, 10]], [20, [50, 0, 10]]]})";
  for (const char* const more :
       {"", R"(, "home": [50, 0, 10])", R"(, "home": [0, 0, 0], "landAt": [50, 0, 10])"}) {
    EXPECT_EQ(ids_of(recording_of(
                  load_show(show(drone("a", kTrajectory) + "," + drone("b", still, more))))),
              (Ids{"a", "b"}))
        << more;
  }
}

TEST(Show, ASinglePointInTheAirDoesNotSayHowLong) {
  const std::string json =
      show(drone("a", kTrajectory) + "," + drone("b", R"({"points": [[0, [0, 0, 5]]]})"));
  const auto refused = load_show(json);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("drone 'b': points has a single point, which does not"),
            std::string::npos);
  EXPECT_FALSE(refused.error().location.record);
  const auto grounded = recording_of(load_show(
      show(drone("a", kTrajectory) + "," + drone("b", R"({"points": [[0, [0, 0, 0]]]})"))));
  EXPECT_EQ(ids_of(grounded), (Ids{"a", "b"}));
  EXPECT_TRUE(grounded.bees[1].stands.has_value());
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

TEST(Show, ADroneThatNeverFliesStandsAllTheTime) {
  const std::string still = R"({"points": [[0, [0, 0, 0]], [100, [0, 0, 0]]]})";
  const std::string json = show(drone("a", kTrajectory) + "," + drone("b", still));
  const auto flying = recording_of(load_show(json));
  EXPECT_EQ(ids_of(flying), (Ids{"a", "b"}));
  EXPECT_EQ(flying.bees[1].stands, Point{});
  EXPECT_FALSE(flying.bees[1].path || flying.bees[0].stands);
  EXPECT_TRUE(has_note(flying, "1 drone never leaves the ground and stands there for those that "));
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
                      folder.write("bees.csv", "id,time_s,x,y,z\nc,0,1,2,3\nb,0,1,2,3\n")}));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "c", "b"}));
  EXPECT_EQ(recording.format_description, "several formats");
}

TEST(Show, ATableThatNamesItsDronesIsAskedAbout) {
  const TemporaryFolder folder;
  const std::string table = folder.write("bees.csv", "id,time_s,x,y,z\nb,0,7,8,9\na,0,7,8,9\n");
  expect_error(load_recording({folder.write("show.json", show(drone("a", kTrajectory))), table}),
               {ErrorCode::kInvalidArgument, table + ":3", "'a' is also a drone of the show"});
}

// A path that no drone has, as where one was left out of the list, is not passed over in silence.
TEST(Show, WhatNothingLeadsToIsSaid) {
  const std::string list = show(drone("a", R"({"$ref": "./drones/a/trajectory.json#"})"));
  const Members members = {{"show.json", list},
                           {"drones/a/trajectory.json", kTrajectory},
                           {"drones/a/lights.json", "{}"}};
  const Recording all = recording_of(load_recording_from_memory(zipped(members), "show.skyc"));
  EXPECT_FALSE(has_note(all, "an archive"));
  Members more = members;
  more.emplace_back("drones/b/trajectory.json", kTrajectory);
  const Recording some = recording_of(load_recording_from_memory(zipped(more), "show.skyc"));
  EXPECT_TRUE(has_note(some,
                       "of show.skyc, an archive, what its show.json leads to is read: "
                       "'drones/b/trajectory.json' is left out"));
}

TEST(Show, ItsGroundIsItsLowestPlace) {
  const auto ground_of = [](const std::string& more) {
    const auto recording = recording_of(load_show(show(drone("a", kTrajectory, more))));
    return recording.show ? recording.show->ground_m.value_or(-99.0) : -99.0;
  };
  EXPECT_EQ(ground_of(""), 0.0);
  EXPECT_EQ(ground_of(R"(, "home": [0, 0, -2])"), -2.0);
}

// A show from a roof; and one that may be a part of a show, of drones that fly on at 12 m.
TEST(Show, ItsGroundIsHighWhereAllDronesAreSaidToStartAndLandThere) {
  constexpr const char* kUp =
      R"({"version": 1, "points": [[0, [0, 0, 12], []], [9, [0, 0, 30], []], [20, [0, 0, 12], []]]})";
  const auto of = [](const std::string& more) {
    return recording_of(load_show(show(drone("a", kUp, more))));
  };
  const Recording roof = of(R"(, "home": [0, 0, 12], "landAt": [0, 0, 12])");
  EXPECT_EQ(roof.show->ground_m, 12.0);
  EXPECT_TRUE(has_note(roof, "the ground is at z = 12 m, where all drones start and land"));
  EXPECT_EQ(of("").show->ground_m, 0.0);
  EXPECT_EQ(of(R"(, "home": [0, 0, 12])").show->ground_m, 0.0);
  EXPECT_EQ(of(R"(, "home": [0, 0, 12], "landAt": [5, 0, 12])").show->ground_m, 0.0);
  EXPECT_EQ(of(R"(, "home": [0, 0, 12], "landAt": [0, 0, 14])").show->ground_m, 0.0);
  // Who hovers there, or moves sideways, is in the air, whatever the show calls the place.
  const auto ground_of = [](const std::string& points) {
    return recording_of(load_show(show(drone("a", R"({"version": 1, "points": [)" + points + "]}",
                                             R"(, "home": [0, 0, 12], "landAt": [0, 0, 12])"))))
        .show->ground_m;
  };
  EXPECT_EQ(ground_of("[0, [0, 0, 12], []], [9, [0, 0, 12], []], [20, [0, 0, 12], []]"), 0.0);
  EXPECT_EQ(ground_of("[0, [0, 0, 12], []], [9, [5, 0, 12], []], [15, [0, 0, 30], []], "
                      "[20, [0, 0, 12], []]"),
            0.0);
}

// As programs export it in which y points up: no drone ever takes off.
TEST(ShowTables, WhoseHeightsNeverChangeLeaveNoTimeOut) {
  const std::string header = "Time [msec],x [m],y [m],z [m],Red,Green,Blue\n";
  const auto table = [&header](const std::string& height) {
    return header + "0,1,0,0,9,9,9\n1000,1,9," + height + ",9,9,9\n2000,1,9," + height +
           ",9,9,9\n3000,1,0,0,9,9,9\n4000,1,0,0,9,9,9\n";
  };
  const Recording flat = recording_of(record(table("0")));
  ASSERT_TRUE(flat.show);
  EXPECT_EQ(flat.bees[0].fixes.size(), 5u);
  EXPECT_TRUE(has_note(flat, "heights never change: no drone takes off"));
  const Recording flying = recording_of(record(table("9")));
  EXPECT_EQ(flying.bees[0].fixes.size(), 4u);
  EXPECT_FALSE(has_note(flying, "heights never change"));
}

}  // namespace
}  // namespace beespace::io
