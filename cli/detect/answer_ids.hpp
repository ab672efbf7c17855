// The ids that an answer shows, as people know them: our bees', and the others'.
//
// The inputs must outlive it.
#pragma once

#include "cli/analysis/shown_ids.hpp"
#include "cli/detect/detection.hpp"

#include <optional>
#include <vector>

namespace beespace::cli {

class AnswerIds {
 public:
  AnswerIds(const Inputs& inputs, const Table& table, Form form);
  ~AnswerIds() = default;
  AnswerIds(const AnswerIds&) = delete;
  AnswerIds& operator=(const AnswerIds&) = delete;

  // Of whom a row is about, or who stands first.
  [[nodiscard]] const ShownIds& ours() const { return ours_; }
  // Of whom a value names, or who stands second: the same without others.
  [[nodiscard]] const ShownIds& theirs() const { return theirs_ ? *theirs_ : ours_; }
  [[nodiscard]] const ShownIds* of_others() const { return theirs_ ? &*theirs_ : nullptr; }

 private:
  std::vector<PointId> our_points_;  // ascending
  std::vector<PointId> their_points_;
  ShownIds ours_;
  std::optional<ShownIds> theirs_;
};

}  // namespace beespace::cli
