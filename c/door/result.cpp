#include "c/door/result.hpp"

#include <algorithm>

namespace beespace::c {

namespace {

constexpr std::int64_t id_of(PointId id) {
  return id == Nearest::kNone ? -1 : static_cast<std::int64_t>(id);
}

// How many entries are written between two looks at the stop: a few milliseconds.
constexpr std::size_t kStretch = std::size_t{1} << 20;

// Calls write(begin, end) for all entries [0, size), a stretch at a time.
template <class Write>
Status write_all(std::size_t size, const std::stop_token& stop, Write&& write) {
  for (std::size_t begin = 0; begin < size; begin += kStretch) {
    if (stop.stop_requested()) {
      return Error{ErrorCode::kStopped, "a stop was requested before the answer was complete", {}};
    }
    write(begin, std::min(begin + kStretch, size));
  }
  return std::monostate{};
}

// The same, for rows whose entries begin at offsets[row]: in stretches of whole rows.
template <class Offset, class Write>
Status write_all_rows(std::size_t row_count, const Offset* offsets, const std::stop_token& stop,
                      Write&& write) {
  std::size_t row = 0;
  while (row < row_count) {
    const std::size_t begin = row;
    const auto full = static_cast<Offset>(offsets[begin] + static_cast<Offset>(kStretch));
    Status status = write_all(1, stop, [&](std::size_t, std::size_t) {
      do {
        write(row++);
      } while (row < row_count && row - begin < kStretch && offsets[row] < full);
    });
    if (!status) return status;
  }
  return std::monostate{};
}

Status write_entries(std::span<const Nearest> entries, const std::stop_token& stop,
                     beespace_result& result) {
  result.ids.resize(entries.size());
  result.distances_m.resize(entries.size());
  return write_all(entries.size(), stop, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      result.ids[i] = id_of(entries[i].id);
      result.distances_m[i] = entries[i].distance_m;
    }
  });
}

}  // namespace

void write_ids(std::span<const PointId> ids, beespace_result& result) {
  result.ids.resize(ids.size());
  std::copy(ids.begin(), ids.end(), result.ids.data());
}

void write_counts(std::span<const std::uint32_t> counts, bool with_self, beespace_result& result) {
  result.counts.resize(counts.size());
  const std::int64_t self = with_self ? 1 : 0;
  std::transform(counts.begin(), counts.end(), result.counts.data(),
                 [self](std::uint32_t count) { return count + self; });
}

Status write_pairs(std::span<const Pair> pairs, const std::stop_token& stop,
                   beespace_result& result) {
  result.first.resize(pairs.size());
  result.second.resize(pairs.size());
  std::int64_t* const first = result.first.data();
  std::int64_t* const second = result.second.data();
  return write_all(pairs.size(), stop, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      first[i] = pairs[i].first;
      second[i] = pairs[i].second;
    }
  });
}

Status write_conflicts(std::span<const Conflict> conflicts, const std::stop_token& stop,
                       beespace_result& result) {
  const std::size_t size = conflicts.size();
  for (auto* const ids : {&result.first, &result.second}) ids->resize(size);
  for (auto* const numbers :
       {&result.begins_s, &result.closest_s, &result.ends_s, &result.distances_m}) {
    numbers->resize(size);
  }
  return write_all(size, stop, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Conflict& conflict = conflicts[i];
      result.first[i] = conflict.first;
      result.second[i] = conflict.second;
      result.begins_s[i] = conflict.begins_s;
      result.closest_s[i] = conflict.closest_s;
      result.ends_s[i] = conflict.ends_s;
      result.distances_m[i] = conflict.closest_m;
    }
  });
}

void write_gaps(std::span<const Gap> gaps, beespace_result& result) {
  result.gap_agents.resize(gaps.size());
  result.gap_begins_s.resize(gaps.size());
  result.gap_ends_s.resize(gaps.size());
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    result.gap_agents[i] = gaps[i].track;
    result.gap_begins_s[i] = gaps[i].begins_s;
    result.gap_ends_s[i] = gaps[i].ends_s;
  }
}

Status write_rows(const IdRows& rows, std::size_t row_count, const std::stop_token& stop,
                  beespace_result& result) {
  result.offsets.resize(row_count + 1);
  result.offsets[0] = 0;  // of no row there are no offsets in C++
  std::copy(rows.offsets.begin(), rows.offsets.end(), result.offsets.data());
  result.ids.resize(rows.ids.size());
  const PointId* const ids = rows.ids.data();
  return write_all(rows.ids.size(), stop, [&](std::size_t begin, std::size_t end) {
    std::copy(ids + begin, ids + end, result.ids.data() + begin);
  });
}

Status write_rows_with_self(const IdRows& rows, std::size_t row_count, const std::stop_token& stop,
                            beespace_result& result) {
  result.offsets.resize(row_count + 1);
  result.offsets[0] = 0;
  result.ids.resize(rows.ids.size() + row_count);
  std::int64_t* next = result.ids.data();
  const auto write_row = [&](std::size_t row) {
    const std::span<const PointId> others = rows[row];
    const auto behind = std::lower_bound(others.begin(), others.end(), row);
    next = std::copy(others.begin(), behind, next);
    *next++ = static_cast<std::int64_t>(row);
    next = std::copy(behind, others.end(), next);
    result.offsets[row + 1] = next - result.ids.data();
  };
  return write_all_rows(row_count, rows.offsets.data(), stop, write_row);
}

Status write_nearest(std::span<const Nearest> nearest, const std::stop_token& stop,
                     beespace_result& result) {
  return write_entries(nearest, stop, result);
}

Status write_nearest_rows(std::span<const Nearest> entries, std::size_t length,
                          std::size_t row_count, const std::stop_token& stop,
                          beespace_result& result) {
  result.offsets.resize(row_count + 1);
  for (std::size_t row = 0; row <= row_count; ++row) {
    result.offsets[row] = static_cast<std::int64_t>(row * length);
  }
  return write_entries(entries, stop, result);
}

Status write_row_distances(const PointsView& points, const PointsView& others,
                           const std::stop_token& stop, beespace_result& result) {
  result.distances_m.resize(result.ids.size());
  const std::size_t row_count = result.offsets.size() == 0 ? 0 : result.offsets.size() - 1;
  return write_all_rows(row_count, result.offsets.data(), stop, [&](std::size_t row) {
    const Point point = points[row];
    for (auto i = static_cast<std::size_t>(result.offsets[row]);
         i < static_cast<std::size_t>(result.offsets[row + 1]); ++i) {
      result.distances_m[i] = distance(point, others[static_cast<std::size_t>(result.ids[i])]);
    }
  });
}

}  // namespace beespace::c

void beespace_result::clear() {
  ids.clear();
  offsets.clear();
  first.clear();
  second.clear();
  counts.clear();
  distances_m.clear();
  begins_s.clear();
  closest_s.clear();
  ends_s.clear();
  gap_agents.clear();
  gap_begins_s.clear();
  gap_ends_s.clear();
}

extern "C" {

beespace_result* beespace_result_create(void) {
  try {
    return new beespace_result;
  } catch (...) {
    return nullptr;
  }
}

void beespace_result_free(beespace_result* result) {
  delete result;
}

int64_t beespace_result_size(const beespace_result* result) {
  if (result == nullptr) return 0;
  return static_cast<int64_t>(std::max(
      {result->ids.size(), result->first.size(), result->counts.size(), result->closest_s.size()}));
}

int64_t beespace_result_rows(const beespace_result* result) {
  if (result == nullptr || result->offsets.size() == 0) return 0;
  return static_cast<int64_t>(result->offsets.size()) - 1;
}

const int64_t* beespace_result_ids(const beespace_result* result) {
  return result == nullptr ? nullptr : result->ids.data();
}

const int64_t* beespace_result_offsets(const beespace_result* result) {
  return result == nullptr ? nullptr : result->offsets.data();
}

const int64_t* beespace_result_first(const beespace_result* result) {
  return result == nullptr ? nullptr : result->first.data();
}

const int64_t* beespace_result_second(const beespace_result* result) {
  return result == nullptr ? nullptr : result->second.data();
}

const int64_t* beespace_result_counts(const beespace_result* result) {
  return result == nullptr ? nullptr : result->counts.data();
}

const double* beespace_result_distances_m(const beespace_result* result) {
  return result == nullptr ? nullptr : result->distances_m.data();
}

const double* beespace_result_begins_s(const beespace_result* result) {
  return result == nullptr ? nullptr : result->begins_s.data();
}

const double* beespace_result_closest_s(const beespace_result* result) {
  return result == nullptr ? nullptr : result->closest_s.data();
}

const double* beespace_result_ends_s(const beespace_result* result) {
  return result == nullptr ? nullptr : result->ends_s.data();
}

int64_t beespace_result_gaps(const beespace_result* result) {
  return result == nullptr ? 0 : static_cast<int64_t>(result->gap_agents.size());
}

const int64_t* beespace_result_gap_agents(const beespace_result* result) {
  return result == nullptr ? nullptr : result->gap_agents.data();
}

const double* beespace_result_gap_begins_s(const beespace_result* result) {
  return result == nullptr ? nullptr : result->gap_begins_s.data();
}

const double* beespace_result_gap_ends_s(const beespace_result* result) {
  return result == nullptr ? nullptr : result->gap_ends_s.data();
}

}  // extern "C"
