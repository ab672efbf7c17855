// Records that are no mistake but say too little, or not what was asked for: counted by reason, to
// be told. Whether they may hide a bee that flies is part of the reason.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// "without a position", and what would keep them; the texts must outlive all counting.
struct LeftOutReason {
  std::string_view which;
  std::string_view advice = {};
  bool harmless = false;  // nothing that flies is missing without them
};

class LeftOut {
 public:
  void add(const LeftOutReason& reason) {
    for (Count& count : counts_) {
      if (count.reason.which == reason.which) {
        ++count.records;
        return;
      }
    }
    counts_.push_back({reason, 1});
  }

  // Each once, in the order of their first time.
  [[nodiscard]] std::vector<LeftOutReason> reasons() const {
    std::vector<LeftOutReason> reasons;
    for (const Count& count : counts_) reasons.push_back(count.reason);
    return reasons;
  }

  // How many may hide a bee that flies.
  [[nodiscard]] std::uint64_t hiding() const {
    std::uint64_t records = 0;
    for (const Count& count : counts_) records += count.reason.harmless ? 0 : count.records;
    return records;
  }

  // "3 records without a position are left out", in the order of their first time.
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> texts;
    for (const Count& count : counts_) {
      std::string text = std::to_string(count.records);
      text.append(count.records == 1 ? " record " : " records ").append(count.reason.which);
      text.append(count.records == 1 ? " is left out" : " are left out");
      if (!count.reason.advice.empty()) text.append("; ").append(count.reason.advice);
      texts.push_back(std::move(text));
    }
    return texts;
  }

 private:
  struct Count {
    LeftOutReason reason;
    std::uint64_t records;
  };

  std::vector<Count> counts_;  // a handful
};

}  // namespace beespace::io
