#include "search/question_grids.hpp"

#include "grid/lattice.hpp"
#include "grid/near_pairs.hpp"

#include <algorithm>

namespace beespace::search {

QuestionGrids::QuestionGrids(const Frame& frame, const SearchOptions& options,
                             const core::Resources& with, const Choices& choices)
    : frame_(frame),
      closer_(options.threshold_m, options.inclusive),
      instruction_set_(choices.instruction_set),
      threshold_m_(options.threshold_m),
      points_(with.memory) {
  const core::Lattice lattice(frame.sets(), frame.bounds(), threshold_m_, with.memory,
                              choices.fold_beyond_cells);
  unsigned row_shift = frame.row_shift(lattice, threshold_m_);
  if (choices.row_shift) row_shift = std::min(*choices.row_shift, 30 - lattice.fraction_bits());
  points_ = core::sort_into_grid({frame.points()}, lattice, row_shift, with);
  if (frame.has_others()) {
    others_ = core::sort_into_grid({frame.others()}, lattice, row_shift, with);
  }
}

cpu::Question QuestionGrids::question() const {
  const core::SquaredLimits squared(threshold_m_, points_.units_per_m);
  const cpu::Swarm asked{points_, frame_.points()};
  return {asked,
          others_ ? cpu::Swarm{*others_, frame_.others()} : asked,
          closer_,
          {squared.surely_near, squared.surely_far},
          cpu::kernels(instruction_set_),
          !others_};
}

}  // namespace beespace::search
