// Questions about points beyond memory, whose answers are shown to visitors, block by block.
#include "c/door/options.hpp"
#include "c/door/question.hpp"
#include "c/out_of_core/audience.hpp"
#include "c/out_of_core/out_of_core.hpp"

#include <beespace/pairs.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::kMostPairsAtOnce;
using beespace::LargeClosestPair;
using beespace::LargeId;
using beespace::LargeNearest;
using beespace::LargePair;
using beespace::OutOfCore;
using beespace::Result;
using beespace::RunOptions;
using beespace::SearchOptions;
using beespace::Status;

namespace {

// The same numbers: none of them has the highest bit.
const std::int64_t* signed_of(std::span<const std::uint64_t> numbers) {
  return reinterpret_cast<const std::int64_t*>(numbers.data());
}

// Asks ask(search, audience, run), with the threads and the stop of the run.
template <class Ask>
Status ask_watched(beespace_out_of_core* out_of_core, const beespace_run* run, Ask&& ask) {
  if (out_of_core == nullptr) return invalid("the pointer to the search is NULL", "out_of_core");
  return call_watched(run, [&](const RunOptions& options) -> Status {
    Audience audience(options);
    out_of_core->search.set_run(audience.run());
    return audience.status_of(ask(out_of_core->search, audience));
  });
}

// Asks ask(search, options, audience, what is asked) a question with a threshold.
template <class Visitor, class Ask>
beespace_code ask_within(beespace_out_of_core* out_of_core, const beespace_search* search,
                         std::uint32_t known, const beespace_run* run, Visitor visit,
                         beespace_error* error, Ask&& ask) {
  return enter(error, [&]() -> Status {
    if (visit == nullptr) return invalid("the pointer to the visitor is NULL", "visit");
    const Result<Search> asked = search_of(search, known);
    if (!asked) return asked.error();
    return ask_watched(out_of_core, run, [&](OutOfCore& used, Audience& audience) -> Status {
      SearchOptions options = asked->points(audience.run());
      options.height_unit_m = out_of_core->height_unit_m;
      return ask(used, options, audience, *asked);
    });
  });
}

// Pairs in the widths of C.
class PairBlocks {
 public:
  void show(std::span<const LargePair> pairs, std::span<const double> distances_m, bool distances,
            Audience& audience, beespace_pair_visitor visit, void* data) {
    for (std::size_t begin = 0; begin < pairs.size(); begin += kMostPairsAtOnce) {
      const std::size_t count = std::min(kMostPairsAtOnce, pairs.size() - begin);
      for (std::size_t at = 0; at < count; ++at) {
        first_[at] = static_cast<std::int64_t>(pairs[begin + at].first);
        second_[at] = static_cast<std::int64_t>(pairs[begin + at].second);
      }
      audience.tell([&] {
        return visit(data, first_.data(), second_.data(),
                     distances ? distances_m.data() + begin : nullptr,
                     static_cast<std::int64_t>(count));
      });
    }
  }

 private:
  std::array<std::int64_t, kMostPairsAtOnce> first_{};
  std::array<std::int64_t, kMostPairsAtOnce> second_{};
};

// Rows of neighbours in columns, some rows at a time.
class NearestBlocks {
 public:
  void show(std::span<const LargeId> ids, std::span<const LargeNearest> entries, Audience& audience,
            beespace_nearest_visitor visit, void* data) {
    constexpr std::size_t kEntriesAtOnce = std::size_t{1} << 16U;
    const std::size_t length = entries.size() / ids.size();
    const std::size_t rows_at_once = std::max<std::size_t>(1, kEntriesAtOnce / length);
    for (std::size_t begin = 0; begin < ids.size(); begin += rows_at_once) {
      const std::size_t rows = std::min(rows_at_once, ids.size() - begin);
      nearest_.clear();
      distances_m_.clear();
      for (const LargeNearest& near : entries.subspan(begin * length, rows * length)) {
        nearest_.push_back(static_cast<std::int64_t>(near.id));
        distances_m_.push_back(near.distance_m);
      }
      audience.tell([&] {
        return visit(data, signed_of(ids.subspan(begin)), static_cast<std::int64_t>(rows),
                     nearest_.data(), distances_m_.data(), static_cast<std::int64_t>(length));
      });
    }
  }

 private:
  std::vector<std::int64_t> nearest_;
  std::vector<double> distances_m_;
};

}  // namespace

extern "C" {

beespace_code beespace_out_of_core_at_risk(beespace_out_of_core* out_of_core,
                                           const beespace_search* search, const beespace_run* run,
                                           beespace_ids_visitor visit, void* data,
                                           beespace_error* error) {
  return ask_within(
      out_of_core, search, kWithin, run, visit, error,
      [&](OutOfCore& used, const SearchOptions& options, Audience& audience, const Search&) {
        return used.find_at_risk(options, [&](std::span<const LargeId> ids) {
          audience.tell(
              [&] { return visit(data, signed_of(ids), static_cast<std::int64_t>(ids.size())); });
        });
      });
}

beespace_code beespace_out_of_core_pairs(beespace_out_of_core* out_of_core,
                                         const beespace_search* search, const beespace_run* run,
                                         beespace_pair_visitor visit, void* data,
                                         beespace_error* error) {
  return ask_within(
      out_of_core, search, kWithin | BEESPACE_DISTANCES, run, visit, error,
      [&](OutOfCore& used, const SearchOptions& options, Audience& audience, const Search& asked) {
        const auto blocks = std::make_unique<PairBlocks>();
        return used.visit_pairs(
            options, [&](std::span<const LargePair> pairs, std::span<const double> distances_m) {
              blocks->show(pairs, distances_m, asked.distances, audience, visit, data);
            });
      });
}

beespace_code beespace_out_of_core_count(beespace_out_of_core* out_of_core,
                                         const beespace_search* search, const beespace_run* run,
                                         beespace_counts_visitor visit, void* data,
                                         beespace_error* error) {
  return ask_within(
      out_of_core, search, kWithin, run, visit, error,
      [&](OutOfCore& used, const SearchOptions& options, Audience& audience, const Search&) {
        return used.count_neighbors(
            options, [&](std::span<const LargeId> ids, std::span<const std::uint64_t> counts) {
              audience.tell([&] {
                return visit(data, signed_of(ids), signed_of(counts),
                             static_cast<std::int64_t>(ids.size()));
              });
            });
      });
}

beespace_code beespace_out_of_core_nearest(beespace_out_of_core* out_of_core, int64_t k,
                                           const beespace_run* run, beespace_nearest_visitor visit,
                                           void* data, beespace_error* error) {
  return enter(error, [&]() -> Status {
    if (visit == nullptr) return invalid("the pointer to the visitor is NULL", "visit");
    if (k < 0) return invalid("k is below zero", "k");
    return ask_watched(out_of_core, run, [&](OutOfCore& used, Audience& audience) -> Status {
      NearestBlocks blocks;
      return used.find_k_nearest(
          static_cast<std::size_t>(k),
          [&](std::span<const LargeId> ids, std::span<const LargeNearest> entries) {
            blocks.show(ids, entries, audience, visit, data);
          });
    });
  });
}

beespace_code beespace_out_of_core_closest_pair(beespace_out_of_core* out_of_core,
                                                const beespace_run* run, beespace_result* result,
                                                beespace_error* error) {
  return answer_into(result, error, [&]() -> Status {
    return ask_watched(out_of_core, run, [&](OutOfCore& used, Audience&) -> Status {
      const Result<std::optional<LargeClosestPair>> closest = used.find_closest_pair();
      if (!closest) return closest.error();
      if (!*closest) return std::monostate{};
      const auto& [pair, distance_m] = **closest;
      result->first.resize(1);
      result->second.resize(1);
      result->distances_m.resize(1);
      result->first[0] = static_cast<std::int64_t>(pair.first);
      result->second[0] = static_cast<std::int64_t>(pair.second);
      result->distances_m[0] = distance_m;
      return std::monostate{};
    });
  });
}

}  // extern "C"
