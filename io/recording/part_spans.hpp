// Of records that are each of one of several parts, as the trials of a table or the tags of an
// animal: from when to when each part is, and whether two of them overlap.
#pragma once

#include "io/recording/track_gathering.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace beespace::io {

struct PartSpan {
  std::string group;
  std::string part;
  double first_s = 0.0;
  double last_s = 0.0;
  Origin begins = {};  // the record that came first
};

class PartSpans {
 public:
  // A record of that part; parts of different groups have nothing to do with each other.
  void take(std::string_view group, std::string_view part, double time_s, Origin origin);

  // Two parts of a group of which one begins before the other one has ended, or both at once: in
  // the order in which they came.
  [[nodiscard]] std::optional<std::pair<PartSpan, PartSpan>> overlapping() const;

 private:
  std::vector<PartSpan> spans_;  // in the order in which they came first
  std::unordered_map<std::string, std::size_t> index_;
  std::string key_;
  std::size_t last_ = 0;  // records of one part often follow each other
};

}  // namespace beespace::io
