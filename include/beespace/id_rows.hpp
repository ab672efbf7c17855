/// @file
/// @brief Rows of ids of different lengths, one after the other in memory: "compressed sparse rows"
/// (CSR).
#pragma once

#include <beespace/lifetimebound.hpp>
#include <beespace/point.hpp>
#include <beespace/row_iterator.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace beespace {

/// @brief Rows of ids of different lengths.
///
///     offsets   0        3     5        Row r is ids[offsets[r]] ... ids[offsets[r + 1] - 1].
///     ids       4  7  9  2  8
///
/// Ownership: owns its memory.
struct IdRows {
  /// @brief Where each row begins in `ids`, and where the last one ends: one more than there are
  /// rows. Empty when there is no row, as in a default-constructed IdRows: every function that
  /// returns no row returns that.
  std::vector<std::uint64_t> offsets;
  /// @brief The ids of all rows.
  std::vector<PointId> ids;

  /// @brief Says how many rows there are. (`offsets` of a single 0 mean no row, too.)
  /// @return The number of rows.
  [[nodiscard]] std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  /// @brief Says whether there is no row.
  /// @return Whether size() is 0.
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// @brief Gives one row.
  /// @param row The index of the row; unchecked.
  /// @return Its ids, in the memory of this.
  [[nodiscard]] std::span<const PointId> operator[](std::size_t row) const BEESPACE_LIFETIMEBOUND {
    return std::span(ids).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }

  /// @brief Begins a loop over the rows: `for (const auto row : rows)`.
  /// @return An iterator to the first row; it and the rows must not outlive this.
  [[nodiscard]] RowIterator<IdRows> begin() const BEESPACE_LIFETIMEBOUND { return {*this, 0}; }
  /// @brief Ends a loop over the rows.
  /// @return An iterator behind the last row.
  [[nodiscard]] RowIterator<IdRows> end() const BEESPACE_LIFETIMEBOUND { return {*this, size()}; }

  friend bool operator==(const IdRows&, const IdRows&) = default;
};

}  // namespace beespace
