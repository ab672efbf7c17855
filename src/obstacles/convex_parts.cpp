#include "obstacles/convex_parts.hpp"

#include "obstacles/side_of_line.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace beespace::obstacles {

namespace {

using Loop = std::vector<std::size_t>;  // corners of a part, counter-clockwise

struct Cut {
  std::size_t from;
  std::size_t to;
};

// Triangles are clipped off where a corner and its two neighbours form one that nothing else looks
// into; every simple outline has such a corner, and stays simple without it. Then cuts are taken
// back where both their ends stay convex (S. Hertel, K. Mehlhorn, Fast triangulation of simple
// polygons, 1983).
class Cutter {
 public:
  explicit Cutter(const std::vector<Corner>& corners) : corners_(corners) {}

  std::vector<Loop> parts() && {
    clip_triangles();
    for (const Cut& cut : cuts_) take_back(cut);
    return std::move(parts_);
  }

 private:
  [[nodiscard]] int side(std::size_t from, std::size_t to, std::size_t corner) const {
    return side_of_line(corners_[from], corners_[to], corners_[corner]);
  }

  void clip_triangles() {
    Loop rest(corners_.size());
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = i;
    std::size_t at = 0;
    while (rest.size() > 3) {
      at %= rest.size();
      const std::size_t before = rest[(at + rest.size() - 1) % rest.size()];
      const std::size_t after = rest[(at + 1) % rest.size()];
      if (is_ear(rest, before, rest[at], after)) {
        parts_.push_back({before, rest[at], after});
        cuts_.push_back({before, after});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(at));
      } else {
        ++at;
      }
    }
    parts_.push_back(std::move(rest));
  }

  [[nodiscard]] bool is_ear(const Loop& rest, std::size_t before, std::size_t tip,
                            std::size_t after) const {
    if (side(before, tip, after) <= 0) return false;
    return std::none_of(rest.begin(), rest.end(), [&](std::size_t other) {
      if (other == before || other == tip || other == after) return false;
      return side(before, tip, other) >= 0 && side(tip, after, other) >= 0 &&
             side(after, before, other) >= 0;
    });
  }

  // Where a part has the cut as an edge, in this direction.
  static std::size_t find_edge(const Loop& loop, const Cut& cut) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i] == cut.from && loop[(i + 1) % loop.size()] == cut.to) return i;
    }
    return loop.size();
  }

  // A part with the cut as its edge, turned so that it begins with it: { from, to, ... }.
  std::size_t part_along(const Cut& cut) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const std::size_t at = find_edge(parts_[i], cut);
      if (at == parts_[i].size()) continue;
      std::rotate(parts_[i].begin(), parts_[i].begin() + static_cast<std::ptrdiff_t>(at),
                  parts_[i].end());
      return i;
    }
    return parts_.size();
  }

  void take_back(const Cut& cut) {
    const std::size_t one = part_along(cut);
    const std::size_t other = part_along({cut.to, cut.from});
    Loop& first = parts_[one];     // { from, to, ..., before from }
    Loop& second = parts_[other];  // { to, from, ..., before to }
    if (side(first.back(), cut.from, second[2]) < 0) return;
    if (side(second.back(), cut.to, first[2]) < 0) return;
    // Round the first one from `to`, and on round the second one from `from`.
    Loop joined(first.begin() + 1, first.end());
    joined.insert(joined.end(), second.begin() + 1, second.end());
    first = std::move(joined);
    std::swap(second, parts_.back());
    parts_.pop_back();
  }

  const std::vector<Corner>& corners_;
  std::vector<Loop> parts_;
  std::vector<Cut> cuts_;
};

}  // namespace

std::vector<Outline> convex_parts(const Outline& outline) {
  if (outline.is_convex()) return {outline};
  std::vector<Outline> parts;
  for (const Loop& loop : Cutter(outline.corners()).parts()) {
    std::vector<Corner> corners;
    for (const std::size_t i : loop) corners.push_back(outline.corners()[i]);
    parts.emplace_back(corners);
  }
  return parts;
}

}  // namespace beespace::obstacles
