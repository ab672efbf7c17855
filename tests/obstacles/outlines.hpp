// Outlines of all sorts: made by hand, drawn at random, on a lattice where much is on one line.
#pragma once

#include "scenes/random_stream.hpp"

#include <beespace/obstacle.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::test {

using Corners = std::vector<Corner>;

inline Corners square() {
  return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}
inline Corners letter_l() {
  return {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
}
inline Corners letter_u() {
  return {{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
}
inline Corners star() {
  return {{0, 5}, {-1, 1}, {-5, 1}, {-2, -1}, {-3, -5}, {0, -2}, {3, -5}, {2, -1}, {5, 1}, {1, 1}};
}
// A lane that winds inwards, with corners on straight walls too.
inline Corners spiral() {
  return {{0, 0}, {3, 0}, {7, 0}, {7, 7}, {1, 7}, {1, 2}, {5, 2}, {5, 5}, {3, 5},
          {3, 4}, {4, 4}, {4, 3}, {2, 3}, {2, 6}, {6, 6}, {6, 3}, {6, 1}, {0, 1}};
}
inline Corners comb() {
  return {{0, 0}, {9, 0}, {9, 5}, {8, 1}, {7, 5}, {6, 1}, {5, 5}, {4, 1}, {3, 5}, {2, 1}, {1, 5}};
}

// Seen from the middle each corner comes after the one before it, near or far.
inline Corners random_star(scenes::RandomStream& random, std::size_t size) {
  Corners corners;
  for (std::size_t i = 0; i < size; ++i) {
    const double turn = (static_cast<double>(i) + random.uniform(0.0, 0.4)) /
                        static_cast<double>(size) * 2.0 * 3.14159265358979;
    const double far = random.uniform(0.2, 5.0);
    corners.push_back({far * std::cos(turn), far * std::sin(turn)});
  }
  return corners;
}

inline int side(const Corner& a, const Corner& b, const Corner& p) {
  const double doubled_area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  return (doubled_area > 0.0 ? 1 : 0) - (doubled_area < 0.0 ? 1 : 0);
}

// On the line of a and b: between them, or one of them.
inline bool lies_between(const Corner& a, const Corner& b, const Corner& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

// Whether two edges meet; in plain doubles, so exact for small whole numbers, and for others except
// in borderline cases.
inline bool edges_meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const int sides[] = {side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)};
  if (sides[0] == 0 && lies_between(a, b, c)) return true;
  if (sides[1] == 0 && lies_between(a, b, d)) return true;
  if (sides[2] == 0 && lies_between(c, d, a)) return true;
  if (sides[3] == 0 && lies_between(c, d, b)) return true;
  return sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0;
}

// The edges that begin at these corners.
inline std::optional<std::pair<std::size_t, std::size_t>> any_crossing(const Corners& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j == count - 1) continue;
      if (edges_meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % count])) {
        return std::pair{i, j};
      }
    }
  }
  return std::nullopt;
}

// A tour of the corners, turned round where it crosses itself until it does not. Nothing where that
// leads nowhere, as it may where corners lie on edges.
inline std::optional<Corners> untangled(Corners corners) {
  for (int tries = 0; tries < 1000; ++tries) {
    const auto crossing = any_crossing(corners);
    if (!crossing) return corners;
    std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(crossing->first) + 1,
                 corners.begin() + static_cast<std::ptrdiff_t>(crossing->second) + 1);
  }
  return std::nullopt;
}

inline Corners random_tangle(scenes::RandomStream& random, std::size_t size) {
  while (true) {
    Corners corners;
    for (std::size_t i = 0; i < size; ++i) {
      corners.push_back({random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)});
    }
    if (auto outline = untangled(corners)) return *outline;
  }
}

// Whole numbers, so that three corners are often on one line. No two at one place.
inline Corners random_lattice(scenes::RandomStream& random, std::size_t size) {
  while (true) {
    Corners corners;
    while (corners.size() < size) {
      const Corner next{static_cast<double>(random.index(7)), static_cast<double>(random.index(7))};
      const auto is_next = [&](const Corner& c) { return c.x == next.x && c.y == next.y; };
      if (std::none_of(corners.begin(), corners.end(), is_next)) corners.push_back(next);
    }
    if (size == 3 && side(corners[0], corners[1], corners[2]) == 0) continue;
    if (auto outline = untangled(corners)) return *outline;
  }
}

// Begun at any corner, either way round.
inline Corners begun_anywhere(Corners corners, scenes::RandomStream& random) {
  const auto size = static_cast<std::uint32_t>(corners.size());
  std::rotate(corners.begin(), corners.begin() + random.index(size), corners.end());
  if (random.index(2) == 0) std::reverse(corners.begin(), corners.end());
  return corners;
}

inline Corners random_outline(scenes::RandomStream& random) {
  const std::size_t size = 3 + random.index(10);
  const auto draw = [&]() -> Corners {
    switch (random.index(10)) {
      case 0:
        return square();
      case 1:
        return letter_l();
      case 2:
        return letter_u();
      case 3:
        return star();
      case 4:
        return spiral();
      case 5:
        return comb();
      case 6:
        return random_star(random, size);
      case 7:
        return random_lattice(random, size);
      default:
        return random_tangle(random, size);
    }
  };
  return begun_anywhere(draw(), random);
}

// Turned by the angle of a Pythagorean triple, grown and moved.
inline Corners moved(const Corners& corners, double scale, const Corner& by) {
  Corners result;
  for (const Corner& c : corners) {
    result.push_back(
        {scale * (0.6 * c.x - 0.8 * c.y) + by.x, scale * (0.8 * c.x + 0.6 * c.y) + by.y});
  }
  return result;
}

inline Corner random_corner(scenes::RandomStream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

}  // namespace beespace::test
