#include "grid/coincident_points.hpp"

#include "base/hash.hpp"

#include <algorithm>
#include <bit>

namespace beespace::core {

CoincidentPoints::CoincidentPoints(const PointsView& points, Memory& memory)
    : place_of_(memory, points.size()) {
  constexpr std::uint32_t kNone = 0xFFFF'FFFFU;
  Buffer<PointId> first(memory, points.size());  // at each place
  {
    // Open addressing; a slot holds the place that it stands for.
    const std::size_t slots = std::bit_ceil(2 * points.size() + 1);
    Buffer<std::uint32_t> place_in(memory, slots);
    std::fill_n(place_in.data(), slots, kNone);
    for (std::size_t id = 0; id < points.size(); ++id) {
      const Point p = points[id];
      std::size_t slot = hash_place(p) & (slots - 1);
      while (place_in[slot] != kNone && points[first[place_in[slot]]] != p) {
        slot = (slot + 1) & (slots - 1);
      }
      if (place_in[slot] == kNone) {
        place_in[slot] = static_cast<std::uint32_t>(size_);
        first[size_++] = static_cast<PointId>(id);
      }
      place_of_[id] = place_in[slot];
    }
  }
  places_ = Buffer<Point>(memory, size_);
  points_at_ = Buffer<std::uint32_t>(memory, size_);
  for (std::size_t place = 0; place < size_; ++place) {
    places_[place] = points[first[place]];
    points_at_[place] = 0;
  }
  for (std::size_t id = 0; id < points.size(); ++id) ++points_at_[place_of_[id]];
}

PointsView CoincidentPoints::places() const {
  const Point* const first = places_.data();
  return PointsView::strided(&first->x, &first->y, &first->z, size_, sizeof(Point));
}

}  // namespace beespace::core
