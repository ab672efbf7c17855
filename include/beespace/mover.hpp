/// @file
/// @brief An agent that moves: where it is now, and its velocity.
///
/// Units: metres and metres per second, in one Cartesian frame whose third axis is the height where
/// the height matters. Plain values; a view owns nothing, as in points_view.hpp.
///
/// All values of motion lie in the *motion domain*: positions, velocities, times and thresholds are
/// zero or of a magnitude between #beespace::kSmallestInMotion and #beespace::kLargestInMotion.
/// Inside it no exact product of four of them overflows or underflows.
///
/// Positions, velocities, heights and times that are smaller are taken as zero wherever they enter:
/// predictions, recordings, live swarms and advice. That moves an agent by less than
/// 2^-99 m, and by as much more for each second that it flies on; the distance of two, over T
/// seconds, by less than (1 + T) 2^-98 m, which is 3.2e-21 m after 10^9 s. So an answer can differ
/// only for pairs that come within so much of the threshold. Values that are too large are refused,
/// and so are thresholds that are too small.
#pragma once

#include <beespace/lifetimebound.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <concepts>
#include <cstddef>
#include <span>

namespace beespace {

/// @brief The smallest magnitude above zero of the motion domain, about 7.9e-31.
inline constexpr double kSmallestInMotion = 0x1p-100;
/// @brief The largest magnitude of the motion domain, about 1.3e+30.
inline constexpr double kLargestInMotion = 0x1p+100;

/// @brief A velocity in metres per second, along the axes of the positions.
struct Velocity {
  double x = 0.0;  ///< Along the first axis, in metres per second.
  double y = 0.0;  ///< Along the second axis, in metres per second.
  double z = 0.0;  ///< Along the third axis, in metres per second.

  friend constexpr bool operator==(const Velocity&, const Velocity&) = default;
};

/// @brief An agent: its position and its velocity.
struct Mover {
  Point position;     ///< Where it is, in metres.
  Velocity velocity;  ///< How it moves, in metres per second.

  friend constexpr bool operator==(const Mover&, const Mover&) = default;
};

namespace detail {
template <class T>
concept SpanOfMovers = std::convertible_to<const T&, std::span<const Mover>>;
}  // namespace detail

/// @brief A view of agents in the caller's memory: positions, and as many velocities, whatever
/// their layout.
///
/// Ownership: none; the memory must outlive the view, and must not change while a search reads it.
/// Cheap to copy.
class MoversView {
 public:
  /// @brief A view of no agents.
  constexpr MoversView() = default;

  /// @brief A view of agents one after the other: std::vector<Mover>, std::array<Mover, N>,
  /// std::span<const Mover>.
  /// @param movers The agents; must outlive the view.
  template <detail::SpanOfMovers Movers>
  MoversView(const Movers& movers)  // NOLINT(google-explicit-constructor): a view
      : MoversView(std::span<const Mover>(movers), FromSpan{}) {}

  /// @brief The same of a container, for which a compiler may warn where the view outlives it.
  /// @param movers The agents; must outlive the view.
  template <detail::SpanOfMovers Movers>
  requires detail::Container<Movers> MoversView(  // NOLINT(google-explicit-constructor): a view
      const Movers& movers BEESPACE_LIFETIMEBOUND)
      : MoversView(std::span<const Mover>(movers), FromSpan{}) {}

  /// @brief A view of positions and velocities.
  ///
  /// If there are more of the one than of the other, they do not fit together, which is an error,
  /// ErrorCode::kInvalidArgument, of every function that the view is given to; so are arrays of
  /// other lengths in the constructor below.
  ///
  /// @param positions The positions, in metres.
  /// @param velocities One vector for each of `positions`, in metres per second.
  MoversView(const PointsView& positions, const PointsView& velocities)
      : positions_(positions), velocities_(velocities) {}

  /// @brief A view of positions and velocities, with heights and climb rates that are kept apart
  /// from them: for a vertical threshold between agents whose third axis is not the height.
  ///
  /// Positions and velocities are then horizontal: of geographic positions, those brought to height
  /// 0 (see to_ecef).
  ///
  /// @param positions The horizontal positions, in metres.
  /// @param velocities The horizontal velocities, in metres per second.
  /// @param heights_m One height for each agent, in metres or in the options' `height_unit_m`; or
  ///   empty, if `climbs_mps` is empty, too.
  /// @param climbs_mps One climb rate for each agent, in the unit of heights per second; or empty.
  MoversView(const PointsView& positions, const PointsView& velocities,
             std::span<const double> heights_m, std::span<const double> climbs_mps)
      : positions_(positions),
        velocities_(velocities),
        heights_m_(heights_m),
        climbs_mps_(climbs_mps) {}

  /// @brief Says whether all arrays are of one length.
  /// @return Whether they fit together.
  [[nodiscard]] bool fits() const {
    const std::size_t heights = has_heights() ? size() : 0;
    return positions_.fits() && velocities_.fits() && positions_.size() == velocities_.size() &&
           heights_m_.size() == heights && climbs_mps_.size() == heights &&
           !positions_.has_heights() && !velocities_.has_heights();
  }

  /// @brief Says whether heights are kept apart from positions.
  /// @return Whether heights or climb rates were given.
  [[nodiscard]] bool has_heights() const { return !heights_m_.empty() || !climbs_mps_.empty(); }
  /// @brief Gives the heights that are kept apart.
  /// @return One for each agent, or none.
  [[nodiscard]] std::span<const double> heights_m() const { return heights_m_; }
  /// @brief Gives the climb rates that are kept apart.
  /// @return One for each agent, or none.
  [[nodiscard]] std::span<const double> climbs_mps() const { return climbs_mps_; }

  /// @brief Says how many agents there are.
  /// @return The number of agents; where the arrays do not fit, the smaller number.
  [[nodiscard]] std::size_t size() const {
    return positions_.size() < velocities_.size() ? positions_.size() : velocities_.size();
  }
  /// @brief Says whether there are no agents.
  /// @return Whether size() is 0.
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// @brief Gives the positions.
  /// @return A view of them, in metres.
  [[nodiscard]] const PointsView& positions() const BEESPACE_LIFETIMEBOUND { return positions_; }
  /// @brief Gives the velocities.
  /// @return A view of them, in metres per second.
  [[nodiscard]] const PointsView& velocities() const BEESPACE_LIFETIMEBOUND { return velocities_; }

  /// @brief Reads one agent.
  /// @param index The index of the agent; unchecked.
  /// @return A copy of it.
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
