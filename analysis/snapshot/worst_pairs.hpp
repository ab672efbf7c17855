// The pairs to show: all who are too close, or the closest of very many.
#pragma once

#include <beespace/engine.hpp>
#include <beespace/pairs.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <vector>

namespace beespace::analysis {

inline constexpr std::uint64_t kAllPairs = 200'000;  // of no more than these, all
inline constexpr std::uint64_t kWorstPairs = 10'000;

struct WorstPairs {
  std::uint64_t count = 0;          // of all
  std::vector<Pair> pairs;          // the closest first; of equally close ones, by their ids
  std::vector<double> distances_m;  // of each of these
};

// `places` are what the question is about, `points` what distances are taken of: the same, but for
// geographic positions with a vertical threshold. Errors: as Engine::find_pairs.
Result<WorstPairs> worst_pairs(Engine& engine, const PointsView& places, const PointsView& points,
                               const SearchOptions& options);

}  // namespace beespace::analysis
