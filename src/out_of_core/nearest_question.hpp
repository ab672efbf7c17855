// The nearest points, beyond memory.
#pragma once

#include "out_of_core/cell_walk.hpp"
#include "out_of_core/cut.hpp"

#include <beespace/engine.hpp>
#include <beespace/index.hpp>
#include <beespace/nearest.hpp>
#include <beespace/out_of_core.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <vector>

namespace beespace::out_of_core {

// A point's nearest ones are settled when they are within the reach of halos. The others wait, and
// are compared with all cells that may have nearer ones.
class NearestQuestion final : public CellQuestion {
 public:
  struct Setting {
    const RunOptions& run;
    std::size_t length;        // of each row: less than there are points
    double reach;              // of halos
    std::size_t most_points;   // of a cell that is read at a time
    std::size_t most_waiting;  // points
  };

  // All must outlive this.
  NearestQuestion(Engine& engine, const Setting& setting, const LargeNearestVisitor& visit)
      : engine_(engine), setting_(setting), visit_(visit) {}

  Status ask(const CellPoints& points, const Cells& cells) override;
  // Each piece with each.
  Status ask_crowded(const CrowdedCell& cell, const Cells& cells) override;
  Status finish(const Cells& cells) override;

 private:
  struct Candidate {
    LargeId id;
    Point place;
  };
  // A point and its nearest ones so far.
  struct Open {
    LargeId id;
    Point place;
    std::vector<Candidate> nearest;  // by distance, then id
  };

  // Finds the nearest ones of all points among them.
  Status find(const CellPoints& points);
  // What was found of one of them.
  [[nodiscard]] Open found(const CellPoints& points, std::size_t index) const;
  // Compares some of them with all points of an index.
  Status compare(std::vector<Open>& open, const std::vector<std::size_t>& some,
                 const CellPoints& points);
  void offer(Open& open, const Candidate& candidate) const;
  [[nodiscard]] bool is_within_reach(double distance_m) const;
  [[nodiscard]] bool is_settled(const Open& open) const;
  [[nodiscard]] bool may_be_nearer(const Open& open, const Box& box) const;
  // Tells those that are settled; the others wait.
  Status settle(std::vector<Open>& open, const Cells& cells);
  Status compare_waiting(const Cells& cells);
  void put(const Open& open);
  void tell();

  Engine& engine_;
  Setting setting_;
  const LargeNearestVisitor& visit_;
  NearestRows rows_;
  std::vector<Open> waiting_;
  std::vector<LargeId> ids_;
  std::vector<LargeNearest> entries_;
};

}  // namespace beespace::out_of_core
