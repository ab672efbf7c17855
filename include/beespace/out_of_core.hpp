/// @file
/// @brief The searches of beespace for more points than fit into memory.
///
/// Space is cut into cells with at most so many points each. A cell is searched together with its
/// *halo*, the points of other cells that are closer than the threshold to it, so each answer is
/// that of a search in memory, bit for bit. A point belongs to one cell, its home; a pair to the
/// home of its lower id: nothing is found twice.
///
/// Points wait in a temporary file that has no name, so that nothing is left of it when the program
/// ends, however it ends. What is read back is compared with a checksum.
#pragma once

#include <beespace/export.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

namespace beespace {

/// @brief The id of one of many points: its index among all that were added, from 0.
using LargeId = std::uint64_t;

/// @brief Two of many points.
struct LargePair {
  LargeId first = 0;   ///< Below `second`.
  LargeId second = 0;  ///< The other point.

  friend constexpr auto operator<=>(const LargePair&, const LargePair&) = default;  // NOLINT
};

/// @brief How far a search out of core has got.
struct OutOfCoreProgress {
  /// @brief What is going on.
  enum class Phase : std::uint8_t {
    kDistributing,  ///< Points are written to the cells in whose search they take part.
    kSearching,     ///< One cell after the other is searched.
  };
  Phase phase = Phase::kDistributing;  ///< What is going on.
  std::uint64_t done = 0;  ///< Points that were distributed, or whose cell was searched.
  std::uint64_t of = 0;    ///< How many there are.
};

/// @brief What a search out of core needs to know. Plain values; nothing is referred to.
struct OutOfCoreOptions {
  /// @brief The least memory of a search, for each of its threads.
  static constexpr std::uint64_t kLeastMemoryBytes = std::uint64_t{16} << 20U;

  /// @brief How much memory it may use, in bytes: #kLeastMemoryBytes a thread, or more. Must be
  /// given: there is no default. Points that are searched where they are (OutOfCore::refer) do not
  /// count.
  std::uint64_t memory_bytes = 0;
  /// @brief The folder of the temporary file; it must have room for some 30 bytes a point, and for
  /// another 24 bytes of each that was added by OutOfCore::add; of points with heights apart from
  /// their positions for 8 more, each time. Must be given.
  std::string folder = {};
  /// @brief How many threads may work, the calling one included; 0 means one per processor. The
  /// answer is the same for every number.
  unsigned threads = 1;
  /// @brief When a stop is requested, a call ends soon, with ErrorCode::kStopped.
  std::stop_token stop = {};
  /// @brief Called some times a second on the calling thread while a search goes on; or empty. Must
  /// not throw.
  std::function<void(const OutOfCoreProgress&)> progress = {};
};

/// @brief Sees ids in ascending order, those of one cell a call. Must not throw.
using LargeIdVisitor = std::function<void(std::span<const LargeId>)>;
/// @brief Sees pairs, each once, in no particular order, and the distance of each in metres, as
/// beespace::distance says (of points with heights apart from their positions the straight line, as
/// PointsView::with_heights says); called by one thread at a time, not always the same. Must not
/// throw.
using LargePairVisitor = std::function<void(std::span<const LargePair>, std::span<const double>)>;
/// @brief Sees ids of one cell in ascending order, and how many neighbours each of them has. Must
/// not throw.
using LargeCountVisitor =
    std::function<void(std::span<const LargeId>, std::span<const std::uint64_t>)>;

/// @brief The two of many points that are closest to each other, as ClosestPair.
struct LargeClosestPair {
  LargePair pair;           ///< Of equally close pairs the lowest first, then second.
  double distance_m = 0.0;  ///< Their distance in metres, as beespace::distance says.

  friend constexpr bool operator==(const LargeClosestPair&, const LargeClosestPair&) = default;
};

/// @brief One of the nearest points of a point.
struct LargeNearest {
  LargeId id = 0;           ///< The other point.
  double distance_m = 0.0;  ///< Its distance in metres, as beespace::distance says.

  friend constexpr bool operator==(const LargeNearest&, const LargeNearest&) = default;
};
/// @brief Sees ids, and a row of neighbours for each of them, one row behind the other, all of one
/// length. Must not throw.
using LargeNearestVisitor =
    std::function<void(std::span<const LargeId>, std::span<const LargeNearest>)>;

/// @brief How a search out of core was cut.
struct OutOfCoreFacts {
  std::uint64_t cells = 0;   ///< Cells with points.
  std::uint64_t copies = 0;  ///< Points in halos: how many more were written than there are.
  /// @brief Cells that are too full for the memory, as they cannot be cut where the threshold is
  /// large beside them: searched in pieces, each with each, which takes longer.
  std::uint64_t crowded_cells = 0;
  std::uint64_t largest_cell = 0;  ///< The points of the fullest cell, its halo included.
};

/// @brief Points beyond memory, and searches among them.
///
/// Ownership: owns its memory and its temporary files. Thread safety: none. A moved-from OutOfCore
/// can only be destroyed or assigned to.
class BEESPACE_API OutOfCore {
 public:
  /// @brief No points.
  /// @param options The memory, the folder, the threads. If they make no sense, each call returns
  ///   the error.
  explicit OutOfCore(const OutOfCoreOptions& options);
  OutOfCore(const OutOfCore&) = delete;
  OutOfCore& operator=(const OutOfCore&) = delete;
  /// @brief Takes over the points.
  OutOfCore(OutOfCore&&) noexcept;
  /// @brief Takes over the points.
  /// @return This.
  OutOfCore& operator=(OutOfCore&&) noexcept;
  /// @brief Gives the disk back.
  ~OutOfCore();

  /// @brief Adds points, which are copied to the disk. Ids go on from those before.
  /// @param points The positions in metres, all with heights apart from their positions
  ///   (PointsView::with_heights), or none.
  /// @return Success, or an error, in which case none was added:
  ///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a coordinate or a height, with its place
  ///     among `points` in ErrorLocation::record;
  ///   - ErrorCode::kWriteFailed: the disk is full, or the folder cannot be written;
  ///   - ErrorCode::kInvalidArgument: the options; arrays that do not fit together; heights where
  ///     points before have none, or none where these have.
  Status add(const PointsView& points);
  /// @brief Adds points that stay where they are: in a mapped file, say.
  /// @param points As of add(); they and their heights must outlive this, and not change.
  /// @return As add(); coordinates and heights are checked by the searches, which name the id.
  Status refer(const PointsView& points);
  /// @brief How many points there are.
  /// @return The number.
  [[nodiscard]] std::uint64_t size() const;

  /// @brief Says with how many threads the calls that follow work, and what ends them: instead of
  /// what the options said. A stop that was requested ends all later calls, too, until another one
  /// is given.
  /// @param run The threads and the stop.
  void set_run(const RunOptions& run);

  /// @brief Finds the points that are closer than the threshold to any other point, as
  /// beespace::find_at_risk.
  /// @param options The threshold and how to compare; `threads` and `stop` are those of this.
  /// @param visit Sees the ids.
  /// @return Success, or an error, in which case `visit` may have seen some:
  ///   - those of beespace::find_at_risk; of a coordinate or height that is none, with the id in
  ///     ErrorLocation::record;
  ///   - ErrorCode::kWriteFailed, ErrorCode::kReadFailed: of the temporary file;
  ///   - ErrorCode::kCorrupt: it does not hold what was written;
  ///   - ErrorCode::kInvalidArgument: less memory than the threads need.
  Status find_at_risk(const SearchOptions& options, const LargeIdVisitor& visit);
  /// @brief Finds all pairs of points closer than the threshold, as beespace::visit_pairs.
  /// @param options As of find_at_risk().
  /// @param visit Sees the pairs.
  /// @return As find_at_risk().
  Status visit_pairs(const SearchOptions& options, const LargePairVisitor& visit);
  /// @brief Counts the neighbours of each point, as beespace::count_neighbors.
  /// @param options As of find_at_risk().
  /// @param visit Sees the counts.
  /// @return As find_at_risk().
  Status count_neighbors(const SearchOptions& options, const LargeCountVisitor& visit);

  /// @brief Finds the two points that are closest to each other, as beespace::find_closest_pair.
  /// @return The closest pair, absent when there are fewer than two points; or an error as
  ///   find_at_risk(), but for those of the threshold; ErrorCode::kInvalidArgument of points with
  ///   heights apart from their positions.
  Result<std::optional<LargeClosestPair>> find_closest_pair();

  /// @brief Finds for each point the `k` nearest other points, however far, as
  /// beespace::find_k_nearest.
  ///
  /// Points whose neighbours are much farther than those of most points are looked for in all cells
  /// that may have them, in a second round.
  ///
  /// @param k How many neighbours to find for each point.
  /// @param visit Sees the rows, which have `k` entries, or one fewer than there are points where
  ///   that is less. It is not called where `k` is 0 or there are fewer than two points.
  /// @return As find_closest_pair().
  Status find_k_nearest(std::size_t k, const LargeNearestVisitor& visit);

  /// @brief Says how the last search was cut.
  /// @return The facts.
  [[nodiscard]] OutOfCoreFacts facts() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace beespace
