#pragma once

// Facts to draw, and what to look for in drawings.
#include "report/drawing/drawing.hpp"
#include "report/facts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace beespace::report {

template <class Kind>
std::vector<Kind> shapes_of(const Drawing& drawing) {
  std::vector<Kind> all;
  for (const Shape& shape : drawing.shapes) {
    if (const auto* found = std::get_if<Kind>(&shape)) all.push_back(*found);
  }
  return all;
}

inline bool says(const Drawing& drawing, const std::string& part) {
  const auto texts = shapes_of<Text>(drawing);
  return std::any_of(texts.begin(), texts.end(), [&part](const Text& text) {
    return text.text.find(part) != std::string::npos;
  });
}

// Those with names, which are not of the key.
inline std::vector<Diamond> named_marks(const Drawing& drawing) {
  std::vector<Diamond> marks;
  for (const Diamonds& diamonds : shapes_of<Diamonds>(drawing)) {
    for (const Diamond& mark : diamonds.marks) {
      if (!mark.name.empty()) marks.push_back(mark);
    }
  }
  return marks;
}

inline void expect_inside(const Drawing& drawing) {
  const auto inside = [&drawing](const Spot& spot) {
    return spot.x >= 0.0 && spot.x <= drawing.width && spot.y >= 0.0 && spot.y <= drawing.height;
  };
  for (const Text& text : shapes_of<Text>(drawing)) EXPECT_TRUE(inside(text.at)) << text.text;
  for (const Dots& dots : shapes_of<Dots>(drawing)) {
    EXPECT_TRUE(std::all_of(dots.centres.begin(), dots.centres.end(), inside));
  }
  for (const Lines& lines : shapes_of<Lines>(drawing)) {
    for (const auto& run : lines.runs) EXPECT_TRUE(std::all_of(run.begin(), run.end(), inside));
  }
}

// Maya and Willi are 50 m apart, Flip is by himself.
inline SnapshotFacts three_bees() {
  SnapshotFacts facts;
  facts.swarm.title = "three.csv";
  facts.swarm.threshold_m = 100.0;
  facts.swarm.names.texts = {"maya", "willi", "flip"};
  facts.positions = {{0, 0, 0}, {30, 40, 0}, {1000, 500, 200}};
  facts.at_risk = {0, 1};
  facts.nearest = {{1, 50.0}, {0, 50.0}, {1, 1090.0}};
  facts.pair_count = 1;
  facts.group_count = 1;
  facts.largest_group = 2;
  facts.closest = ClosestPair{0, 1, 50.0};
  facts.pairs = {{0, 1}};
  facts.distances_m = {50.0};
  return facts;
}

inline SnapshotFacts many_bees(std::size_t count, std::size_t at_risk) {
  SnapshotFacts facts;
  facts.swarm.title = "many";
  facts.swarm.threshold_m = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double k = static_cast<double>(i);
    facts.positions.push_back(
        {std::fmod(k * 37.7, 1000.0), std::fmod(k * 91.3, 800.0), 50.0 * std::sin(k)});
    facts.nearest.push_back({0, 0.5 + std::fmod(k, 10.0)});
  }
  for (std::size_t i = 0; i < at_risk; ++i) facts.at_risk.push_back(static_cast<PointId>(i));
  return facts;
}

inline RecordingFacts two_tracks() {
  RecordingFacts facts;
  facts.swarm.title = "flight";
  facts.swarm.threshold_m = 5.0;
  facts.swarm.names.texts = {"a", "b"};
  facts.tracks = {Track{{{0.0, {0, 0, 10}}, {100.0, {100, 0, 10}}}},
                  Track{{{0.0, {100, 3, 10}}, {100.0, {0, 3, 10}}}}};
  facts.at_risk = {{0, {48.0, 52.0}}, {1, {48.0, 52.0}}};
  facts.conflicts = {{0, 1, 48.0, 50.0, 52.0, 3.0}};
  facts.conflict_count = 1;
  facts.pair_count = 1;
  facts.closest = facts.conflicts.front();
  for (double t = 0.0; t <= 100.0; t += 1.0) {
    facts.separation.push_back({t, {0, 1, std::hypot(100.0 - 2.0 * t, 3.0)}});
  }
  return facts;
}

}  // namespace beespace::report
