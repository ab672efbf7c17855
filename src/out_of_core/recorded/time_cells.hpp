// Time cut at borders, and what lies between two of them: where windows can begin and end.
//
// A window has the straight pieces between two fixes that begin at or before its last border and
// end after its first one, whole, and the fixes in it that are alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::out_of_core {

// Cell i is what is above border i - 1, and not above border i.
class TimeBorders {
 public:
  // Ascending, each once.
  explicit TimeBorders(std::vector<double> borders = {}) : borders_(std::move(borders)) {}

  [[nodiscard]] std::size_t cells() const { return borders_.size() + 1; }
  [[nodiscard]] const std::vector<double>& all() const { return borders_; }

  // The cell of a time, which is not before `from`.
  [[nodiscard]] std::size_t cell_of(double time_s, std::size_t from = 0) const {
    constexpr std::size_t kNear = 4;
    for (std::size_t step = 0; step < kNear; ++step, ++from) {
      if (from == borders_.size() || !(borders_[from] < time_s)) return from;
    }
    const auto begin = borders_.begin() + static_cast<std::ptrdiff_t>(from);
    return static_cast<std::size_t>(std::lower_bound(begin, borders_.end(), time_s) -
                                    borders_.begin());
  }

 private:
  std::vector<double> borders_;
};

// What a search has to hold.
struct WindowSize {
  std::uint64_t fixes = 0;
  std::uint64_t segments = 0;  // stretches of an agent that are known without a gap

  friend bool operator==(const WindowSize&, const WindowSize&) = default;
};

// Of the memory.
struct WindowCost {
  std::uint64_t fix_bytes;
  std::uint64_t segment_bytes;

  [[nodiscard]] std::uint64_t of(const WindowSize& size) const {
    return size.fixes * fix_bytes + size.segments * segment_bytes;
  }
};

// How many fixes, and pieces over its borders, each cell has.
class TimeCells {
 public:
  explicit TimeCells(std::size_t cells) : cells_(cells) {}

  [[nodiscard]] std::size_t count() const { return cells_.size(); }

  // A fix, to which no piece leads.
  void begin(std::size_t cell) {
    ++cells_[cell].fixes;
    ++cells_[cell].segments;
  }
  // A fix, and the piece that leads to it from a fix in the cell `from`.
  void go_on(std::size_t from, std::size_t cell) {
    ++cells_[cell].fixes;
    if (from == cell) return;
    ++cells_[from].over;
    --cells_[cell].over;
  }
  // After all of them.
  void finish() {
    for (std::size_t cell = 1; cell < cells_.size(); ++cell) {
      cells_[cell].over += cells_[cell - 1].over;
    }
  }

  // Of a window that is made of these cells, after finish().
  [[nodiscard]] WindowSize size_of(std::size_t first, std::size_t last) const;

  // As few windows as go without looking ahead, none of which costs more than the limit: the last
  // cell of each. A cell that costs more by itself is a window.
  [[nodiscard]] std::vector<std::size_t> cut(const WindowCost& cost, std::uint64_t limit) const;

 private:
  struct Cell {
    std::uint64_t fixes = 0;
    std::uint64_t segments = 0;  // that begin in it
    // Pieces over the border behind it; before finish(), how many more than over the one before.
    std::int64_t over = 0;
  };

  std::vector<Cell> cells_;
};

}  // namespace beespace::out_of_core
