// Reports whose places are none: zeros that are written where no place is known, and places that a
// bee must have left by its own speed. Judged by the reports before.
#pragma once

#include "io/live/report_lines.hpp"
#include "io/recording/stale_places.hpp"
#include "io/recording/zero_places.hpp"

#include <beespace/swarm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

class NoPlaces {
 public:
  // What such a report says, as a phrase; nothing where it says a place.
  std::optional<std::string> zero(const io::ReportLine& at);
  // The same of a bee that is known: `time_s` is when it was.
  std::optional<std::string> stale(AgentId bee, double time_s, const io::ReportLine& at);
  void forget(AgentId bee);

 private:
  io::ZeroPlaces zeros_;
  std::vector<io::StalePlaces> stale_;  // by number
};

}  // namespace beespace::cli
