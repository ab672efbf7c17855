#include "search/at_risk_search.hpp"

#include "core/density.hpp"
#include "core/exact_distance.hpp"
#include "core/look_around.hpp"
#include "cpu/sweep_all.hpp"

#include <algorithm>
#include <cstring>

namespace beespace::search {

namespace {

// Above this many mates in a point's proof cell, proofs settle nearly everybody.
constexpr double kCrowded = 2.0;

// The measured cost of looking around a point, as a multiple of what one cell mate adds to the
// sweep of a point.
constexpr double kLookCost = 100.0;

struct Search {
  const PointsView& points;
  const core::Bounds& bounds;
  const SearchOptions& options;
  Crew& crew;
  const Choices& choices;
  core::ProximityTest closer{options.threshold_m, options.inclusive};

  [[nodiscard]] core::Lattice lattice() const {
    return {points, bounds, options.threshold_m, choices.fold_beyond_cells};
  }

  void sweep(std::uint8_t* at_risk) const {
    const core::SortedGrid grid = core::sort_into_grid(points, {}, lattice(), crew);
    cpu::sweep_all(grid, points, closer, options.threshold_m,
                   cpu::sweep_kernel(choices.instruction_set), crew, at_risk);
  }

  void look(const std::vector<PointId>& undecided, std::uint8_t* at_risk) const {
    const core::Lattice cells = lattice();
    std::vector<PointId> subset;
    if (undecided.size() * 32 < points.size()) {
      subset = core::surroundings(points, cells, undecided, crew);
    }
    const core::SortedGrid grid = core::sort_into_grid(points, subset, cells, crew);
    core::look_around(grid, points, closer, options.threshold_m, crew, at_risk);
  }

  void run(core::Buffer<std::uint8_t>& at_risk) const {
    using Method = Choices::Method;
    const double mates = core::mean_cell_mates(points, core::proof_cell_side(options.threshold_m));
    const bool prove =
        choices.method == Method::kAutomatic ? mates > kCrowded : choices.method != Method::kSweep;
    if (!prove) {
      std::memset(at_risk.data(), 0, points.size());
      return sweep(at_risk.data());
    }
    const std::vector<PointId> undecided = core::prove_by_cells(
        points, bounds, options.threshold_m, closer, crew, at_risk, choices.cell_table);
    if (undecided.empty()) return;
    const bool few = mates * static_cast<double>(points.size()) >
                     kLookCost * static_cast<double>(undecided.size());
    if (choices.method == Method::kAutomatic ? few : choices.method == Method::kProveThenLook) {
      look(undecided, at_risk.data());
    } else {
      sweep(at_risk.data());
    }
  }
};

std::vector<PointId> ids_of(const core::Buffer<std::uint8_t>& at_risk, std::size_t size,
                            Crew& crew) {
  std::vector<std::size_t> offsets(crew.size() + 1);
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) count += at_risk[i];
    offsets[worker + 1] = count;
  });
  for (std::size_t worker = 1; worker < offsets.size(); ++worker) {
    offsets[worker] += offsets[worker - 1];
  }
  std::vector<PointId> ids;
  ids.reserve(offsets.back());
  core::advise_huge_pages(ids.data(), ids.capacity() * sizeof(PointId));
  ids.resize(offsets.back());
  crew.split(size, [&](std::size_t begin, std::size_t, unsigned worker) {
    // Written always and kept when at risk: a branch would be mispredicted for every odd one out.
    std::size_t next = offsets[worker];
    for (std::size_t i = begin; next < offsets[worker + 1]; ++i) {
      ids[next] = static_cast<PointId>(i);
      next += at_risk[i];
    }
  });
  return ids;
}

// Rows run along the axis with the longest extent: fewer, longer rows.
template <class Element>
std::array<Element, 3> permuted(const std::array<Element, 3>& values,
                                const std::array<std::size_t, 3>& order) {
  return {values[order[0]], values[order[1]], values[order[2]]};
}

}  // namespace

std::vector<PointId> at_risk_ids(const PointsView& points, const core::Bounds& bounds,
                                 const SearchOptions& options, Crew& crew,
                                 const Choices& choices) {
  if (points.size() < 2) return {};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return bounds.high[a] - bounds.low[a] > bounds.high[b] - bounds.low[b];
  });
  const PointsView turned = PointsView::strided(permuted(points.axes(), order), points.size(),
                                                permuted(points.stride_bytes(), order));
  const core::Bounds turned_bounds{permuted(bounds.low, order), permuted(bounds.high, order)};

  core::Buffer<std::uint8_t> at_risk(points.size());
  Search{turned, turned_bounds, options, crew, choices}.run(at_risk);
  return ids_of(at_risk, points.size(), crew);
}

}  // namespace beespace::search
