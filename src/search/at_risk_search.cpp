#include "search/at_risk_search.hpp"

#include "base/buffer.hpp"
#include "exact/exact_distance.hpp"
#include "grid/cell_proof.hpp"
#include "grid/neighbor_probe.hpp"
#include "search/candidates.hpp"
#include "search/query_grids.hpp"
#include "sweep/box_questions.hpp"
#include "sweep/expected_work.hpp"
#include "sweep/sweep_all.hpp"

#include <algorithm>
#include <span>

namespace beespace::search {

namespace {

// Above this many expected_neighbors in a point's proof cell, proofs settle nearly all points.
constexpr double kCrowdedForProofs = 2.0;

// The measured cost of looking around a point, as a multiple of what one cell mate adds to the
// sweep of a point.
constexpr double kLookCost = 100.0;

// Of a point of one of two sets: what that takes is about the cost of trees of boxes. Measured.
constexpr double kMostComparisons = 1024.0;

struct Search {
  const SearchDomain& domain;
  const PairOptions& options;
  const core::Resources& with;
  const TuningOverrides& tuning;
  core::ProximityTest closer{options.threshold_m, options.inclusive};

  void sweep(std::uint8_t* at_risk) const {
    {
      const QueryGrids grids(domain, options, with, tuning);
      const cpu::SweepQuery question = grids.question();
      if (!domain.has_others() || !takes_boxes(question)) {
        return cpu::mark_all(question, with, at_risk);
      }
    }
    cpu::mark_in_boxes(domain.points(), domain.others(),
                       {options.threshold_m, closer, tuning.instruction_set}, with, at_risk);
  }

  // Whether points of two sets have so many others around that are not near that trees of boxes are
  // faster. (In one set they would be near to each other.)
  [[nodiscard]] bool takes_boxes(const cpu::SweepQuery& question) const {
    if (tuning.method != TuningOverrides::Method::kAutomatic) {
      return tuning.method == TuningOverrides::Method::kBoxes && !domain.points().empty();
    }
    const auto asked = static_cast<double>(question.asked.grid.size);
    const auto others = static_cast<double>(question.others.grid.size);
    const double most = kMostComparisons * (asked + others);
    return asked * others > most && cpu::expected_comparisons(question) > most &&
           cpu::expected_comparisons_until_near(question) > most;
  }

  void look(const core::Vector<PointId>& undecided, std::uint8_t* at_risk) const {
    const PointsView& points = domain.points();
    const core::Lattice lattice(domain.sets(), domain.bounds(), options.threshold_m, with.memory,
                                tuning.fold_beyond_cells);
    core::Selection selected{points};
    core::Vector<PointId> subset(&with.memory);
    if (undecided.size() * 32 < points.size()) {
      subset = core::surroundings({points, undecided}, {points}, lattice, with);
      selected.ids = subset;
    }
    const core::SortedGrid grid = core::sort_into_grid(selected, lattice, 0, with);
    core::probe_neighbors(grid, points, closer, options.threshold_m, with, at_risk);
  }

  void run(core::Buffer<std::uint8_t>& at_risk) const {
    using Method = TuningOverrides::Method;
    const std::size_t size = domain.points().size();
    double expected_neighbors = 0.0;
    bool prove = !domain.has_others() && tuning.method != Method::kSweep;
    if (prove) {
      expected_neighbors = domain.expected_neighbors(core::proof_cell_side(options.threshold_m));
      if (tuning.method == Method::kAutomatic) prove = expected_neighbors > kCrowdedForProofs;
    }
    if (!prove) return sweep(at_risk.data());
    const core::Vector<PointId> undecided =
        core::prove_by_cells(domain.points(), domain.bounds(), options.threshold_m, closer, with,
                             at_risk, tuning.cell_table);
    if (undecided.empty()) return;
    const bool few = expected_neighbors * static_cast<double>(size) >
                     kLookCost * static_cast<double>(undecided.size());
    if (tuning.method == Method::kAutomatic ? few : tuning.method == Method::kProveThenLook) {
      look(undecided, at_risk.data());
    } else {
      sweep(at_risk.data());
    }
  }
};

void write_ids(const core::Buffer<std::uint8_t>& at_risk, std::size_t size,
               const core::Resources& with, std::vector<PointId>& ids) {
  Crew& crew = with.crew;
  core::Vector<std::size_t> offsets(crew.size() + 1, &with.memory);
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) count += at_risk[i];
    offsets[worker + 1] = count;
  });
  for (std::size_t worker = 1; worker < offsets.size(); ++worker) {
    offsets[worker] += offsets[worker - 1];
  }
  if (ids.capacity() < offsets.back()) {
    ids.clear();
    ids.reserve(offsets.back());
    core::advise_huge_pages(ids.data(), ids.capacity() * sizeof(PointId));
  }
  ids.resize(offsets.back());
  crew.split(size, [&](std::size_t begin, std::size_t, unsigned worker) {
    // Written always and kept when at risk: a branch would be mispredicted for every odd one out.
    std::size_t next = offsets[worker];
    for (std::size_t i = begin; next < offsets[worker + 1]; ++i) {
      ids[next] = static_cast<PointId>(i);
      next += at_risk[i];
    }
  });
}

void find_among(const Candidates& candidates, const PairOptions& options,
                const core::Resources& with, const TuningOverrides& tuning,
                std::vector<PointId>& at_risk) {
  if (candidates.size() < 2) return;
  const SearchDomain domain = candidates.domain(with);
  core::Buffer<std::uint8_t> marks(with.memory, candidates.size());
  Search{domain, options, with, tuning}.run(marks);
  write_ids(marks, candidates.size(), with, at_risk);
  for (PointId& id : at_risk) id = candidates.id(id);
}

}  // namespace

void find_at_risk(const SearchDomain& domain, const PairOptions& options,
                  const core::Resources& with, const TuningOverrides& tuning,
                  std::vector<PointId>& at_risk) {
  at_risk.clear();
  if (domain.others().size() < (domain.has_others() ? 1U : 2U)) return;
  if (const auto candidates = Candidates::of(domain, options.threshold_m, with, tuning)) {
    find_among(*candidates, options, with, tuning, at_risk);
    return;
  }
  core::Buffer<std::uint8_t> marks(with.memory, domain.points().size());
  Search{domain, options, with, tuning}.run(marks);
  write_ids(marks, domain.points().size(), with, at_risk);
}

}  // namespace beespace::search
