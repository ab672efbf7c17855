#include "obstacles/crossing.hpp"

#include "obstacles/side_of_line.hpp"

#include <algorithm>

namespace beespace::obstacles {

namespace {

bool overlap(double a, double b, double c, double d) {
  return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b);
}

// Two lines that cross have each edge's ends on both sides of the other, or on it; where all four
// are on one line, the edges meet where their shadows on both axes do.
bool meet(const Edge& a, const Edge& b) {
  if (!overlap(a.from.x, a.to.x, b.from.x, b.to.x)) return false;
  if (!overlap(a.from.y, a.to.y, b.from.y, b.to.y)) return false;
  const auto parts = [](const Edge& line, const Edge& edge) {
    return side_of_line(line.from, line.to, edge.from) *
               side_of_line(line.from, line.to, edge.to) <=
           0;
  };
  return parts(a, b) && parts(b, a);
}

}  // namespace

std::span<const Corner> without_closing_corner(std::span<const Corner> outline) {
  if (outline.size() < 2) return outline;
  const Corner& first = outline.front();
  const Corner& last = outline.back();
  return first.x == last.x && first.y == last.y ? outline.first(outline.size() - 1) : outline;
}

bool all_on_one_line(std::span<const Corner> corners) {
  for (const Corner& corner : corners) {
    if (side_of_line(corners[0], corners[1], corner) != 0) return false;
  }
  return true;
}

std::optional<Crossing> first_crossing(std::span<const Corner> corners) {
  const std::size_t count = corners.size();
  const auto edge = [&](std::size_t i) {
    return Edge{corners[i], corners[i + 1 < count ? i + 1 : 0]};
  };
  for (std::size_t i = 0; i + 2 < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j + 1 == count) continue;  // joined by the first corner
      if (meet(edge(i), edge(j))) return Crossing{i, j};
    }
  }
  return std::nullopt;
}

}  // namespace beespace::obstacles
