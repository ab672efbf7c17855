// How far places may be off by a column of the table itself, as receivers of satellites estimate
// it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace beespace::io {

// Of each bee of a table that has such a column: what half of its places are off by, or more.
struct StatedAccuracy {
  std::string column = {};             // the first, as its header names it
  std::vector<double> medians_m = {};  // in no order; of none where no table has one
};

class AccuracyGathering {
 public:
  // A place of that bee may be off by so much, as that column says.
  void take(std::string_view id, double off_m, std::string_view column);

  // Medians by steps of a tenth, in two digits, not below what they are.
  [[nodiscard]] StatedAccuracy found() const;

 private:
  // How many places are off by less than each of these, ever greater ones: bees may have millions.
  static constexpr std::size_t kSteps = 128;
  using Counts = std::array<std::uint32_t, kSteps>;

  std::string column_;
  std::unordered_map<std::string, Counts> counts_;
};

}  // namespace beespace::io
