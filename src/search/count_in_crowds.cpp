#include "search/count_in_crowds.hpp"

#include "exact/exact_distance.hpp"
#include "grid/coincident_points.hpp"
#include "grid/lattice.hpp"
#include "search/crowded.hpp"
#include "sweep/box_counts.hpp"
#include "sweep/count_crowds.hpp"
#include "tree/crowd_tree.hpp"

#include <optional>

namespace beespace::search {

namespace {

// The places of a set, and how many of its points are at each.
class Side {
 public:
  Side(const PointsView& points, bool has_duplicates, const core::Bounds& bounds,
       const core::Lattice& lattice, const core::Resources& with)
      : points_(points) {
    if (has_duplicates) places_.emplace(points, with.memory);
    tree_.emplace(places_ ? places_->places() : points, bounds, lattice, with);
    if (!places_) return;
    const std::size_t padded = tree_->leaves() * core::kLeafPoints;
    weights_ = core::Buffer<std::uint32_t>(with.memory, padded);
    for (std::size_t slot = 0; slot < padded; ++slot) {
      weights_[slot] = slot < tree_->size() ? places_->points_at(tree_->index(slot)) : 0;
    }
  }

  // The same for trees of boxes.
  [[nodiscard]] cpu::Places boxes() const {
    if (!places_) return {points_, nullptr};
    return {places_->places(), places_->points_at()};
  }
  [[nodiscard]] cpu::Crowds crowds() const { return {*tree_, weights_.data()}; }
  [[nodiscard]] const std::optional<core::CoincidentPoints>& places() const { return places_; }

 private:
  PointsView points_;
  std::optional<core::CoincidentPoints> places_;
  std::optional<core::CrowdTree> tree_;
  core::Buffer<std::uint32_t> weights_;
};

}  // namespace

void count_in_crowds(const SearchDomain& domain, const PairOptions& options,
                     const core::Resources& with, const TuningOverrides& tuning,
                     std::uint32_t* counts) {
  const core::Lattice lattice(domain.sets(), domain.bounds(), options.threshold_m, with.memory,
                              tuning.fold_beyond_cells);
  const core::ProximityTest closer(options.threshold_m, options.inclusive);
  const bool duplicates = has_duplicates(domain, options.threshold_m);
  const Side asked(domain.points(), duplicates, domain.bounds(), lattice, with);
  std::optional<Side> others;
  if (domain.has_others()) {
    others.emplace(domain.others(), duplicates, domain.bounds(), lattice, with);
  }
  const cpu::CrowdQuery question{asked.crowds(),
                                 others ? others->crowds() : asked.crowds(),
                                 options.threshold_m,
                                 lattice.units_per_m(),
                                 closer,
                                 tuning.instruction_set,
                                 tuning.crowd_decisions};
  const auto count = [&](std::uint32_t* of_places) {
    if (cpu::count_crowds(question, with, of_places)) return;
    const cpu::Places around = others ? others->boxes() : asked.boxes();
    cpu::count_in_boxes(asked.boxes(), others ? &around : nullptr,
                        {options.threshold_m, closer, tuning.instruction_set}, with, of_places);
  };
  const std::size_t size = domain.points().size();
  const std::uint32_t self = domain.has_others() ? 0 : 1;
  if (!asked.places()) {
    count(counts);
    for (std::size_t id = 0; id < size; ++id) counts[id] -= self;
    return;
  }
  core::Buffer<std::uint32_t> of_places(with.memory, asked.places()->size());
  count(of_places.data());
  for (PointId id = 0; id < size; ++id) {
    counts[id] = of_places[asked.places()->place_of(id)] - self;
  }
}

}  // namespace beespace::search
