// Goes through all cells and asks a question of each.
#pragma once

#include "out_of_core/cells.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace beespace::out_of_core {

// A cell that is too full for the memory, in pieces of which two fit into it. Ids ascend from piece
// to piece, too.
class CrowdedCell {
 public:
  // Pieces of at most so many points, or of a single batch. All must outlive this.
  CrowdedCell(const Cells& cells, std::size_t cell, std::size_t most, const std::stop_token& stop);

  [[nodiscard]] std::size_t pieces() const { return pieces_.size(); }
  // Errors: kReadFailed, kCorrupt, kStopped.
  Status read(std::size_t piece, CellPoints& points) const;

 private:
  const Cells& cells_;
  const std::stop_token& stop_;
  std::vector<std::span<const Segment>> pieces_;
};

// A question, of one cell after the other.
class CellQuestion {
 public:
  CellQuestion() = default;
  CellQuestion(const CellQuestion&) = delete;
  CellQuestion& operator=(const CellQuestion&) = delete;
  virtual ~CellQuestion() = default;

  // Of one of the cells, which are all there.
  virtual Status ask(const CellPoints& points, const Cells& cells) = 0;
  virtual Status ask_crowded(const CrowdedCell& cell, const Cells& cells) = 0;
  // After all cells.
  virtual Status finish(const Cells& /*cells*/) { return std::monostate{}; }
};

// Calls `done(points)` with how many points were searched at home, on the calling thread. Says in
// `crowded` how many cells were searched in pieces. Errors: those of the question and of reading;
// kStopped.
Status walk_cells(const Cells& cells, std::size_t most, CellQuestion& question,
                  const std::stop_token& stop, const std::function<void(std::uint64_t)>& done,
                  std::uint64_t& crowded);

}  // namespace beespace::out_of_core
