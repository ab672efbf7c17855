#include "search/query_grids.hpp"

#include "grid/lattice.hpp"
#include "grid/near_pairs.hpp"

#include <algorithm>

namespace beespace::search {

QueryGrids::QueryGrids(const SearchDomain& domain, const PairOptions& options,
                       const core::Resources& with, const TuningOverrides& tuning)
    : domain_(domain),
      closer_(options.threshold_m, options.inclusive),
      instruction_set_(tuning.instruction_set),
      threshold_m_(options.threshold_m),
      points_(with.memory) {
  const core::Lattice lattice(domain.sets(), domain.bounds(), threshold_m_, with.memory,
                              tuning.fold_beyond_cells);
  unsigned row_shift = domain.row_shift(lattice, threshold_m_);
  if (tuning.row_shift) row_shift = std::min(*tuning.row_shift, 30 - lattice.fraction_bits());
  points_ = core::sort_into_grid({domain.points()}, lattice, row_shift, with);
  if (domain.has_others()) {
    others_ = core::sort_into_grid({domain.others()}, lattice, row_shift, with);
  }
}

cpu::SweepQuery QueryGrids::question() const {
  const core::SquaredLimits squared(threshold_m_, points_.units_per_m);
  const cpu::Swarm asked{points_, domain_.points()};
  return {asked,
          others_ ? cpu::Swarm{*others_, domain_.others()} : asked,
          closer_,
          {squared.surely_near, squared.surely_far},
          cpu::kernels(instruction_set_),
          !others_};
}

}  // namespace beespace::search
