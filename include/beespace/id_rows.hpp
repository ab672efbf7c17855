// Rows of ids of different lengths, one behind the other: "compressed sparse rows".
//
//   offsets   0        3     5        Row r is ids[offsets[r]] ... ids[offsets[r + 1] - 1].
//   ids       4  7  9  2  8
#pragma once

#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace beespace {

struct IdRows {
  std::vector<std::uint64_t> offsets;  // one more than there are rows; empty when there is no row
  std::vector<PointId> ids;

  [[nodiscard]] std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  [[nodiscard]] std::span<const PointId> operator[](std::size_t row) const {
    return std::span(ids).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }

  friend bool operator==(const IdRows&, const IdRows&) = default;
};

}  // namespace beespace
