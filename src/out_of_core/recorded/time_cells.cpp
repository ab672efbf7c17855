#include "out_of_core/recorded/time_cells.hpp"

namespace beespace::out_of_core {

WindowSize TimeCells::size_of(std::size_t first, std::size_t last) const {
  // Of each piece over a border the fix beyond it.
  const auto entering = first == 0 ? 0U : static_cast<std::uint64_t>(cells_[first - 1].over);
  WindowSize size{entering + static_cast<std::uint64_t>(cells_[last].over), entering};
  for (std::size_t cell = first; cell <= last; ++cell) {
    size.fixes += cells_[cell].fixes;
    size.segments += cells_[cell].segments;
  }
  return size;
}

std::vector<std::size_t> TimeCells::cut(const WindowCost& cost, std::uint64_t limit) const {
  std::vector<std::size_t> lasts;
  WindowSize inside;  // of the window that grows, without what goes over its last border
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const Cell& next = cells_[cell];
    const auto leaving = static_cast<std::uint64_t>(next.over);
    WindowSize grown{inside.fixes + next.fixes, inside.segments + next.segments};
    // It never gets smaller: what goes over a border ends in the next cell, or goes over its
    // border.
    if (cell > 0 && cost.of({grown.fixes + leaving, grown.segments}) > limit) {
      lasts.push_back(cell - 1);
      const auto entering = static_cast<std::uint64_t>(cells_[cell - 1].over);
      grown = {entering + next.fixes, entering + next.segments};
    }
    inside = grown;
  }
  lasts.push_back(cells_.size() - 1);
  return lasts;
}

}  // namespace beespace::out_of_core
