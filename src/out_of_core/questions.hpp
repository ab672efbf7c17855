// The questions that can be asked of points beyond memory.
#pragma once

#include "exact/cylinder.hpp"
#include "out_of_core/cell_walk.hpp"
#include "out_of_core/stored_points.hpp"

#include <beespace/engine.hpp>
#include <beespace/nearest.hpp>
#include <beespace/out_of_core.hpp>
#include <beespace/pairs.hpp>
#include <beespace/points_view.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::out_of_core {

class AtRiskQuestion final : public CellQuestion {
 public:
  // All must outlive this.
  AtRiskQuestion(Engine& engine, const SearchOptions& options, const LargeIdVisitor& visit)
      : engine_(engine), options_(options), visit_(visit) {}

  Status ask(const CellPoints& points, const Cells& cells) override;
  // In two passes over a crowd: nearly all of its points are at risk within their own piece.
  Status ask_crowded(const CrowdedCell& cell, const Cells& cells) override;

 private:
  // A point that is not at risk within its own piece.
  struct Open {
    LargeId id;
    std::size_t piece;
  };

  // Those of open_ that no piece but their own has been compared with; tells which are at risk.
  Status ask_open(const CrowdedCell& cell);
  void tell();

  Engine& engine_;
  const SearchOptions& options_;
  const LargeIdVisitor& visit_;
  std::vector<PointId> found_;
  std::vector<LargeId> ids_;
  std::vector<Open> open_;
  PointMemory open_points_;
  std::vector<bool> open_at_risk_;
};

class CountQuestion final : public CellQuestion {
 public:
  // All must outlive this.
  CountQuestion(Engine& engine, const SearchOptions& options, const LargeCountVisitor& visit)
      : engine_(engine), options_(options), visit_(visit) {}

  Status ask(const CellPoints& points, const Cells& cells) override;
  // Each piece with each.
  Status ask_crowded(const CrowdedCell& cell, const Cells& cells) override;

 private:
  Status count(const CellPoints& points);
  void tell(const CellPoints& points);

  Engine& engine_;
  const SearchOptions& options_;
  const LargeCountVisitor& visit_;
  std::vector<std::uint32_t> counts_;  // of a search
  std::vector<std::uint64_t> sums_;    // of a piece
  std::vector<LargeId> ids_;
};

class PairsQuestion final : public CellQuestion {
 public:
  // All must outlive this. At most so many pairs of two pieces are found at a time.
  PairsQuestion(Engine& engine, const SearchOptions& options, std::size_t most,
                const LargePairVisitor& visit)
      : engine_(engine),
        options_(options),
        line_(options.height_unit_m),
        most_(most),
        visit_(visit) {}

  Status ask(const CellPoints& points, const Cells& cells) override;
  // Each piece with each.
  Status ask_crowded(const CrowdedCell& cell, const Cells& cells) override;

 private:
  // Of the points [begin, end) of the first.
  Status ask_some(const CellPoints& points, std::size_t begin, std::size_t end,
                  const CellPoints& others);
  void keep(const CellPoints& points, std::size_t first, const CellPoints& others,
            std::size_t second);
  [[nodiscard]] double distance_of(const PointsView& points, std::size_t first,
                                   const PointsView& others, std::size_t second) const;
  void tell();

  Engine& engine_;
  const SearchOptions& options_;
  core::StraightLine line_;
  std::size_t most_;
  const LargePairVisitor& visit_;
  std::vector<Pair> found_;
  std::vector<LargePair> pairs_;
  std::vector<double> distances_m_;
};

// The closest pair. The reach of halos is the distance of any two points, or more.
class ClosestPairQuestion final : public CellQuestion {
 public:
  // All must outlive this.
  ClosestPairQuestion(Engine& engine, const RunOptions& run) : engine_(engine), run_(run) {}

  Status ask(const CellPoints& points, const Cells& cells) override;
  // Each piece with each.
  Status ask_crowded(const CrowdedCell& cell, const Cells& cells) override;

  [[nodiscard]] std::optional<LargeClosestPair> closest() const;

 private:
  struct Candidate {
    LargePair pair;
    Point first;
    Point second;
  };

  Status ask_between(const CellPoints& points, const CellPoints& others);
  void offer(const Candidate& candidate);

  Engine& engine_;
  const RunOptions& run_;
  std::optional<Candidate> best_;
};

}  // namespace beespace::out_of_core
