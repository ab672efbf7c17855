// What `watch` says last, on standard error.
#pragma once

#include "analysis/live/live_feed.hpp"
#include "cli/watch/live_advice.hpp"
#include "cli/watch/watch_request.hpp"
#include "cli/watch/watch_tally.hpp"
#include "io/frames/coordinate_frame.hpp"
#include "io/live/report_lines.hpp"
#include "io/recording/frozen_places.hpp"
#include "io/units/units.hpp"

#include <cstdint>
#include <string>

namespace beespace::cli {

struct WatchFacts {
  const WatchRequest& request;
  const io::ReportLines& lines;
  const WatchTally& tally;
  const LeftOutOfWatch& left_out;
  const analysis::LiveFeed* feed;  // null before the first report
  const LiveAdvice* advice;        // null where none was wanted
  std::uint64_t unadvised_looks;
  // Once there is a feed.
  io::Frame frame;
  io::Unit height_unit;
  const io::FrozenEnds& perhaps_frozen;
};

std::string watch_summary(const WatchFacts& facts);

}  // namespace beespace::cli
