#include "c/live/events.hpp"

#include "c/door/agents.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace beespace::c {

namespace {

// C++ may number these anew; C may not. The compiler names one that is missing here.
std::int32_t number_of(EventKind kind) {
  switch (kind) {
    case EventKind::kPredicted:
      return BEESPACE_EVENT_PREDICTED;
    case EventKind::kPossible:
      return BEESPACE_EVENT_POSSIBLE;
    case EventKind::kHeard:
      return BEESPACE_EVENT_HEARD;
    case EventKind::kEntered:
      return BEESPACE_EVENT_ENTERED;
    case EventKind::kClosestPassed:
      return BEESPACE_EVENT_CLOSEST_PASSED;
    case EventKind::kLeft:
      return BEESPACE_EVENT_LEFT;
    case EventKind::kStale:
      return BEESPACE_EVENT_STALE;
    case EventKind::kLost:
      return BEESPACE_EVENT_LOST;
    case EventKind::kEnded:
      return BEESPACE_EVENT_ENDED;
    case EventKind::kOverloaded:
      return BEESPACE_EVENT_OVERLOADED;
  }
  return -1;
}

std::int32_t number_of(SwarmBound bound) {
  switch (bound) {
    case SwarmBound::kNone:
      return BEESPACE_BOUND_NONE;
    case SwarmBound::kAgents:
      return BEESPACE_BOUND_AGENTS;
    case SwarmBound::kPairs:
      return BEESPACE_BOUND_PAIRS;
    case SwarmBound::kPredicted:
      return BEESPACE_BOUND_PREDICTED;
    case SwarmBound::kPossible:
      return BEESPACE_BOUND_POSSIBLE;
  }
  return -1;
}

constexpr std::array<const char*, kEventKinds> kEventNames = {
    "predicted", "possible", "heard", "entered", "closest_passed",
    "left",      "stale",    "lost",  "ended",   "overloaded"};
constexpr std::array<const char*, kSwarmBounds> kBoundNames = {"none", "agents", "pairs",
                                                               "predicted", "possible"};

template <std::size_t Size>
const char* name_of(std::int32_t number, const std::array<const char*, Size>& names) {
  const auto at = static_cast<std::size_t>(number);
  return number < 0 || at >= Size ? "unknown" : names[at];
}

bool has_silence(EventKind kind) {
  return kind == EventKind::kHeard || kind == EventKind::kStale || kind == EventKind::kLost ||
         kind == EventKind::kPossible;
}

bool has_agents(const SwarmEvent& event) {
  return event.kind != EventKind::kOverloaded || event.bound == SwarmBound::kAgents;
}

}  // namespace

void write_events(std::span<const SwarmEvent> from, beespace_events& into) {
  into.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const SwarmEvent& event = from[i];
    into.kinds[i] = number_of(event.kind);
    into.times_s[i] = event.time_s;
    into.first[i] = has_agents(event) ? agent_number_of(event.first) : 0;
    into.second[i] = has_agents(event) ? agent_number_of(event.second) : 0;
    into.distances_m[i] = event.distance_m;
    into.closest_s[i] = event.closest_s;
    into.since_s[i] =
        has_silence(event.kind) ? event.since_s : std::numeric_limits<double>::quiet_NaN();
    into.left_out[i] = static_cast<std::int64_t>(event.count);
    into.bounds[i] = number_of(event.bound);
  }
}

}  // namespace beespace::c

void beespace_events::resize(std::size_t size) {
  kinds.resize(size);
  times_s.resize(size);
  first.resize(size);
  second.resize(size);
  distances_m.resize(size);
  closest_s.resize(size);
  since_s.resize(size);
  left_out.resize(size);
  bounds.resize(size);
}

extern "C" {

const char* beespace_event_name(int32_t kind) {
  return beespace::c::name_of(kind, beespace::c::kEventNames);
}

const char* beespace_bound_name(int32_t bound) {
  return beespace::c::name_of(bound, beespace::c::kBoundNames);
}

beespace_events* beespace_events_create(void) {
  try {
    return new beespace_events;
  } catch (...) {
    return nullptr;
  }
}

void beespace_events_free(beespace_events* events) {
  delete events;
}

int64_t beespace_events_size(const beespace_events* events) {
  return events == nullptr ? 0 : static_cast<int64_t>(events->kinds.size());
}

const int32_t* beespace_events_kinds(const beespace_events* events) {
  return events == nullptr ? nullptr : events->kinds.data();
}

const double* beespace_events_times_s(const beespace_events* events) {
  return events == nullptr ? nullptr : events->times_s.data();
}

const int64_t* beespace_events_first(const beespace_events* events) {
  return events == nullptr ? nullptr : events->first.data();
}

const int64_t* beespace_events_second(const beespace_events* events) {
  return events == nullptr ? nullptr : events->second.data();
}

const double* beespace_events_distances_m(const beespace_events* events) {
  return events == nullptr ? nullptr : events->distances_m.data();
}

const double* beespace_events_closest_s(const beespace_events* events) {
  return events == nullptr ? nullptr : events->closest_s.data();
}

const double* beespace_events_since_s(const beespace_events* events) {
  return events == nullptr ? nullptr : events->since_s.data();
}

const int64_t* beespace_events_left_out(const beespace_events* events) {
  return events == nullptr ? nullptr : events->left_out.data();
}

const int32_t* beespace_events_bounds(const beespace_events* events) {
  return events == nullptr ? nullptr : events->bounds.data();
}

}  // extern "C"
