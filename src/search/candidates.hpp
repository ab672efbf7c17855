// The points of a wide swarm that may be near another one.
//
// An axis that is more than 2^24 thresholds long is cut wherever nothing lies for a while,
// which means sorting its coordinates and looking each of them up among the cuts. Where few are
// near, as with outliers around a swarm or radii over decades, most points are surely alone: those
// are left out first, by a table of wide cells, again and again with narrower ones as the box of
// the rest shrinks. The rest is a swarm of its own.
#pragma once

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <cstddef>
#include <optional>

namespace beespace::search {

class Candidates {
 public:
  // None where the domain's own points are to be searched: there are two sets, no axis is too long,
  // or too few would be left out (seven in sixteen, so that the copy does not take more memory than
  // that spares). Cost: a few table look-ups a point. Working memory: 36 bytes for
  // each of those that are left, and 8 more a point while it looks for them.
  static std::optional<Candidates> of(const SearchDomain& domain, double threshold_m,
                                      const core::Resources& with, const TuningOverrides& tuning);

  [[nodiscard]] std::size_t size() const { return ids_.size(); }
  // In the domain's numbering; ascending.
  [[nodiscard]] PointId id(std::size_t i) const { return ids_[i]; }
  // The same points, without the others. They must not outlive these.
  [[nodiscard]] SearchDomain domain(const core::Resources& with) const {
    return SearchDomain::of(view(), bounds_, with);
  }

 private:
  explicit Candidates(const core::Bounds& bounds, core::Memory& memory)
      : bounds_(bounds), ids_(&memory) {}

  [[nodiscard]] PointsView view() const;
  bool leave_out(const PointsView& points, double threshold_m, const core::Resources& with);

  core::Bounds bounds_;
  core::Vector<PointId> ids_;
  core::Buffer<Point> points_;
};

}  // namespace beespace::search
