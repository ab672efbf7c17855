// One run of a search: its threads, and who may end it.
#pragma once

#include <beespace.h>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <functional>
#include <stop_token>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_stop {
  std::stop_source source;
};

namespace beespace::c {

// As C++ counts them: 0 is one for each processor.
unsigned threads_of(std::uint32_t threads);

using WatchedWork = std::function<Status(const RunOptions&)>;

// Calls work() with what `run` says. Where it has a poll, work() runs on a thread of its own, and
// the calling one asks the poll from time to time, until work() has returned. What work() throws is
// thrown here.
Status call_watched(const beespace_run* run, const WatchedWork& work);

}  // namespace beespace::c
