/// @file
/// @brief Which points are around any position, and which are nearest to it? An index that is built
/// once and asked often.
///
/// An Index holds points by id and answers about any position in space, not only about its own
/// points. Distances are compared as real numbers, as in at_risk.hpp and nearest.hpp: the answers
/// are exact, and the same whatever was inserted, moved and removed before, in whatever order.
#pragma once

#include <beespace/crew.hpp>
#include <beespace/export.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/lifetimebound.hpp>
#include <beespace/nearest.hpp>
#include <beespace/not_given.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace beespace {

/// @brief What Index::find_around needs to know of many positions. Plain values; nothing is
/// referred to.
struct AroundOptions {
  /// @brief The radius in metres: zero or more, inside the coordinate domain (see Point). Must be
  /// given where there is not one for each position: there is no default.
  double radius_m = kNotGiven;

  /// @brief Whether points exactly as far as the radius are found, too.
  bool inclusive = false;

  /// @brief How many threads may work, the calling one included; 0 means one per processor. The
  /// answer is the same for every number.
  unsigned threads = 1;

  /// @brief More ids than this, in all rows, are an error: ErrorCode::kTooManyResults.
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();

  /// @brief When a stop is requested, the call ends soon, with ErrorCode::kStopped and no answer.
  std::stop_token stop = {};
};

/// @brief Points by id, for queries at any position; points can be inserted, moved and removed.
///
/// Ownership: the coordinates are copied. Memory: about 50 bytes a point, also while it is built.
///
/// Thread safety: that of the standard containers. Any number of threads may call const functions
/// at the same time; a thread that changes the points must be alone.
///
/// Complexity of changes: new and moved points are kept beside the large tree: up to 64 in a list,
/// the others in trees, each at most an eighth as large as the next, which are merged when they
/// grow beyond that. Removed points leave gaps; when half of all slots are gaps, everything is
/// built anew. So a change costs one to two microseconds on average, a single one up to a rebuild,
/// and answers take somewhat longer than after rebuild(), which is never needed otherwise.
///
/// A moved-from Index can only be destroyed or assigned to.
class BEESPACE_API Index {
 public:
  /// @brief Holds no points.
  Index();
  /// @brief Builds an index of points, under the ids 0, 1, 2, ...
  ///
  /// Complexity: some 80 nanoseconds a point, whatever their positions.
  ///
  /// @param points The positions in metres; copied.
  /// @param run How many threads may work (the result is the same for every number), and what ends
  ///   the call early.
  /// @return The index; or an error as find_at_risk, but for those of the threshold;
  ///   ErrorCode::kInvalidArgument for points with heights kept apart.
  static Result<Index> build(const PointsView& points, const RunOptions& run = {});
  /// @brief The same with the threads of `crew`, all of which work on this call, on each query of
  /// many places and on rebuild(): numbers of threads are ignored. If several threads query the
  /// Index at once, Crew::run is called by several threads at once, which a ThreadCrew allows.
  /// @param points The positions in metres; copied.
  /// @param crew The threads; must outlive the Index.
  /// @param stop What ends the call early.
  /// @return The index, or the same errors.
  static Result<Index> build(const PointsView& points, Crew& crew BEESPACE_LIFETIMEBOUND,
                             const std::stop_token& stop = {});

  Index(const Index&) = delete;
  Index& operator=(const Index&) = delete;
  /// @brief Takes over the points.
  Index(Index&&) noexcept;
  /// @brief Takes over the points.
  /// @return This.
  Index& operator=(Index&&) noexcept;
  /// @brief Frees its memory.
  ~Index();

  /// @brief Says how many points there are now.
  /// @return The number of points.
  [[nodiscard]] std::size_t size() const;
  /// @brief Says whether there is a point of this id now.
  /// @param id The id.
  /// @return Whether there is one.
  [[nodiscard]] bool contains(PointId id) const;
  /// @brief Gives the position of a point.
  /// @param id The id of the point.
  /// @return Its position in metres; or ErrorCode::kInvalidArgument where there is no such point.
  [[nodiscard]] Result<Point> point(PointId id) const;

  /// @brief Finds the points around one position.
  ///
  /// Complexity: some hundred nanoseconds, and a few for each point found.
  ///
  /// @param place The position, in metres.
  /// @param radius_m The radius in metres. A radius of 0 finds no point or, if inclusive, those at
  ///   the very position.
  /// @param inclusive Whether points exactly as far as the radius are found, too.
  /// @return The ids of all points closer than the radius, ascending; or an error:
  ///   - ErrorCode::kInvalidThreshold: a radius that is negative or not of the coordinate domain;
  ///   - ErrorCode::kNotFinite, ErrorCode::kOutsideDomain: a position that is not of the coordinate
  ///     domain.
  [[nodiscard]] Result<std::vector<PointId>> find_around(const Point& place, double radius_m,
                                                         bool inclusive = false) const;
  /// @brief The same into the caller's vector.
  ///
  /// Allocates nothing when the vector's capacity is twice what is found, and 64 more.
  ///
  /// @param place The position, in metres.
  /// @param radius_m The radius in metres.
  /// @param inclusive Whether points exactly as far as the radius are found, too.
  /// @param[out] found The ids, ascending; overwritten.
  /// @return Success, or the same errors.
  Status find_around(const Point& place, double radius_m, bool inclusive,
                     std::vector<PointId>& found) const;

  /// @brief Finds the points around each of many positions. Positions in any order are looked up in
  /// an order that suits the memory.
  /// @param places The positions in metres; read in place.
  /// @param options The radius (AroundOptions::radius_m) and how to search.
  /// @return Row r holds the ids around places[r], ascending; or the same errors, with the position
  ///   in ErrorLocation::record; ErrorCode::kTooManyResults when the rows together hold more than
  ///   AroundOptions::max_results; ErrorCode::kStopped when a stop was requested.
  [[nodiscard]] Result<IdRows> find_around(const PointsView& places,
                                           const AroundOptions& options) const;
  /// @brief The same with a radius for each position.
  /// @param places The positions in metres; read in place.
  /// @param radii_m A radius in metres for each position: zero or more.
  /// @param options How to search. AroundOptions::radius_m must not be given.
  /// @return As above; ErrorCode::kInvalidArgument when there are more or fewer radii than
  /// positions
  ///   or when there is one for all, too. ErrorLocation::record of a radius is its index in
  ///   "radii".
  [[nodiscard]] Result<IdRows> find_around(const PointsView& places,
                                           std::span<const double> radii_m,
                                           const AroundOptions& options = {}) const;

  /// @brief Finds the `k` nearest points of one position.
  ///
  /// Complexity: some hundred nanoseconds, and about a hundred a point.
  ///
  /// @param place The position, in metres.
  /// @param k How many points to find.
  /// @return The `k` points nearest to the position, or all if there are fewer, in the order of
  ///   their distances; equally near ones in the order of their ids. Or ErrorCode::kNotFinite,
  ///   ErrorCode::kOutsideDomain for the position.
  [[nodiscard]] Result<std::vector<Nearest>> k_nearest(const Point& place, std::size_t k) const;
  /// @brief The same into the caller's vector.
  /// @param place The position, in metres.
  /// @param k How many points to find.
  /// @param[out] nearest The nearest points; overwritten.
  /// @return Success, or the same errors.
  Status k_nearest(const Point& place, std::size_t k, std::vector<Nearest>& nearest) const;

  /// @brief Finds the `k` nearest points of a point of the index, without itself.
  /// @param id The id of the point.
  /// @param k How many points to find.
  /// @return The `k` other points nearest to it, or all if there are fewer, in the order of their
  ///   distances; equally near ones, such as others at its position, in the order of their ids. Or
  ///   ErrorCode::kInvalidArgument where there is no such point.
  [[nodiscard]] Result<std::vector<Nearest>> k_nearest_of(PointId id, std::size_t k) const;
  /// @brief The same into the caller's vector.
  /// @param id The id of the point.
  /// @param k How many points to find.
  /// @param[out] nearest The nearest points; overwritten.
  /// @return Success, or the same error.
  Status k_nearest_of(PointId id, std::size_t k, std::vector<Nearest>& nearest) const;

  /// @brief Finds the `k` nearest points of each of many positions.
  /// @param places The positions in metres; read in place.
  /// @param k How many points to find for each.
  /// @param run How many threads may work, and what ends the call early.
  /// @return Row r holds the nearest points of places[r]; no rows where `k` is 0 or there are no
  ///   points in the index; or the same errors, with the position in ErrorLocation::record;
  ///   ErrorCode::kStopped when a stop was requested.
  [[nodiscard]] Result<NearestRows> k_nearest(const PointsView& places, std::size_t k,
                                              const RunOptions& run = {}) const;

  /// @brief Adds a point, under the next id that was never used.
  /// @param point The position, in metres.
  /// @return The id; or ErrorCode::kNotFinite, ErrorCode::kOutsideDomain for the position, or
  ///   ErrorCode::kTooManyPoints when the ids are used up.
  Result<PointId> insert(const Point& point);
  /// @brief Moves a point.
  /// @param id The id of the point.
  /// @param point Its new position, in metres.
  /// @return Success; or ErrorCode::kInvalidArgument where there is no such point,
  ///   ErrorCode::kNotFinite, ErrorCode::kOutsideDomain for the position.
  Status move(PointId id, const Point& point);
  /// @brief Removes a point.
  /// @param id The id of the point; it is not used again.
  /// @return Success; or ErrorCode::kInvalidArgument where there is no such point.
  Status remove(PointId id);

  /// @brief Builds one tree of all points, for answers as fast as those after build(). Ids stay.
  /// @param threads As SearchOptions::threads.
  void rebuild(unsigned threads = 1);

 private:
  class Levels;
  explicit Index(std::unique_ptr<Levels> levels);

  std::unique_ptr<Levels> levels_;
};

}  // namespace beespace
