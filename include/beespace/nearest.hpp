// How near is the nearest other bee, and which two are the closest of all?
//
// Distances are compared as real numbers, so no rounding decides who is nearest; exact ties go to
// the lowest id. A reported distance is a double, computed by distance() below and by nothing
// else, so it is the same on every machine.
#pragma once

#include <beespace/export.hpp>
#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace beespace {

// The Euclidean distance in metres: the square root of the sum of three squares, each step rounded
// to the nearest double, so within 4 * 2^-53 of the true one, relatively. For points of the domain.
BEESPACE_API double distance(const Point& a, const Point& b);

struct ClosestPair {
  PointId first = 0;  // first < second; of equally close pairs the lowest first, then second
  PointId second = 0;
  double distance_m = 0.0;

  friend bool operator==(const ClosestPair&, const ClosestPair&) = default;
};

// The two points that are closest to each other; empty when there are fewer than two points.
// `threads` as in SearchOptions. Expected cost: a few tens of nanoseconds a point.
// Errors: kTooManyPoints, kNotFinite, kOutsideDomain as find_at_risk.
BEESPACE_API Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points,
                                                                  unsigned threads = 1);

// The closest pair of one of `points` (first) and one of `others` (second); empty when either set
// is. Expected cost: as find_nearest_between.
BEESPACE_API Result<std::optional<ClosestPair>> find_closest_pair_between(const PointsView& points,
                                                                          const PointsView& others,
                                                                          unsigned threads = 1);

struct Nearest {
  static constexpr PointId kNobody = std::numeric_limits<PointId>::max();

  PointId id = kNobody;  // kNobody where there is nobody
  double distance_m = std::numeric_limits<double>::infinity();

  friend bool operator==(const Nearest&, const Nearest&) = default;
};

// For every point the nearest other point, however far. Entry i belongs to point i; with a single
// point it is nobody. `threads` as in SearchOptions. Cost: one to three hundred nanoseconds a
// point, in crowds too, and more where density differs by many powers of ten; working memory: at
// most 104 bytes a point, the answer included. Errors: as find_closest_pair.
BEESPACE_API Result<std::vector<Nearest>> find_nearest(const PointsView& points,
                                                       unsigned threads = 1);

// The same among those closer than the threshold; nobody where there is none. With a vertical
// threshold: the nearest by the straight line among those in the cylinder (see search_options.hpp).
// Errors: as find_at_risk.
BEESPACE_API Result<std::vector<Nearest>> find_nearest_within(const PointsView& points,
                                                              const SearchOptions& options);

// For every one of `points` the nearest of `others`, in the two ways above.
BEESPACE_API Result<std::vector<Nearest>> find_nearest_between(const PointsView& points,
                                                               const PointsView& others,
                                                               unsigned threads = 1);
BEESPACE_API Result<std::vector<Nearest>> find_nearest_within_between(const PointsView& points,
                                                                      const PointsView& others,
                                                                      const SearchOptions& options);

}  // namespace beespace
