#include "analysis/scene/fleet_facts.hpp"

#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

namespace beespace::analysis {
namespace {

// An agent is on one of the commands that were sent last.
constexpr std::size_t kLookedAt = 64;

// Where braking leads to after so many ticks, straight on. In each the velocity falls evenly, by
// the same; in the last one to zero.
Point braked(const Mover& from, double braking_mps2, double period_s, double ticks) {
  const Velocity& v = from.velocity;
  const double speed = std::hypot(v.x, v.y, v.z);
  if (speed == 0.0) return from.position;
  const double change_mps = braking_mps2 * period_s;
  const double whole = std::min(ticks, std::floor(speed / change_mps));
  double way_m = period_s * whole * (speed - 0.5 * change_mps * whole);
  if (ticks > whole) way_m += 0.5 * period_s * std::max(0.0, speed - change_mps * whole);
  const double share = way_m / speed;
  const Point& p = from.position;
  return {p.x + share * v.x, p.y + share * v.y, p.z + share * v.z};
}

Tick last_tick(const io::LoggedBranch& branch) {
  return branch.starts + static_cast<Tick>(branch.states.size()) - 1;
}

// Where it leads to at a tick; before its first state that one.
Point place_at(const io::LoggedBranch& branch, Tick tick, double period_s) {
  if (tick <= branch.starts) return branch.states.front().position;
  const Tick last = last_tick(branch);
  if (tick < last) {
    return branch.states[static_cast<std::size_t>(tick - branch.starts)].position;
  }
  return braked(branch.states.back(), branch.braking_mps2, period_s,
                static_cast<double>(tick - last));
}

// Planner and this compute alike, but for the rounding.
bool is_there(const Point& a, const Point& b) {
  const double size = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) <= 1e-6 + 1e-12 * size;
}

// The base of a status: the newest branch that was sent and leads to where the agent shall be. One
// that was ruled out has departed, and leads elsewhere.
std::optional<std::uint32_t> newest_of(const io::LoggedStatus& status, const io::LoggedAgent& agent,
                                       double period_s) {
  const std::size_t oldest = status.sent - std::min(status.sent, kLookedAt);
  for (std::size_t i = status.sent; i > oldest; --i) {
    const Point place = place_at(agent.branches[i - 1], status.tick, period_s);
    if (is_there(place, status.told.nominal.position)) return static_cast<std::uint32_t>(i - 1);
  }
  return std::nullopt;
}

report::FleetBranch branch_of(const io::LoggedAgent& agent, std::size_t number, double period_s) {
  const io::LoggedBranch& branch = agent.branches[number];
  const Mover& last = branch.states.back();
  report::FleetBranch found;
  found.at = last_tick(branch);
  found.place = last.position;
  found.stop = braked(last, branch.braking_mps2, period_s, std::numeric_limits<double>::infinity());
  const Velocity& v = last.velocity;
  found.braking_s = std::hypot(v.x, v.y, v.z) / branch.braking_mps2;
  // Their numbers ascend.
  const auto before = agent.branches.begin() + static_cast<std::ptrdiff_t>(number);
  const auto parent = std::lower_bound(
      agent.branches.begin(), before, branch.parent,
      [](const io::LoggedBranch& one, BranchNumber wanted) { return one.number < wanted; });
  if (parent != before && parent->number == branch.parent) {
    found.parent = static_cast<std::uint32_t>(parent - agent.branches.begin());
  }
  return found;
}

report::FleetBee bee_of(const io::LoggedAgent& agent, double period_s) {
  report::FleetBee bee;
  for (std::size_t i = 0; i < agent.branches.size(); ++i) {
    bee.branches.push_back(branch_of(agent, i, period_s));
  }
  for (const io::LoggedStatus& status : agent.statuses) {
    const AgentGuidance& told = status.told;
    bee.states.push_back({status.tick, told.nominal.position, told.tube_m, told.contract,
                          told.reason, told.certified, told.branches,
                          newest_of(status, agent, period_s)});
  }
  return bee;
}

struct Span {
  double begins_s = std::numeric_limits<double>::infinity();
  double ends_s = -std::numeric_limits<double>::infinity();

  void add(double time_s) {
    begins_s = std::min(begins_s, time_s);
    ends_s = std::max(ends_s, time_s);
  }
  [[nodiscard]] std::string text() const {
    return io::exact(begins_s) + " to " + io::exact(ends_s) + " s";
  }
};

Error not_of_this(const io::FleetLog& log, std::string message) {
  return {ErrorCode::kMalformedRecord, std::move(message), {.source = log.source}};
}

Status check_times(const io::FleetLog& log, const std::vector<Track>& tracks) {
  Span flown;
  for (const Track& track : tracks) {
    for (const Fix& fix : track.fixes) flown.add(fix.time_s);
  }
  Span told;
  for (const io::LoggedAgent& agent : log.agents) {
    for (const io::LoggedStatus& status : agent.statuses) {
      told.add(static_cast<double>(status.tick) * log.period_s);
    }
  }
  if (told.begins_s <= flown.ends_s && flown.begins_s <= told.ends_s) return std::monostate{};
  return not_of_this(log, "this log is of the times from " + told.text() +
                              " (ticks times their period), and the recording of those from " +
                              flown.text() +
                              "; give the log of the same flight, by the same clock");
}

Status check_fits(const io::FleetLog& log, io::Frame frame, const std::vector<Track>& tracks) {
  if (frame != io::Frame::kMetres) {
    return not_of_this(log,
                       "the recording is in degrees, and a log of a fleet in the metres of its "
                       "planner; give the recording in these, with --crs where that must be said");
  }
  std::size_t states = 0;
  for (const io::LoggedAgent& agent : log.agents) states += agent.statuses.size();
  if (states > kMostFleetStates) {
    return Error{ErrorCode::kTooManyPoints,
                 "this log says " + io::grouped(std::uint64_t{states}) +
                     " times where an agent shall be, and a page holds " +
                     io::grouped(std::uint64_t{kMostFleetStates}) +
                     "; give a part of it: fewer agents, or a shorter time",
                 {.source = log.source}};
  }
  return check_times(log, tracks);
}

}  // namespace

Result<report::FleetFacts> fleet_facts(const io::FleetLog& log, const io::Recording& recording,
                                       const std::vector<Track>& tracks, bool skip_bad,
                                       std::vector<std::string>& notes) {
  if (Status fits = check_fits(log, recording.frame, tracks); !fits) return std::move(fits).error();
  std::unordered_map<std::string, std::size_t> bees;
  for (std::size_t i = 0; i < recording.bees.size(); ++i) bees.emplace(recording.bees[i].id, i);
  report::FleetFacts facts;
  facts.title = std::filesystem::path(log.source).filename().string();
  facts.period_s = log.period_s;
  facts.bees.resize(recording.bees.size());
  std::uint64_t lacking = 0;
  for (const io::LoggedAgent& agent : log.agents) {
    const auto found = bees.find(agent.id);
    if (found != bees.end()) {
      facts.bees[found->second] = bee_of(agent, log.period_s);
      continue;
    }
    ++lacking;
    if (skip_bad) continue;
    Error error = not_of_this(log, "agent '" + agent.id +
                                       "' is not in the recording; give the recording of the same "
                                       "flight, with the ids of its log, or --skip-bad to leave "
                                       "such agents out");
    error.location.line = agent.line;
    return error;
  }
  if (lacking > 0) {
    notes.push_back("agents of the fleet's log that the recording lacks, left out: " +
                    io::grouped(lacking));
  }
  if (log.skipped > 0) {
    notes.push_back("bad lines of the fleet's log left out: " + io::grouped(log.skipped));
  }
  return facts;
}

}  // namespace beespace::analysis
