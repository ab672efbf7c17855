// The lines of JSON that `watch` writes of what happens.
#pragma once

#include "analysis/live/live_feed.hpp"

#include <beespace/swarm.hpp>

#include <string>

namespace beespace::cli {

// A line of JSON, with its end. When it was said is told of what lies ahead: the rest is said when
// it is known.
std::string event_line(const SwarmEvent& event, double said_at_s, const analysis::LiveFeed& feed);
std::string clock_line(const analysis::ClockNote& note, const analysis::LiveFeed& feed);

// "predicted", "entered", "closest_passed", "left", "stale", ...
const char* name_of(EventKind kind);
// "bees", "pairs", "predicted", "possible".
const char* name_of(SwarmBound bound);

}  // namespace beespace::cli
