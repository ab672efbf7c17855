// The scenes on which every search is compared with brute force: small, hard, and named.
#pragma once

#include "tests/support/crowd_scenes.hpp"
#include "tests/support/far_scenes.hpp"
#include "tests/support/lattice_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <vector>

namespace beespace::test {

inline std::vector<SearchScene> plain_scenes() {
  SceneMaker make(20240607);
  std::vector<SearchScene> scenes;
  const auto add = [&](const char* name, std::vector<Point> points, double threshold) {
    scenes.push_back({name, std::move(points), threshold});
  };
  add("Empty", {}, 1.0);
  add("OnePoint", {{1, 2, 3}}, 1.0);
  add("TwoAtTheSamePlace", {{1, 2, 3}, {1, 2, 3}}, 1e-9);
  add("TwoFarApart", {{-1, -2, -3}, {1e5, 2, 3}}, 10.0);
  add("MinusZeroIsZero", {{0.0, 0.0, 0.0}, {-0.0, -0.0, -0.0}, {5, 5, 5}}, 1e-9);
  add("Line", make.box(700, {0, 0, 0}, {3000, 0, 0}), 2.0);
  add("PlaneOfConstantHeight", make.box(900, {0, 0, 120}, {900, 900, 120}), 15.0);
  add("UniformFewNeighbours", make.box(1000, {0, 0, 0}, {874, 874, 874}), 40.0);
  add("UniformTwoNeighbours", make.box(1000, {0, 0, 0}, {874, 874, 874}), 68.0);
  add("UniformManyNeighbours", make.box(1000, {0, 0, 0}, {874, 874, 874}), 250.0);
  add("RaggedTwoNeighbours", make.ragged_box(300, {-9, -9, -9}, {9, 9, 9}), 2.1);
  return scenes;
}

inline std::vector<SearchScene> search_scenes() {
  std::vector<SearchScene> scenes = plain_scenes();
  for (const auto& more : {lattice_scenes(), crowd_scenes(), far_scenes()}) {
    scenes.insert(scenes.end(), more.begin(), more.end());
  }
  return scenes;
}

}  // namespace beespace::test
