// The searches with a vertical threshold, in one swarm or between two: rows of cells, or trees of
// boxes for crowds and for two swarms. Heights and horizontal distances are compared separately;
// cylinders/cylinder_rows.hpp and cylinders/cylinder_tree.hpp say why no pair can be lost.
#pragma once

#include "base/pair_order.hpp"
#include "base/resources.hpp"
#include "cylinders/cylinder_join.hpp"
#include "cylinders/cylinder_rows.hpp"
#include "search/pair_answer.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::search {

class CylinderSearch {
 public:
  // Options have a vertical threshold, have been checked with all sets (exact/validate.hpp), and
  // must outlive the search, as must `with`. Without `others` the points are compared with each
  // other.
  CylinderSearch(const PointsView& points, const PointsView* others, const PairOptions& options,
                 const core::Resources& with, const TuningOverrides& tuning);

  Status find_at_risk(std::vector<PointId>& at_risk) const;
  Status find_pairs(PairAnswer& answer) const;
  Status find_neighbors(PairAnswer& answer) const;
  Status count_neighbors(std::vector<std::uint32_t>& counts) const;
  // The nearest by the straight line among those in the cylinder.
  Status find_nearest(std::vector<Nearest>& nearest) const;

  // Of one swarm.
  Status find_groups(IdRows& groups) const;
  Result<bool> visit_pairs(const PairVisitor& visit) const;

 private:
  // The trees of the points and of those that they are compared with; nothing if there can be no
  // pair.
  struct Trees {
    core::CylinderTree points;
    std::optional<core::CylinderTree> others;

    [[nodiscard]] const core::CylinderTree& second() const { return others ? *others : points; }
  };
  [[nodiscard]] std::optional<Trees> trees() const;
  // The rows of one swarm, unless it is a crowd.
  [[nodiscard]] std::optional<core::CylinderRows> rows() const;
  [[nodiscard]] bool is_empty() const;
  template <class Near>
  void for_each_near(const core::CylinderRows& rows, const Near& near) const;
  // Compares all pairs, each once, with a task for each worker.
  template <class TaskOf, class Between>
  void join(const Trees& trees, const TaskOf& task_of, const Between& between) const;
  // The pairs of each worker; more than `most`, and not all, where there are more.
  core::Vector<core::FoundPairs> collect(std::uint64_t most) const;

  core::UprightPoints points_;
  std::optional<core::UprightPoints> others_;
  PairOptions options_;
  core::CylinderTests tests_;
  const core::Resources& with_;
  const TuningOverrides& tuning_;
};

}  // namespace beespace::search
