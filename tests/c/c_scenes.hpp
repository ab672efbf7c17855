// Points of C++ as arguments of C, and answers of C as containers of C++.
#pragma once

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace beespace::test {

struct Free {
  void operator()(beespace_engine* engine) const { beespace_engine_free(engine); }
  void operator()(beespace_result* result) const { beespace_result_free(result); }
  void operator()(beespace_stop* stop) const { beespace_stop_free(stop); }
  void operator()(beespace_index* index) const { beespace_index_free(index); }
  void operator()(beespace_obstacles* obstacles) const { beespace_obstacles_free(obstacles); }
  void operator()(beespace_out_of_core* search) const { beespace_out_of_core_free(search); }
  void operator()(beespace_large_recording* recording) const {
    beespace_large_recording_free(recording);
  }
  void operator()(beespace_swarm* swarm) const { beespace_swarm_free(swarm); }
  void operator()(beespace_events* events) const { beespace_events_free(events); }
  void operator()(beespace_movers* movers) const { beespace_movers_free(movers); }
  void operator()(beespace_verifier* verifier) const { beespace_verifier_free(verifier); }
  void operator()(beespace_violations* violations) const { beespace_violations_free(violations); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Free>;

inline beespace_points c_points(const std::vector<Point>& points) {
  const double* const first = points.empty() ? nullptr : &points.front().x;
  return beespace_points_interleaved(first, static_cast<std::int64_t>(points.size()));
}

inline beespace_search c_search(double threshold_m, std::uint32_t flags = 0) {
  beespace_search search{};
  search.struct_size = sizeof search;
  search.flags = flags;
  search.threshold_m = threshold_m;
  return search;
}

inline beespace_error c_error() {
  beespace_error error{};
  error.struct_size = sizeof error;
  return error;
}

using Numbers = std::vector<std::int64_t>;

inline Numbers numbers(const std::int64_t* first, std::int64_t count) {
  return first == nullptr ? Numbers() : Numbers(first, first + count);
}

// All columns of a result; of rows that are none, no offsets, as in C++.
struct Columns {
  Numbers ids;
  Numbers offsets;
  Numbers first;
  Numbers second;
  Numbers counts;
  std::vector<double> distances_m;

  friend bool operator==(const Columns&, const Columns&) = default;
};

inline Columns columns(const Owned<beespace_result>& result) {
  const beespace_result* const from = result.get();
  const std::int64_t size = beespace_result_size(from);
  Columns all;
  all.ids = numbers(beespace_result_ids(from), size);
  all.offsets = numbers(beespace_result_offsets(from), beespace_result_rows(from) + 1);
  all.first = numbers(beespace_result_first(from), size);
  all.second = numbers(beespace_result_second(from), size);
  all.counts = numbers(beespace_result_counts(from), size);
  const double* const distances = beespace_result_distances_m(from);
  if (distances != nullptr) all.distances_m.assign(distances, distances + size);
  return all;
}

template <class Ids>
Numbers wide(const Ids& ids) {
  return Numbers(ids.begin(), ids.end());
}

inline Columns columns_of(const std::vector<Pair>& pairs) {
  Columns all;
  for (const Pair& pair : pairs) {
    all.first.push_back(pair.first);
    all.second.push_back(pair.second);
  }
  return all;
}

inline Columns columns_of(const IdRows& rows) {
  Columns all;
  all.ids = wide(rows.ids);
  all.offsets = rows.offsets.empty() ? Numbers{0} : wide(rows.offsets);
  return all;
}

inline Columns columns_of(const std::vector<Nearest>& entries) {
  Columns all;
  for (const Nearest& entry : entries) {
    all.ids.push_back(entry.id == Nearest::kNone ? -1 : static_cast<std::int64_t>(entry.id));
    all.distances_m.push_back(entry.distance_m);
  }
  return all;
}

}  // namespace beespace::test
