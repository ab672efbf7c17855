// The grids of a frame for one threshold, ready to be asked.
#pragma once

#include "base/resources.hpp"
#include "exact/exact_distance.hpp"
#include "grid/sorted_grid.hpp"
#include "search/choices.hpp"
#include "search/frame.hpp"
#include "sweep/row_sweeps.hpp"

#include <beespace/search_options.hpp>

#include <optional>

namespace beespace::search {

class QuestionGrids {
 public:
  QuestionGrids(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                const Choices& choices);
  QuestionGrids(const QuestionGrids&) = delete;
  QuestionGrids& operator=(const QuestionGrids&) = delete;
  ~QuestionGrids() = default;

  [[nodiscard]] cpu::Question question() const;

 private:
  const Frame& frame_;
  core::ProximityTest closer_;
  cpu::InstructionSet instruction_set_;
  double threshold_m_;
  core::SortedGrid points_;
  std::optional<core::SortedGrid> others_;
};

}  // namespace beespace::search
