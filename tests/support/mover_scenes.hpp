// The moving swarms on which predictions are compared with brute force: small, hard, and named.
#pragma once

#include "tests/support/lattice_scenes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/closest_approach.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace beespace::test {

enum class Shape { kSphere, kCylinder, kHeightsApart };

inline const char* name_of(Shape shape) {
  if (shape == Shape::kSphere) return "spheres";
  return shape == Shape::kCylinder ? "cylinders" : "cylinders of heights apart";
}

struct MoverScene {
  std::string name;
  std::vector<Mover> movers;
  double threshold_m = 0.0;
  double vertical_m = 0.0;  // where cylinders are asked for
  double horizon_s = 0.0;

  // Heights apart from positions, in the order of the movers.
  std::vector<double> heights_m = {};
  std::vector<double> climbs_mps = {};

  friend std::ostream& operator<<(std::ostream& out, const MoverScene& scene) {
    return out << scene.name;
  }

  [[nodiscard]] PredictOptions options(Shape shape, bool inclusive) const {
    PredictOptions options;
    options.threshold_m = threshold_m;
    if (shape != Shape::kSphere) options.vertical_m = vertical_m;
    options.horizon_s = horizon_s;
    options.inclusive = inclusive;
    return options;
  }

  [[nodiscard]] MoversView view(Shape shape) const {
    const MoversView view(movers);
    if (shape != Shape::kHeightsApart) return view;
    return {view.positions(), view.velocities(), heights_m, climbs_mps};
  }
};

// Calls ask(shape, inclusive) for all queries about a scene.
template <class Ask>
void for_each_question(Ask&& ask) {
  for (const Shape shape : {Shape::kSphere, Shape::kCylinder, Shape::kHeightsApart}) {
    for (const bool inclusive : {false, true}) ask(shape, inclusive);
  }
}

// Of the scenes whose encounters lie at whole numbers of steps.
inline constexpr double kStepOfEdges_s = 0.375;

inline Velocity faster(const Velocity& v, const Velocity& by) {
  return {v.x + by.x, v.y + by.y, v.z + by.z};
}

inline Mover moved_along(Mover mover, const Point& by, const Velocity& faster_by) {
  return {shifted(mover.position, by), faster(mover.velocity, faster_by)};
}

inline std::vector<Mover> flying(SceneMaker& make, std::size_t size, const Point& box,
                                 double speed) {
  std::vector<Mover> movers;
  for (const Point& p : make.ragged_box(size, {0, 0, 0}, box)) {
    const Point v = make.ragged_box(1, {-speed, -speed, -speed}, {speed, speed, speed})[0];
    movers.push_back({p, {v.x, v.y, v.z}});
  }
  return movers;
}

inline std::vector<Mover> hovering_among_fast_ones(SceneMaker& make) {
  std::vector<Mover> movers = flying(make, 260, {900, 900, 100}, 0.0);
  for (std::size_t i = 0; i < movers.size(); i += 6) {
    movers[i].velocity = {make.between(-400, 400), make.between(-400, 400), make.between(-9, 9)};
  }
  return movers;
}

// Pairs that come head-on, or nearly so: past each other at none to twice the threshold.
inline std::vector<Mover> head_on_pairs(SceneMaker& make, double threshold) {
  std::vector<Mover> movers;
  for (int i = 0; i < 120; ++i) {
    const Point at{make.between(0, 4000), make.between(0, 4000), make.between(0, 300)};
    const Velocity v{make.between(-20, 20), make.between(-20, 20), make.between(-2, 2)};
    const double time = make.between(0, 20);
    const double miss = make.between(0, 2 * threshold);
    movers.push_back({{at.x - v.x * time, at.y - v.y * time, at.z - v.z * time}, v});
    movers.push_back(
        {{at.x + v.x * time, at.y + v.y * time, at.z + v.z * time + miss}, {-v.x, -v.y, -v.z}});
  }
  return movers;
}

inline std::vector<Mover> crossing_streams() {
  std::vector<Mover> movers;
  for (int i = 0; i < 70; ++i) {
    movers.push_back({{-12.0 * i, 0.0, 100.0}, {15.0, 0.0, 0.0}});
    movers.push_back({{0.5, 11.0 * i + 3.0, 100.0 + 0.1 * i}, {0.0, -15.0, 0.0}});
  }
  return movers;
}

// From everywhere on a sphere to the opposite side: all meet in the middle at the same time.
inline std::vector<Mover> sphere_swap() {
  std::vector<Mover> movers;
  for (const Point& p : integer_sphere(15)) {
    movers.push_back({{40 * p.x, 40 * p.y, 40 * p.z}, {-2 * p.x, -2 * p.y, -2 * p.z}});
  }
  movers.pop_back();  // its centre
  return movers;
}

inline std::vector<Mover> formation(int side, double step, const Velocity& velocity) {
  std::vector<Mover> movers;
  for (const Point& p : integer_lattice(side, step, {-7.0, 3.0, 50.0})) {
    movers.push_back({p, velocity});
  }
  return movers;
}

inline std::vector<Mover> with_far_outliers(SceneMaker& make) {
  std::vector<Mover> movers = flying(make, 150, {300, 300, 300}, 6.0);
  for (const double far : {1e5, 1e7, 1e9}) {
    for (const double side : {-1.0, 1.0}) {
      movers.push_back({{side * far, 0.3 * far, -far}, {1.0, 2.0, side}});
      // Arrives in the swarm after ten seconds.
      movers.push_back({{side * far, far, 150.0}, {-0.1 * side * far, -0.1 * far, 0.0}});
    }
  }
  return movers;
}

// Small integers in small boxes: whatever can be at the edge of a conflict is.
inline std::vector<Mover> lattice_flight(SceneMaker& make, std::size_t size, double unit,
                                         const Point& origin) {
  const auto integer = [&](int most) {
    return unit * (static_cast<double>(make.below(static_cast<std::size_t>(2 * most + 1))) - most);
  };
  std::vector<Mover> movers;
  for (std::size_t i = 0; i < size; ++i) {
    const Point p{integer(9), integer(9), integer(9)};
    movers.push_back({shifted(p, origin), {integer(3), integer(3), integer(2)}});
  }
  return movers;
}

// An axis of three at right angles, each of length 9: what is composed of them has whole numbers
// for lengths.
struct Axes {
  Point along;
  Point aside;
};
inline Axes axes_of(std::size_t number) {
  const Point axes[3] = {{1, 4, 8}, {4, 7, -4}, {8, -4, 1}};
  const double side = number % 2 == 0 ? 1.0 : -1.0;
  const Point& aside = axes[(number + 1 + number / 3 % 2) % 3];
  return {axes[number % 3], {side * aside.x, side * aside.y, side * aside.z}};
}

// Pairs far from each other. Each passes at exactly the threshold (9 m), or one ulp beside it, at a
// whole number of steps, or one ulp beside it; or comes head-on and is at the threshold then.
inline std::vector<Mover> encounters_at_edges_of_steps(SceneMaker& make) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Mover> movers;
  for (std::size_t i = 0; i < 180; ++i) {
    const auto [along, aside] = axes_of(i);
    double time = kStepOfEdges_s * static_cast<double>(i % 17);
    if (i % 3 == 1 && time > 0.0) time = std::nextafter(time, 0.0);
    if (i % 3 == 2 && time > 0.0) time = std::nextafter(time, kInfinity);
    const bool head_on = i % 5 == 0;
    const Velocity v{3 * along.x, 3 * along.y, 3 * along.z};
    const double back = head_on ? 3 * time + 1.0 : 3 * time;
    Point p{-along.x * back, -along.y * back, -along.z * back};
    if (!head_on) p = shifted(p, aside);
    if (i % 4 == 1) p.x = std::nextafter(p.x, kInfinity);
    if (i % 4 == 3) p.x = std::nextafter(p.x, -kInfinity);
    const Point place{1000.0 * static_cast<double>(i % 14), 1000.0 * static_cast<double>(i / 14),
                      1.0 * static_cast<double>(make.below(64))};
    // Of the place, only whole numbers: nothing of what was nudged is rounded where it is zero.
    const Point at = i % 2 == 0 ? place : Point{0.0, 0.0, place.x + 16.0 * place.y};
    movers.push_back({at, {}});
    movers.push_back({shifted(p, at), v});
  }
  return movers;
}

// Nearly all passes are at the threshold within a few roundings, anywhere in space and time.
inline std::vector<Mover> grazing_pairs(SceneMaker& make, double threshold) {
  std::vector<Mover> movers;
  for (std::size_t i = 0; i < 200; ++i) {
    const auto [along, aside] = axes_of(i);
    const Point at{make.between(0, 9000), make.between(0, 9000), make.between(0, 900)};
    const double time = make.between(0, 25);
    const double speed = make.between(0.1, 30) / 9.0;
    const double miss = threshold / 9.0;
    const Velocity own{make.between(-5, 5), make.between(-5, 5), make.between(-1, 1)};
    const Velocity v{own.x + speed * along.x, own.y + speed * along.y, own.z + speed * along.z};
    movers.push_back({at, own});
    movers.push_back({{at.x + miss * aside.x - speed * along.x * time,
                       at.y + miss * aside.y - speed * along.y * time,
                       at.z + miss * aside.z - speed * along.z * time},
                      v});
  }
  return movers;
}

inline std::vector<MoverScene> mover_scenes() {
  SceneMaker make(20240901);
  std::vector<MoverScene> scenes;
  const auto add = [&](const char* name, std::vector<Mover> movers, double threshold,
                       double vertical, double horizon) {
    if (kSanitized && movers.size() > 60) movers.resize(60);
    MoverScene scene{name, std::move(movers), threshold, vertical, horizon};
    for (std::size_t i = 0; i < scene.movers.size(); ++i) {
      const Mover& next = scene.movers[(i + 1) % scene.movers.size()];
      scene.heights_m.push_back(next.position.z);
      scene.climbs_mps.push_back(next.velocity.z);
    }
    scenes.push_back(std::move(scene));
  };
  const Mover one{{1, 2, 3}, {4, 5, 6}};
  add("Empty", {}, 1, 1, 10);
  add("OneAlone", {one}, 1, 1, 10);
  add("TwoAtTheSamePlace", {one, {{1, 2, 3}, {0, 0, 0}}}, 1e-3, 1e-3, 10);
  // Found in the step that ends when they pass, and in the next one again.
  add("TwoPassAtTheEdgeOfAStep", {{{-9, 8, 0}, {3 / kStepOfEdges_s, 0, 0}}, {{0, 0, 0}, {}}}, 9, 9,
      8 * kStepOfEdges_s);
  add("RandomFlight", flying(make, 300, {800, 800, 200}, 12), 25, 10, 30);
  add("RandomFlightInAPlane", flying(make, 250, {900, 900, 0}, 12), 12, 5, 20);
  add("FarApartForALongTime", flying(make, 200, {2e5, 2e5, 1e3}, 20), 3000, 2500, 20'000);
  add("HoveringAmongFastOnes", hovering_among_fast_ones(make), 25, 16, 12);
  add("HeadOnPairs", head_on_pairs(make, 30), 30, 15, 25);
  add("CrossingStreams", crossing_streams(), 9, 3, 40);
  add("SphereSwap", sphere_swap(), 5, 4, 30);
  add("AllAtOnePlace", flying(make, 110, {0, 0, 0}, 9), 2, 1, 3);
  add("FormationAtTheThreshold", formation(5, 4.0, {11, -7, 0.5}), 4, 4, 60);
  add("FormationAtAHugeVelocity", formation(4, 4.0, {1e9, -3e9, 7e8}), 4, 4, 60);
  std::vector<Mover> drifting = flying(make, 200, {500, 500, 100}, 8);
  for (Mover& mover : drifting) mover = moved_along(mover, {0, 0, 0}, {1e7, 1e7, -1e6});
  add("RandomFlightOnAHugeVelocity", drifting, 20, 10, 20);
  add("FarOutliers", with_far_outliers(make), 12, 6, 15);
  add("Lattice", lattice_flight(make, 160, 1.0, {0, 0, 0}), 3, 2, 2.5);
  add("LatticeWithoutAHorizon", lattice_flight(make, 200, 1.0, {0, 0, 0}), 3, 2, 0);
  add("LatticeABillionMetresAway", lattice_flight(make, 140, 1.0, {1e9, -1e9, 1e9}), 3, 2, 2);
  // Places along the way are rounded to a hundredth of a length of the lattice.
  add("FineLatticeABillionMetresAway", lattice_flight(make, 140, 0x1p-16, {1e9 + 0.375, -1e9, 1e9}),
      0x3p-16, 0x2p-16, 2.5);
  add("LatticeOfTinyLengths", lattice_flight(make, 120, 0x1p-98, {0, 0, 0}), 0x3p-98, 0x1p-97, 2);
  add("LatticeOfHugeLengths", lattice_flight(make, 120, 0x1p+94, {0, 0, 0}), 0x3p+94, 0x1p+95, 2);
  add("AtEdgesOfSteps", encounters_at_edges_of_steps(make), 9, 8, 6.5);
  add("GrazingPairs", grazing_pairs(make, 40), 40, 40, 30);
  return scenes;
}

}  // namespace beespace::test
