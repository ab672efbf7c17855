// What could not be certified, as lists that C reads in place.
#pragma once

#include "c/door/result.hpp"

#include <beespace.h>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace beespace::c {

// One list, in columns.
struct Findings {
  Column<std::int64_t> first;
  Column<std::int64_t> second;
  Column<double> distances_m;
  Column<double> times_s;  // empty of a list without times

  // Overwrites it: row_of(found) is a Row.
  struct Row {
    std::int64_t first = 0;
    std::int64_t second = 0;
    double distance_m = 0.0;
    double time_s = 0.0;
  };
  template <class Found, class RowOf>
  void write(const std::vector<Found>& all, bool with_times, RowOf&& row_of) {
    first.resize(all.size());
    second.resize(all.size());
    distances_m.resize(all.size());
    times_s.resize(with_times ? all.size() : 0);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Row row = row_of(all[i]);
      first[i] = row.first;
      second[i] = row.second;
      distances_m[i] = row.distance_m;
      if (with_times) times_s[i] = row.time_s;
    }
  }
  void clear();
  // The list of a number; null where there is none.
  static const Findings* of(std::span<const Findings> lists, std::int32_t what) {
    const bool is_list = what >= 0 && static_cast<std::size_t>(what) < lists.size();
    return is_list ? &lists[static_cast<std::size_t>(what)] : nullptr;
  }
  // What the caller sees of it; of an absent list, a refusal.
  static Status show(const Findings* list, beespace_findings* into);
};

}  // namespace beespace::c
