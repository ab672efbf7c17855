// The bad records that were left out, and which data row each remaining point comes from.
#pragma once

#include <beespace/result.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {

// How a message ends while the record is not yet left out.
inline constexpr std::string_view kOrLeaveOut = ", or leave such records out with --skip-bad";

// Of several files, which what comes line by line is not.
inline constexpr std::string_view kAndOneClock =
    " (and, if times of several files count from one zero, --one-clock)";

// The error without that advice, where it cannot be followed.
inline Error without_advice(Error error) {
  for (const std::string_view text : {kOrLeaveOut, kAndOneClock}) {
    const std::size_t advice = error.message.rfind(text);
    if (advice != std::string::npos) error.message.erase(advice, text.size());
  }
  return error;
}

inline constexpr std::size_t kMostSkippedListed = 20;

struct SkippedRecords {
  std::vector<std::uint64_t> rows = {};  // 0-based data rows, ascending
  std::vector<Error> errors = {};        // the first kMostSkippedListed, in the order of the rows

  void add(std::uint64_t row, Error error) {
    rows.push_back(row);
    if (errors.size() >= kMostSkippedListed) return;
    errors.push_back(without_advice(std::move(error)));
  }

  // The data row of point `index`: the rows before it that were skipped come on top.
  [[nodiscard]] std::uint64_t row_of(std::uint64_t index) const {
    std::size_t low = 0;
    std::size_t high = rows.size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (rows[middle] - middle <= index) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return index + low;
  }

  // Takes in others, found later, of rows that may lie between.
  void merge(SkippedRecords&& later) {
    const auto middle = static_cast<std::ptrdiff_t>(rows.size());
    rows.insert(rows.end(), later.rows.begin(), later.rows.end());
    const bool behind = middle == 0 || rows.size() == static_cast<std::size_t>(middle) ||
                        rows[static_cast<std::size_t>(middle) - 1] < *(rows.begin() + middle);
    if (!behind) std::inplace_merge(rows.begin(), rows.begin() + middle, rows.end());
    errors.insert(errors.end(), std::make_move_iterator(later.errors.begin()),
                  std::make_move_iterator(later.errors.end()));
    std::stable_sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) {
      return a.location.record < b.location.record;
    });
    if (errors.size() > kMostSkippedListed) {
      errors.resize(kMostSkippedListed);
    }
  }
};

}  // namespace beespace::io
