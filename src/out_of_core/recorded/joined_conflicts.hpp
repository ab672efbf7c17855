// Conflicts of one window after the other, in the order of pairs, and joined where they go on over
// a border.
//
// The piece of an agent that goes over a border (begins at or before it, ends after it) is in both
// windows, whole, and no other is in two neighbouring windows unless it goes over their border. Of
// two agents, the time W in which both are on such a piece is thus the last of the one window and
// the first of the other, and the engine finds the same in it: at most one stretch of conflict.
// Where there is one, the last stretch of the pair in the one window and the first in the other
// both contain it, and are one conflict. Where there is none, the one ends where W begins at the
// latest, and the other begins where W ends at the earliest, which is later.
#pragma once

#include "out_of_core/recorded/time_windows.hpp"
#include "out_of_core/sorted_rows.hpp"

#include <beespace/conflict.hpp>
#include <beespace/crew.hpp>
#include <beespace/recording_out_of_core.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace beespace::out_of_core {

class JoinedConflicts {
 public:
  JoinedConflicts(std::string folder, const SortMemory& memory)
      : rows_(std::move(folder), memory) {}

  // Of the next window, with the ids that its tracks stand for. Errors: those of SortedRows.
  Status add(std::uint64_t window, std::span<const Conflict> conflicts, const WindowTracks& tracks,
             Crew& crew);

  // After all of them. Errors: those of SortedRows; kTooManyResults.
  Status visit(std::uint64_t max_results, const LargeConflictVisitor& visit, Crew& crew);

 private:
  struct Row {
    LargeConflict conflict;
    std::uint64_t window;

    [[nodiscard]] auto order() const {
      return std::tie(conflict.first, conflict.second, window, conflict.begins_s, conflict.ends_s);
    }
    friend bool operator<(const Row& a, const Row& b) { return a.order() < b.order(); }
  };

  static bool goes_on(const Row& before, const Row& next);
  static void join(Row& before, const Row& next);

  SortedRows<Row> rows_;
};

}  // namespace beespace::out_of_core
