// Who is around any place, and who is nearest to it: an index that is built once and asked often.
//
// An Index holds points by id and answers about any place in space, not only about its own points.
// Distances are compared as real numbers, as in at_risk.hpp and nearest.hpp: the answers are exact,
// and the same whatever was inserted, moved and removed before, in whatever order.
//
// Ownership: the coordinates are copied. Memory: about 50 bytes a point, also while it is built.
// Thread-safe as containers are: any number of threads may ask at the same time; whoever changes
// the points must be alone.
#pragma once

#include <beespace/export.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/nearest.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace beespace {

// Rows of equal length: row r belongs to place r, and begins with its nearest.
struct NearestRows {
  std::size_t length = 0;  // of each row: k, or the number of points where that is less
  std::vector<Nearest> entries;

  [[nodiscard]] std::size_t size() const { return length == 0 ? 0 : entries.size() / length; }
  [[nodiscard]] std::span<const Nearest> operator[](std::size_t row) const {
    return std::span(entries).subspan(row * length, length);
  }

  friend bool operator==(const NearestRows&, const NearestRows&) = default;
};

class BEESPACE_API Index {
 public:
  // Empty.
  Index();
  // Holds the points under the ids 0, 1, 2, ... `threads` as in SearchOptions; more of them make
  // it faster, not different. Cost: some 80 nanoseconds a point, whatever their positions.
  // Errors: kTooManyPoints, kNotFinite, kOutsideDomain as find_at_risk.
  static Result<Index> build(const PointsView& points, unsigned threads = 1);

  Index(const Index&) = delete;
  Index& operator=(const Index&) = delete;
  Index(Index&&) noexcept;
  Index& operator=(Index&&) noexcept;
  ~Index();

  // How many points there are now.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool contains(PointId id) const;
  // Errors: kInvalidArgument where there is no such point.
  [[nodiscard]] Result<Point> point(PointId id) const;

  // The ids of all points closer to the place than the radius, ascending; with `inclusive`, also of
  // those exactly as far. A radius of 0 finds nobody, or, inclusive, those at the very place.
  // Cost: some hundred nanoseconds, and a few for each point found.
  // Errors: kInvalidThreshold for a radius that is negative or not of the coordinate domain;
  // kNotFinite and kOutsideDomain for the place.
  [[nodiscard]] Result<std::vector<PointId>> find_around(const Point& place, double radius_m,
                                                         bool inclusive = false) const;
  // The same into the caller's vector, which is overwritten; allocates nothing when its capacity is
  // twice what is found, and 64 more.
  Status find_around(const Point& place, double radius_m, bool inclusive,
                     std::vector<PointId>& found) const;

  // Row r holds the ids around places[r], with options.threshold_m as the radius. Places in any
  // order are looked up in an order that suits the memory.
  // Errors: the same, with the place in place.record; kTooManyResults when the rows together hold
  // more than options.max_results.
  [[nodiscard]] Result<IdRows> find_around(const PointsView& places,
                                           const SearchOptions& options) const;

  // The `k` points nearest to the place, or all if there are fewer, in the order of their
  // distances; equally near ones in the order of their ids. Cost: some hundred nanoseconds, and
  // about a hundred a point. Errors: kNotFinite and kOutsideDomain for the place.
  [[nodiscard]] Result<std::vector<Nearest>> k_nearest(const Point& place, std::size_t k) const;
  // The same into the caller's vector, which is overwritten.
  Status k_nearest(const Point& place, std::size_t k, std::vector<Nearest>& nearest) const;

  // Row r holds the nearest to places[r]. Errors: the same, with the place in place.record.
  [[nodiscard]] Result<NearestRows> k_nearest(const PointsView& places, std::size_t k,
                                              unsigned threads = 1) const;

  // Changes. New and moved points are kept beside the large tree: up to 64 in a list, the others in
  // trees that are each at most an eighth of the next larger one, and merged when they grow beyond
  // that. Removed points leave gaps; when half of all places are gaps, everything is built anew. So
  // a change costs one to two microseconds on average, a single one up to a rebuild, and answers
  // take somewhat longer than after rebuild(), which is never needed otherwise.

  // Adds a point, under the next id that was never used. Errors: kNotFinite and kOutsideDomain;
  // kTooManyPoints when the ids are used up.
  Result<PointId> insert(const Point& point);
  // Errors: kInvalidArgument where there is no such point; kNotFinite, kOutsideDomain.
  Status move(PointId id, const Point& point);
  // Errors: kInvalidArgument where there is no such point.
  Status remove(PointId id);

  // Builds one tree of all points, for answers as fast as those after build(). Ids stay.
  void rebuild(unsigned threads = 1);

 private:
  class Levels;
  explicit Index(std::unique_ptr<Levels> levels);

  std::unique_ptr<Levels> levels_;
};

}  // namespace beespace
