/// @file
/// @brief Pairs and neighbours in columns of 64-bit numbers, in memory that the caller gives.
///
/// For those who hand answers on to where ids are 64 bits wide and each field is an array of its
/// own: NumPy, Arrow, Fortran, a database. Ids and distances are written there while they are in
/// the processor's cache, so that they are not copied a second time, and no memory but the answer's
/// own holds all pairs in their order.
#pragma once

#include <cstdint>
#include <functional>

namespace beespace {

/// @brief Where pairs are to be written.
///
/// Ownership: none; the memory must live until the call has returned, and is the search's own
/// until then.
struct PairColumns {
  std::int64_t* first = nullptr;   ///< The first id of each pair, as Pair::first.
  std::int64_t* second = nullptr;  ///< The second id of each pair, as Pair::second.
  /// @brief The distance of each pair in metres, as beespace::distance says; null where these are
  /// not wanted.
  double* distances_m = nullptr;
};

/// @brief Gives the memory for so many pairs. Is called once, by the thread that called the search,
/// as soon as the number is known; never where there is an error. What it throws is thrown by the
/// search.
using PairRoom = std::function<PairColumns(std::uint64_t size)>;

/// @brief Where rows of neighbours are to be written. Ownership: as PairColumns.
struct RowColumns {
  /// @brief Where each row begins in `ids`, and where the last one ends: one more than there are
  /// rows. (Of no row it is a single 0.)
  std::int64_t* offsets = nullptr;
  std::int64_t* ids = nullptr;  ///< The ids of all rows.
  /// @brief The distance in metres of each id from the point of its row; null where these are not
  /// wanted.
  double* distances_m = nullptr;
};

/// @brief Gives the memory for so many rows, one for each point, of so many ids in all. Is called
/// as PairRoom.
using RowRoom = std::function<RowColumns(std::uint64_t rows, std::uint64_t size)>;

}  // namespace beespace
