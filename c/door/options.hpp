// The caller's beespace_search as the options of the C++ library.
#pragma once

#include "c/door/watched_call.hpp"

#include <beespace.h>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>

namespace beespace::c {

struct Search {
  PairOptions options;  // without threads and stop, which belong to a run
  bool distances = false;
  bool with_self = false;

  // What one run obeys.
  [[nodiscard]] PairOptions pairs(const RunOptions& run) const;
  [[nodiscard]] SearchOptions points(const RunOptions& run) const;
};

// `known` are the flags that the question understands.
Result<Search> search_of(const beespace_search* search, std::uint32_t known);

}  // namespace beespace::c
