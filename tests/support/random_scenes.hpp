// Small random scenes of every shape, each from its number: cases that no author thought of.
#pragma once

#include "tests/support/scene_maker.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::test {

// A box that may be flat or long and may lie far away, on any scale; some of its points are moved
// to a lattice of half the threshold, some to where another one is, some right beside another one.
inline SearchScene random_scene(std::uint32_t number) {
  SceneMaker make(1000 + number);
  const double scale = std::ldexp(1.0, static_cast<int>(make.below(60)) - 30);
  const auto side = [&] {
    const std::size_t shape = make.below(4);
    return shape == 0 ? 0.0 : scale * (shape == 1 ? 0.05 : make.between(0.2, 1.0));
  };
  Point high;
  high.x = side();
  high.y = side();
  high.z = side();
  const std::size_t size = 2 + make.below(140);
  SearchScene scene{"Random" + std::to_string(number), make.ragged_box(size, {0, 0, 0}, high),
                    scale * make.between(0.01, 0.3)};
  const double step = 0.5 * scene.threshold_m;
  const std::size_t moved = make.below(size);
  for (std::size_t i = 0; i < moved; ++i) {
    Point& p = scene.points[make.below(size)];
    const Point& other = scene.points[make.below(size)];
    const std::size_t how = make.below(4);
    if (how == 0) p = other;
    if (how == 1) p = {other.x + scene.threshold_m, other.y, other.z};
    if (how >= 2) {
      p = {std::floor(p.x / step) * step, std::floor(p.y / step) * step,
           std::floor(p.z / step) * step};
    }
  }
  if (make.below(3) == 0) {
    const Point away{-1e4 * scale, 1e4 * scale, 3e4 * scale};
    for (Point& p : scene.points) p = shifted(p, away);
  }
  return scene;
}

}  // namespace beespace::test
