// Pages, pictures and files for maps made from files by calling the library alone, without the
// command.
#include "analysis/scene/build_page.hpp"
#include "analysis/scene/load_scene.hpp"
#include "analysis/scene/worst_link.hpp"
#include "io/bytes/atomic_output.hpp"
#include "io/bytes/byte_source.hpp"
#include "report/drawing/svg.hpp"
#include "report/figure/figure.hpp"
#include "report/map/kml.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr const char* kSnapshot = "id,x,y,z\nana,0,0,0\nbea,3,0,0\ncaro,100,0,0\n";

// Two cross at time 5, 2 m apart in height.
constexpr const char* kRecording =
    "id,time_s,x,y,z\nana,0,-50,0,0\nana,10,50,0,0\nbea,0,0,-50,2\nbea,10,0,50,2\n";

// Some 11 m apart.
constexpr const char* kOnTheEarth =
    "id,longitude,latitude,height_m\nana,-75.5,6.2,1500\nbea,-75.4999,6.2,1500\n";

class SceneTest : public testing::Test {
 protected:
  SceneTest()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("beespace-scene-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~SceneTest() override { std::filesystem::remove_all(folder_); }
  SceneTest(const SceneTest&) = delete;
  SceneTest& operator=(const SceneTest&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }

  static Scene loaded(const std::string& file) {
    SceneRequest request;
    request.threshold_m = 20.0;
    auto scene = load_scene({file}, request);
    if (!scene) throw std::runtime_error(to_string(scene.error()));
    return *std::move(scene);
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(SceneTest, ASnapshotIsLoaded) {
  const Scene scene = loaded(file("bees.csv", kSnapshot));
  const auto* snapshot = std::get_if<report::SnapshotFacts>(&scene);
  ASSERT_NE(snapshot, nullptr);
  EXPECT_EQ(snapshot->swarm.title, "bees.csv");
  EXPECT_EQ(snapshot->swarm.names.texts, (std::vector<std::string>{"ana", "bea", "caro"}));
  EXPECT_EQ(snapshot->at_risk, (std::vector<PointId>{0, 1}));
  EXPECT_EQ(snapshot->pair_count, 1U);
  EXPECT_TRUE(is_risky(scene));
}

TEST_F(SceneTest, ARecordingIsLoaded) {
  const Scene scene = loaded(file("flight.csv", kRecording));
  const auto* recording = std::get_if<report::RecordingFacts>(&scene);
  ASSERT_NE(recording, nullptr);
  EXPECT_EQ(recording->conflict_count, 1U);
  ASSERT_TRUE(recording->closest.has_value());
  EXPECT_DOUBLE_EQ(recording->closest->closest_s, 5.0);
  EXPECT_DOUBLE_EQ(recording->closest->closest_m, 2.0);
  EXPECT_TRUE(is_risky(scene));
}

// Two hover 0.5 m apart while two others pass each other at 1.5 m, between two moments.
TEST_F(SceneTest, TheClosestTwoAreNeverAnotherPairFartherApart) {
  const Scene scene =
      loaded(file("four.csv",
                  "id,time_s,x,y,z\na,0,0,0,0\na,60,0,0,0\nb,0,0.5,0,0\nb,60,0.5,0,0\n"
                  "c,0,-500,90,0\nc,60,499.137,90,0\nd,0,500,91.5,0\nd,60,-499.137,91.5,0\n"));
  const auto& facts = std::get<report::RecordingFacts>(scene);
  EXPECT_EQ(facts.conflict_count, 2U);
  ASSERT_GT(facts.separation.size(), 600U);
  for (const report::Separation& at : facts.separation) {
    EXPECT_DOUBLE_EQ(at.closest.distance_m, 0.5) << at.time_s;
    EXPECT_EQ(at.closest.first, 0U);
    EXPECT_EQ(at.closest.second, 1U);
  }
}

TEST_F(SceneTest, TheVerticalThresholdAndTheDefaultOneCount) {
  SceneRequest request;
  request.vertical = io::StatedLength{1.0, 1.0, io::Unit::kMetre};
  const auto scene = load_scene({file("flight.csv", kRecording)}, request);
  ASSERT_TRUE(scene.has_value()) << to_string(scene.error());
  EXPECT_EQ(swarm_of(*scene).threshold_m, kDefaultThreshold_m);
  EXPECT_EQ(swarm_of(*scene).vertical_m, 1.0);
  EXPECT_FALSE(is_risky(*scene));
}

TEST_F(SceneTest, StagesAreToldInTheirOrder) {
  std::vector<SceneStage> stages;
  io::Progress reading;
  const auto scene = load_scene({file("bees.csv", kSnapshot)}, {},
                                {&reading, [&](SceneStage stage) { stages.push_back(stage); }});
  ASSERT_TRUE(scene.has_value());
  EXPECT_EQ(stages, (std::vector<SceneStage>{SceneStage::kReading, SceneStage::kSearching}));
  EXPECT_GT(reading.done.load(), 0U);
}

TEST_F(SceneTest, WhatCannotBeReadIsAnErrorWithItsPlace) {
  const auto scene = load_scene({file("bees.csv", "id,x,y,z\nana,0,0,0\nbea,1,far,0\n")}, {});
  ASSERT_FALSE(scene.has_value());
  EXPECT_EQ(scene.error().code, ErrorCode::kNotANumber);
  EXPECT_EQ(scene.error().location.source, path("bees.csv"));
  EXPECT_EQ(load_scene({path("none.csv")}, {}).error().code, ErrorCode::kCannotOpen);
}

TEST_F(SceneTest, APageIsBuilt) {
  const auto page = build_page({loaded(file("bees.csv", kSnapshot))});
  if (!check_has_page()) {
    ASSERT_FALSE(page.has_value());
    EXPECT_EQ(page.error().code, ErrorCode::kInvalidArgument);
    return;
  }
  ASSERT_TRUE(page.has_value()) << to_string(page.error());
  std::string html;
  write_page(*page, [&](std::string_view text) { html += text; });
  EXPECT_TRUE(html.starts_with("<!doctype html>")) << html.substr(0, 100);
  EXPECT_NE(html.find("bees.csv"), std::string::npos);
}

TEST_F(SceneTest, APageComparesTwoOfAKindAndNothingElse) {
  const Scene snapshot = loaded(file("bees.csv", kSnapshot));
  const Scene earth = loaded(file("earth.csv", kOnTheEarth));
  const Scene recording = loaded(file("flight.csv", kRecording));
  EXPECT_EQ(build_page({snapshot, snapshot}).has_value(), check_has_page().has_value());
  for (const auto& scenes : std::vector<std::vector<Scene>>{
           {}, {snapshot, recording}, {snapshot, earth}, {snapshot, snapshot, snapshot}}) {
    const auto page = build_page(scenes);
    ASSERT_FALSE(page.has_value());
    EXPECT_EQ(page.error().code, ErrorCode::kInvalidArgument);
  }
}

TEST_F(SceneTest, ScenesThatAreComparedHaveOneOrigin) {
  const std::string file_path = file("earth.csv", kOnTheEarth);
  const std::string other =
      file("other.csv", "id,longitude,latitude,height_m\nana,-75.6,6.3,1500\nbea,-75.7,6.3,1500\n");
  const auto scenes = load_scenes({{file_path}, {other}}, {});
  ASSERT_TRUE(scenes.has_value()) << to_string(scenes.error());
  ASSERT_EQ(scenes->size(), 2U);
  const auto& first = swarm_of((*scenes)[0]).origin;
  const auto& second = swarm_of((*scenes)[1]).origin;
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->longitude_deg, second->longitude_deg);
  EXPECT_EQ(first->latitude_deg, second->latitude_deg);
}

// Drones of a show keep 2 m, if none is said; a table says of nothing how close is too close.
TEST_F(SceneTest, ScenesThatAreComparedAreJudgedByOneThreshold) {
  const std::string show =
      file("show.csv", "Time [msec],x [m],y [m],z [m]\n0,0,0,0\n2000,0,0,10\n4000,0,0,0\n");
  const std::string flight = file("flight.csv", kRecording);
  io::RecordingOptions load;
  load.one_clock = true;
  SceneRequest request;
  request.load = load;
  for (const auto& inputs : {std::vector<std::vector<std::string>>{{show}, {flight}},
                             std::vector<std::vector<std::string>>{{flight}, {show}}}) {
    const auto scenes = load_scenes(inputs, request);
    ASSERT_TRUE(scenes.has_value()) << to_string(scenes.error());
    EXPECT_EQ(swarm_of((*scenes)[0]).threshold_m, 2.0);
    EXPECT_EQ(swarm_of((*scenes)[1]).threshold_m, 2.0);
  }
}

TEST_F(SceneTest, TheLinkToTheWorstPairNamesItsMoment) {
  EXPECT_EQ(worst_link(loaded(file("bees.csv", kSnapshot))), "#bees=0,1");
  EXPECT_EQ(worst_link(loaded(file("flight.csv", kRecording))), "#t=5&bees=0,1");
  EXPECT_EQ(worst_link(loaded(file("calm.csv", "id,x,y,z\nana,0,0,0\nbea,100,0,0\n"))), "");
  // From the beginning on, whatever the clock says.
  EXPECT_EQ(worst_link(loaded(file("later.csv",
                                   "id,time_s,x,y,z\nana,1000,-50,0,0\n"
                                   "ana,1010,50,0,0\nbea,1000,0,-50,2\n"
                                   "bea,1010,0,50,2\n"))),
            "#t=5&bees=0,1");
}

TEST_F(SceneTest, APictureIsDrawn) {
  Scene scene = loaded(file("flight.csv", kRecording));
  set_title(scene, "Crossing");
  const auto drawing =
      std::visit([](const auto& facts) { return report::figure_of(facts); }, scene);
  const std::string picture = report::svg(drawing, 800);
  EXPECT_NE(picture.find("<svg"), std::string::npos);
  EXPECT_NE(picture.find("Crossing"), std::string::npos);
}

TEST_F(SceneTest, AFileForMapsIsWritten) {
  const Scene scene = loaded(file("earth.csv", kOnTheEarth));
  auto output = io::AtomicOutput::open(path("earth.kml"));
  ASSERT_TRUE(output.has_value());
  std::visit([&](const auto& facts) { report::write_kml(facts, *output); }, scene);
  ASSERT_TRUE(output->commit().has_value());
  const auto written = io::open_bytes(path("earth.kml"), nullptr);
  ASSERT_TRUE(written.has_value());
  EXPECT_NE(written->view.find("<kml"), std::string_view::npos);
  EXPECT_NE(written->view.find("ana"), std::string_view::npos);
}

}  // namespace
}  // namespace beespace::analysis
