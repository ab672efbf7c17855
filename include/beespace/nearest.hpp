/// @file
/// @brief How near is the nearest other point, and which two points are closest of all?
///
/// Distances are compared as real numbers, so no rounding decides which point is nearest; exact
/// ties go to the lowest id. A reported distance is a double, computed by beespace::distance and by
/// nothing else, so it is the same on every machine.
#pragma once

#include <beespace/export.hpp>
#include <beespace/lifetimebound.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/row_iterator.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace beespace {

/// @brief The Euclidean distance of two points.
///
/// It is the square root of the sum of three squares, each step rounded to the nearest double, so
/// within 4 * 2^-53 of the true distance, relatively. For points of the coordinate domain.
///
/// @param a One point, in metres.
/// @param b The other point, in metres.
/// @return Their distance in metres.
BEESPACE_API double distance(const Point& a, const Point& b);

/// @brief The two points that are closest to each other.
struct ClosestPair {
  PointId first = 0;   ///< Below `second`; of equally close pairs the lowest first, then second.
  PointId second = 0;  ///< The other point.
  double distance_m = 0.0;  ///< Their distance in metres, as beespace::distance says.

  friend bool operator==(const ClosestPair&, const ClosestPair&) = default;
};

/// @brief Finds the two points that are closest to each other.
///
/// Complexity: a few tens of nanoseconds a point, expected. Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param run How many threads may work, and what ends the call early.
/// @return The closest pair, absent when there are fewer than two points; or an error as
///   find_at_risk, but for those of the threshold.
BEESPACE_API Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points,
                                                                  const RunOptions& run = {});

/// @brief Finds the closest pair of a point of one set and a point of another.
///
/// Complexity: as find_nearest_between, expected. Thread safety: no state is kept.
///
/// @param points The positions in metres of ClosestPair::first.
/// @param others The positions in metres of ClosestPair::second.
/// @param run How many threads may work, and what ends the call early.
/// @return The closest pair, absent when either set is empty; or an error as find_closest_pair.
BEESPACE_API Result<std::optional<ClosestPair>> find_closest_pair_between(
    const PointsView& points, const PointsView& others, const RunOptions& run = {});

/// @brief The nearest point of a point.
struct Nearest {
  /// @brief The id that stands for no point.
  static constexpr PointId kNone = std::numeric_limits<PointId>::max();

  /// @brief The nearest point; #kNone where there is none.
  PointId id = kNone;
  /// @brief Its distance in metres, as beespace::distance says; infinite where there is none.
  double distance_m = std::numeric_limits<double>::infinity();

  friend bool operator==(const Nearest&, const Nearest&) = default;
};

/// @brief Rows of equal length: row r belongs to query r, and begins with the nearest point.
///
/// Ownership: owns its memory.
struct NearestRows {
  /// @brief The length of each row: k, or the number of points where that is less; 0 when there is
  /// no row, as in a default-constructed NearestRows. Rows of length 0 count as no rows.
  std::size_t length = 0;
  /// @brief The entries of all rows, one row after the other.
  std::vector<Nearest> entries;

  /// @brief Says how many rows there are.
  /// @return The number of rows; 0 where rows have a length of 0.
  [[nodiscard]] std::size_t size() const { return length == 0 ? 0 : entries.size() / length; }
  /// @brief Says whether there is no row.
  /// @return Whether size() is 0.
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// @brief Gives one row.
  /// @param row The index of the row; unchecked.
  /// @return Its entries, in the memory of this.
  [[nodiscard]] std::span<const Nearest> operator[](std::size_t row) const BEESPACE_LIFETIMEBOUND {
    return std::span(entries).subspan(row * length, length);
  }

  /// @brief Begins a loop over the rows: `for (const auto row : rows)`.
  /// @return An iterator to the first row; it and the rows must not outlive this.
  [[nodiscard]] RowIterator<NearestRows> begin() const BEESPACE_LIFETIMEBOUND { return {*this, 0}; }
  /// @brief Ends a loop over the rows.
  /// @return An iterator behind the last row.
  [[nodiscard]] RowIterator<NearestRows> end() const BEESPACE_LIFETIMEBOUND {
    return {*this, size()};
  }

  friend bool operator==(const NearestRows&, const NearestRows&) = default;
};

/// @brief Finds for each point the nearest other point, however far.
///
/// Complexity: one to three hundred nanoseconds a point, in crowds too, and more where density
/// differs by many powers of ten. Working memory: at most 104 bytes a point, the answer included.
/// Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param run How many threads may work, and what ends the call early.
/// @return Entry i belongs to point i; of a single point it is empty (Nearest::kNone). Or an
///   error as find_closest_pair.
BEESPACE_API Result<std::vector<Nearest>> find_nearest(const PointsView& points,
                                                       const RunOptions& run = {});

/// @brief Finds for each point the `k` nearest other points, however far.
///
/// A point is not its own neighbour; of points at one position each has the others. Complexity:
/// some hundred nanoseconds a point, and some tens a neighbour. Working memory: 46 bytes a
/// point, beyond the answer of 16 bytes a neighbour. Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param k How many neighbours to find for each point.
/// @param run How many threads may work, and what ends the call early.
/// @return Row i holds the neighbours of point i, in the order of their distances; equally near
///   ones in the order of their ids. Rows have `k` entries, or one fewer than there are points
///   where that is less; there are no rows where `k` is 0 or there are fewer than two points. Or an
///   error as find_closest_pair.
BEESPACE_API Result<NearestRows> find_k_nearest(const PointsView& points, std::size_t k,
                                                const RunOptions& run = {});

/// @brief Finds for each point the nearest of those that are closer than the threshold.
///
/// With a vertical threshold it is the nearest by the straight line among those in the cylinder
/// (see SearchOptions::vertical_m). Thread safety: no state is kept.
///
/// @param points The positions in metres; read in place, not kept.
/// @param options The threshold and how to search.
/// @return Entry i belongs to point i; Nearest::kNone where there is none. Or an error as
///   find_at_risk.
BEESPACE_API Result<std::vector<Nearest>> find_nearest_within(const PointsView& points,
                                                              const SearchOptions& options);

/// @brief Finds for each point of one set the nearest point of another, however far.
/// @param points The positions in metres, each of which has an entry.
/// @param others The positions in metres of the other set.
/// @param run How many threads may work, and what ends the call early.
/// @return Entry i belongs to point i of `points` and names a point of `others`; or an error as
///   find_nearest.
BEESPACE_API Result<std::vector<Nearest>> find_nearest_between(const PointsView& points,
                                                               const PointsView& others,
                                                               const RunOptions& run = {});
/// @brief Finds for each point of one set the nearest of those points of another that are closer
/// than the threshold.
/// @param points The positions in metres, each of which has an entry.
/// @param others The positions in metres of the other set.
/// @param options The threshold and how to search.
/// @return Entry i belongs to point i of `points` and names a point of `others`; or an error as
///   find_nearest_within.
BEESPACE_API Result<std::vector<Nearest>> find_nearest_within_between(const PointsView& points,
                                                                      const PointsView& others,
                                                                      const SearchOptions& options);

}  // namespace beespace
