// The ids that an answer shows, as people know them: our bees', and the others'.
//
// The inputs must outlive it.
#pragma once

#include "analysis/snapshot/shown_ids.hpp"
#include "cli/detect/detection.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

class AnswerIds {
 public:
  AnswerIds(const Inputs& inputs, const Table& table, Form form);
  ~AnswerIds() = default;
  AnswerIds(const AnswerIds&) = delete;
  AnswerIds& operator=(const AnswerIds&) = delete;

  // Of whom a row is about, or who stands first.
  [[nodiscard]] const analysis::ShownIds& ours() const { return ours_; }
  // Of whom a value names, or who stands second: the same without others.
  [[nodiscard]] const analysis::ShownIds& theirs() const { return theirs_ ? *theirs_ : ours_; }
  [[nodiscard]] const analysis::ShownIds* of_others() const {
    return theirs_ ? &*theirs_ : nullptr;
  }

 private:
  std::vector<PointId> our_points_;  // ascending
  std::vector<PointId> their_points_;
  analysis::ShownIds ours_;
  std::optional<analysis::ShownIds> theirs_;
};

// Ids that are not shown as the file has them: that are empty, or have tabs or line ends in them.
struct OddIds {
  std::uint64_t empty = 0;
  std::uint64_t broken = 0;
};

// Says so of bees, `which` behind that word; JSON needs no blanks.
void note_ids(const OddIds& ids, std::string_view which, Form form,
              std::vector<std::string>& notes);

}  // namespace beespace::cli
