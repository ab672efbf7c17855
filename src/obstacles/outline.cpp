#include "obstacles/outline.hpp"

#include "obstacles/side_of_line.hpp"

#include <algorithm>
#include <limits>

namespace beespace::obstacles {

namespace {

// The lowest corner of all, the leftmost of these: it juts out, so the line turns there the way it
// goes round.
bool is_clockwise(const std::vector<Corner>& corners) {
  const auto lowest = std::min_element(
      corners.begin(), corners.end(),
      [](const Corner& a, const Corner& b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
  const Corner& before = lowest == corners.begin() ? corners.back() : *(lowest - 1);
  const Corner& after = lowest + 1 == corners.end() ? corners.front() : *(lowest + 1);
  return side_of_line(before, *lowest, after) < 0;
}

std::vector<Corner> without_straight_ones(std::span<const Corner> corners) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& before = corners[(i + corners.size() - 1) % corners.size()];
    const Corner& after = corners[(i + 1) % corners.size()];
    if (side_of_line(before, corners[i], after) != 0) kept.push_back(corners[i]);
  }
  return kept;
}

// The nearest place of an edge: between its ends, or one of them.
struct Foot {
  Corner point;
  enum { kFrom, kBetween, kTo } where;
};

Foot foot_on(const Edge& edge, const Corner& place) {
  const auto& [from, to] = edge;
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  // Measured from both ends, so that close to either it is known on which side of it the foot is.
  const double after_from = (place.x - from.x) * x + (place.y - from.y) * y;
  const double before_to = (to.x - place.x) * x + (to.y - place.y) * y;
  if (!(after_from > 0.0)) return {from, Foot::kFrom};
  if (!(before_to > 0.0)) return {to, Foot::kTo};
  const double squared = x * x + y * y;
  if (after_from < before_to) {
    const double share = after_from / squared;
    return {{from.x + x * share, from.y + y * share}, Foot::kBetween};
  }
  const double share = before_to / squared;
  return {{to.x - x * share, to.y - y * share}, Foot::kBetween};
}

// Of an edge the normal is at right angles to it, however near the place is; of a corner, it comes
// from there.
NearestEdge nearest_at(const Foot& foot, const Edge& edge, const Corner& place, bool inside) {
  const double distance = distance_between(foot.point, place);
  const double signed_distance = inside && distance > 0.0 ? -distance : distance;
  if (foot.where == Foot::kBetween || !(distance > 0.0)) {
    const double length = distance_between(edge.from, edge.to);
    return {foot.point,
            signed_distance,
            {(edge.to.y - edge.from.y) / length, (edge.from.x - edge.to.x) / length}};
  }
  return {foot.point,
          signed_distance,
          {(place.x - foot.point.x) / signed_distance, (place.y - foot.point.y) / signed_distance}};
}

}  // namespace

Outline::Outline(std::span<const Corner> corners) : corners_(without_straight_ones(corners)) {
  if (is_clockwise(corners_)) std::reverse(corners_.begin(), corners_.end());
}

bool Outline::is_convex() const {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Corner& to = corners_[(i + 1) % corners_.size()];
    const Corner& after = corners_[(i + 2) % corners_.size()];
    if (side_of_line(corners_[i], to, after) < 0) return false;
  }
  return true;
}

bool Outline::contains(const Corner& place) const {
  bool inside = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Corner& from = corner_before(i);
    const Corner& to = corners_[i];
    const bool up = to.y > place.y;
    if ((from.y > place.y) == up) continue;
    if ((side_of_line(from, to, place) > 0) == up) inside = !inside;
  }
  return inside;
}

NearestEdge Outline::nearest(const Corner& place) const {
  const bool inside = contains(place);
  // Of a thin part, both long edges are as far away but for rounding. The nearest one is that which
  // has the place on its side; that is exact.
  const auto is_behind = [&](std::size_t edge) {
    const int side = side_of_line(corner_before(edge), corners_[edge], place);
    return inside ? side < 0 : side > 0;
  };
  const auto foot_of = [&](std::size_t edge) {
    return foot_on({corner_before(edge), corners_[edge]}, place);
  };
  double least = std::numeric_limits<double>::infinity();
  std::size_t edge = 0;  // by the corner that it ends at
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Foot foot = foot_of(i);
    const double distance = distance_between(foot.point, place);
    if (!(distance < least)) continue;
    if (foot.where == Foot::kBetween && is_behind(i)) continue;
    least = distance;
    edge = i;
  }
  Foot foot = foot_of(edge);
  // Close to a corner distances round to the same, too; but no corner is the nearest where one of
  // its two edges has a foot between its ends.
  if (foot.where != Foot::kBetween) {
    const std::size_t other = foot.where == Foot::kTo ? after(edge) : before(edge);
    const Foot on_other = foot_of(other);
    if (on_other.where == Foot::kBetween && !is_behind(other)) {
      foot = on_other;
      edge = other;
    }
  }
  return nearest_at(foot, {corner_before(edge), corners_[edge]}, place, inside);
}

}  // namespace beespace::obstacles
