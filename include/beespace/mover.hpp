// A bee that moves: where it is now, and how fast it goes which way.
//
// Units: metres and metres per second, in one Cartesian frame whose third axis is the height where
// the height matters. Plain values; a view owns nothing, as in points_view.hpp.
//
// Everything that moves lies in the motion domain: positions, velocities, times and thresholds are
// zero or of a magnitude between kSmallestInMotion and kLargestInMotion. Inside it no product of
// four of them overflows or loses a bit.
//
// Positions, velocities, heights and times that are smaller are taken as zero wherever they enter:
// predictions, recordings, live swarms, advice and verification. That moves a bee by less than
// 2^-99 m, and by as much more a second that it flies on; the distance of two, over T seconds, by
// less than (1 + T) 2^-98 m, which is 3.2e-21 m after 10^9 s. So an answer can differ only for
// pairs that come within so much of the threshold. What is too large is refused, and thresholds
// that are too small are, too.
#pragma once

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <concepts>
#include <cstddef>
#include <span>

namespace beespace {

inline constexpr double kSmallestInMotion = 0x1p-100;  // about 7.9e-31
inline constexpr double kLargestInMotion = 0x1p+100;   // about 1.3e+30

// Metres per second, along the axes of the positions.
struct Velocity {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Velocity&, const Velocity&) = default;
};

struct Mover {
  Point position;
  Velocity velocity;

  friend constexpr bool operator==(const Mover&, const Mover&) = default;
};

namespace detail {
template <class T>
concept SpanOfMovers = std::convertible_to<const T&, std::span<const Mover>>;
}  // namespace detail

// Movers in the caller's memory: positions, and as many velocities, whatever their layout.
class MoversView {
 public:
  constexpr MoversView() = default;

  // Movers one after the other: std::vector<Mover>, std::array<Mover, N>, std::span<const Mover>.
  template <detail::SpanOfMovers Movers>
  MoversView(const Movers& movers)  // NOLINT(google-explicit-constructor): a view
      : MoversView(std::span<const Mover>(movers), FromSpan{}) {}

  // `velocities` has one vector in metres per second for each of `positions`. If there are more of
  // the one than of the other, they do not fit together, which is an error, kInvalidArgument, of
  // every question that the view is given to; so are arrays of other lengths below.
  MoversView(const PointsView& positions, const PointsView& velocities)
      : positions_(positions), velocities_(velocities) {}

  // The same with heights that are kept apart from positions, and climb rates: for a vertical
  // threshold between bees whose third axis is not the height. Then positions and velocities are
  // horizontal: of geographic positions, those brought to height 0 (see to_ecef). Both spans are as
  // long as the view, or both empty.
  MoversView(const PointsView& positions, const PointsView& velocities,
             std::span<const double> heights_m, std::span<const double> climbs_mps)
      : positions_(positions),
        velocities_(velocities),
        heights_m_(heights_m),
        climbs_mps_(climbs_mps) {}

  // Whether there is as much of everything.
  [[nodiscard]] bool fits() const {
    const std::size_t heights = has_heights() ? size() : 0;
    return positions_.fits() && velocities_.fits() && positions_.size() == velocities_.size() &&
           heights_m_.size() == heights && climbs_mps_.size() == heights;
  }

  [[nodiscard]] bool has_heights() const { return !heights_m_.empty() || !climbs_mps_.empty(); }
  [[nodiscard]] std::span<const double> heights_m() const { return heights_m_; }
  [[nodiscard]] std::span<const double> climbs_mps() const { return climbs_mps_; }

  [[nodiscard]] std::size_t size() const {
    return positions_.size() < velocities_.size() ? positions_.size() : velocities_.size();
  }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] const PointsView& positions() const { return positions_; }
  [[nodiscard]] const PointsView& velocities() const { return velocities_; }

  // Mover `index`, unchecked.
  [[nodiscard]] Mover operator[](std::size_t index) const {
    const Point v = velocities_[index];
    return {positions_[index], {v.x, v.y, v.z}};
  }

 private:
  struct FromSpan {};
  MoversView(std::span<const Mover> movers, FromSpan) {
    if (movers.empty()) return;
    const Mover& first = movers.front();
    positions_ = PointsView::strided(&first.position.x, &first.position.y, &first.position.z,
                                     movers.size(), sizeof(Mover));
    velocities_ = PointsView::strided(&first.velocity.x, &first.velocity.y, &first.velocity.z,
                                      movers.size(), sizeof(Mover));
  }

  PointsView positions_;
  PointsView velocities_;
  std::span<const double> heights_m_;
  std::span<const double> climbs_mps_;
};

}  // namespace beespace
