// Scenes in which very many pairs are exactly at the threshold, or as near to it as doubles get.
#pragma once

#include "tests/support/scene_maker.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace beespace::test {

// Pairs at exactly the threshold and one ulp either side, on every axis and along the diagonal of
// a 3-4-12-13 box, each pair far from the others.
inline std::vector<Point> pairs_around_threshold(double threshold) {
  const double below = std::nextafter(threshold, 0.0);
  const double above = std::nextafter(threshold, 2.0 * threshold);
  std::vector<Point> points;
  double place = 0.0;
  const auto add = [&](const Point& offset) {
    place += 16.0 * threshold;
    points.push_back({0.0, place, 0.0});
    points.push_back({offset.x, place + offset.y, offset.z});
  };
  for (const double distance : {below, threshold, above}) {
    add({distance, 0.0, 0.0});
    add({-distance, 0.0, 0.0});
    add({0.0, 0.0, distance});
  }
  const double unit = threshold / 13.0;
  for (const double z :
       {std::nextafter(12.0 * unit, 0.0), 12.0 * unit, std::nextafter(12.0 * unit, threshold)}) {
    add({3.0 * unit, 4.0 * unit, z});
  }
  return points;
}

inline std::vector<Point> integer_lattice(int side, double step, const Point& origin) {
  std::vector<Point> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) {
        points.push_back({origin.x + x * step, origin.y + y * step, origin.z + z * step});
      }
    }
  }
  return points;
}

// Flat: one of the axes keeps one value. Pairs at 5 also along (3, 4).
inline std::vector<Point> flat_lattice(int side, int flat_axis, double height) {
  std::vector<Point> points;
  for (int a = 0; a < side; ++a) {
    for (int b = 0; b < side; ++b) {
      const double u = a;
      const double v = b;
      if (flat_axis == 0) points.push_back({height, u, v});
      if (flat_axis == 1) points.push_back({u, height, v});
      if (flat_axis == 2) points.push_back({u, v, height});
    }
  }
  return points;
}

// Corners and centres of faces of cubes of side 2: nearest neighbours at the square root of 2.
inline std::vector<Point> face_centred_lattice(int side) {
  std::vector<Point> points;
  for (int x = 0; x < 2 * side; ++x) {
    for (int y = 0; y < 2 * side; ++y) {
      for (int z = 0; z < 2 * side; ++z) {
        if ((x + y + z) % 2 != 0) continue;
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  return points;
}

// Turned by the quaternion (w, x, y, z): entries of the matrix are fractions, and their rounding
// makes distances that were equal differ in the last bits.
inline std::vector<Point> turned(const std::vector<Point>& points, double w, double x, double y,
                                 double z) {
  const double n = w * w + x * x + y * y + z * z;
  const Point rows[3] = {
      {(w * w + x * x - y * y - z * z) / n, 2.0 * (x * y - w * z) / n, 2.0 * (x * z + w * y) / n},
      {2.0 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2.0 * (y * z - w * x) / n},
      {2.0 * (x * z - w * y) / n, 2.0 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n}};
  const auto times = [](const Point& row, const Point& p) {
    return row.x * p.x + row.y * p.y + row.z * p.z;
  };
  std::vector<Point> result;
  for (const Point& p : points) {
    result.push_back({times(rows[0], p), times(rows[1], p), times(rows[2], p)});
  }
  return result;
}

inline std::vector<Point> moved(std::vector<Point> points, const Point& by) {
  for (Point& p : points) p = shifted(p, by);
  return points;
}

// `size` points, each `step` further along `direction`.
inline std::vector<Point> row_of_points(int size, double step, const Point& direction) {
  std::vector<Point> points;
  for (int i = 0; i < size; ++i) {
    points.push_back({i * step * direction.x, i * step * direction.y, i * step * direction.z});
  }
  return points;
}

// All integer points at `radius` from the origin, which comes last.
inline std::vector<Point> integer_sphere(int radius) {
  std::vector<Point> points;
  for (int x = -radius; x <= radius; ++x) {
    for (int y = -radius; y <= radius; ++y) {
      for (int z = -radius; z <= radius; ++z) {
        if (x * x + y * y + z * z != radius * radius) continue;
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  points.push_back({0, 0, 0});
  return points;
}

// Coordinates at multiples of the threshold and one ulp beside them: where cells begin and end, if
// their side is the threshold.
inline std::vector<Point> on_faces_of_cells(SceneMaker& make, std::size_t size, double threshold) {
  const auto coordinate = [&] {
    const double face = static_cast<double>(make.below(7)) * threshold - 3.0 * threshold;
    const std::size_t side = make.below(3);
    if (side == 0) return face;
    const double infinity = std::numeric_limits<double>::infinity();
    return face == 0.0 ? 0.0 : std::nextafter(face, side == 1 ? -infinity : infinity);
  };
  std::vector<Point> points(size);
  for (Point& p : points) {
    p.x = coordinate();
    p.y = coordinate();
    p.z = coordinate();
  }
  return points;
}

// The paper's open case. Cells whose diagonal is the threshold have the side s = X / sqrt(3): two
// points in cells that do not touch may still be too close. Each pair leaves out one layer, along
// an axis, a face's diagonal or the cube's, by margins from an ulp to a tenth of the side.
inline std::vector<Point> two_layers_apart(double threshold) {
  const double side = threshold / std::sqrt(3.0);
  std::vector<Point> points;
  double place = 0.0;
  for (const double margin : {0.0, 0x1p-52, 0x1p-40, 1e-3, 0.1}) {
    const double from = side * (1.0 - margin);
    const double to = 2.0 * side * (1.0 + margin);
    const double level = 0.5 * side;
    for (int axes = 1; axes < 8; ++axes) {
      place += 40.0 * side;
      const bool x = (axes & 1) != 0;
      const bool y = (axes & 2) != 0;
      const bool z = (axes & 4) != 0;
      points.push_back({place + (x ? from : level), y ? from : level, z ? from : level});
      points.push_back({place + (x ? to : level), y ? to : level, z ? to : level});
    }
  }
  return points;
}

// Two points just not closer than the threshold, in opposite corners of a cube whose diagonal is
// the threshold, at the low end of the scene, where cells begin. Some are alone, far away.
inline std::vector<Point> opposite_corners(double threshold) {
  double side = threshold / std::sqrt(3.0);
  while (3.0 * side * side < threshold * threshold) side = std::nextafter(side, threshold);
  side = std::nextafter(side, threshold);
  std::vector<Point> points = {{0, 0, 0}, {side, side, side}};
  for (int i = 1; i <= 20; ++i) points.push_back({i * 10.0 * threshold, 0, 0});
  return points;
}

inline std::vector<SearchScene> lattice_scenes() {
  SceneMaker make(5);
  const double third = 1.0 / 3.0;
  return {
      {"AtTheThresholdOnePointZero", pairs_around_threshold(1.0), 1.0},
      {"AtTheThresholdOneHundred", pairs_around_threshold(100.0), 100.0},
      {"AtTheThresholdOneThird", pairs_around_threshold(third), third},
      {"LatticeAtTheThreshold", integer_lattice(9, 1.0, {0, 0, 0}), 1.0},
      {"LatticeAtItsDiagonal", integer_lattice(8, 1.0, {0, 0, 0}), std::sqrt(2.0)},
      {"LatticeAtThree", integer_lattice(7, 1.0, {-3, -3, -3}), 3.0},
      {"LatticeFarFromTheOrigin", integer_lattice(8, 0.1, {1e9, -1e9, 1e9}), 0.1},
      {"LatticeAMillionMetresAway", integer_lattice(7, 1.0, {1e6, 1e6, -1e6}), 1.0},
      {"LatticeOfTenthsAMillionMetresAway", integer_lattice(7, 0.1, {-1e6, 1e6, 1e6}), 0.1},
      {"LatticeOfTenths", integer_lattice(7, 0.1, {0, 0, 0}), 0.1},
      {"FaceCentredAtNearest", face_centred_lattice(4), std::sqrt(2.0)},
      {"FaceCentredAtSecondNearest", face_centred_lattice(4), 2.0},
      {"TurnedLattice", turned(integer_lattice(7, 1.0, {-3, -3, -3}), 2, 3, 4, 5), 1.0},
      {"TurnedLatticeAgain", turned(integer_lattice(7, 1.0, {0, 0, 0}), 7, 1, -2, 3),
       std::sqrt(3.0)},
      {"TurnedLatticeFarAway",
       moved(turned(integer_lattice(6, 1.0, {0, 0, 0}), 1, 2, 0, -4), {1e6, -1e6, 1e6}), 1.0},
      {"TurnedFaceCentred", turned(face_centred_lattice(3), 1, 1, 3, 9), std::sqrt(2.0)},
      {"RowAtTheThresholdX", row_of_points(200, 0.25, {1, 0, 0}), 0.25},
      {"RowAtTheThresholdY", row_of_points(200, 0.1, {0, -1, 0}), 0.1},
      {"RowAtTheThresholdZ", row_of_points(200, third, {0, 0, 1}), third},
      {"RowAlongThreeFourTwelve", row_of_points(150, 1.0, {3, 4, 12}), 13.0},
      {"FlatLatticeOfConstantX", flat_lattice(16, 0, -0.1), 5.0},
      {"FlatLatticeOfConstantY", flat_lattice(16, 1, 1e9), 1.0},
      {"FlatLatticeOfConstantZ", flat_lattice(16, 2, 120.1), 5.0},
      {"SphereAroundACentre", integer_sphere(9), 9.0},
      {"SphereOfTies", integer_sphere(15), 3.0},
      {"FacesOfCellsOfOneHundred", on_faces_of_cells(make, 250, 100.0), 100.0},
      {"FacesOfCellsOfATenth", on_faces_of_cells(make, 250, 0.1), 0.1},
      {"OppositeCornersOfACell", opposite_corners(100.0), 100.0},
      {"OppositeCornersOfACellOfATenth", opposite_corners(0.1), 0.1},
      {"TwoLayersApart", two_layers_apart(100.0), 100.0},
  };
}

}  // namespace beespace::test
