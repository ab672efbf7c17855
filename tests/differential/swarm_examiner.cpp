// Recordings reported to a Swarm one fix after the other, with calls at random times: its events
// against the oracle for recordings. A pair enters at the threshold and leaves at the wider one: so
// each stretch of conflict by the wider one in which they come closer than the threshold is one
// encounter.
#include "tests/differential/described.hpp"
#include "tests/differential/examiner.hpp"
#include "tests/differential/recording_oracle.hpp"
#include "tests/differential/recording_scenes.hpp"
#include "tests/differential/shrink.hpp"

#include <beespace/swarm.hpp>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

namespace beespace::differential {

namespace {

using Events = std::vector<SwarmEvent>;

struct ReportedRecording {
  RecordingScene scene;
  double leave_factor = 1.0;
  double max_age_s = 1.0;
  double waits_s = 0.0;         // from the last report until nothing more is waited for
  std::uint64_t asks_seed = 0;  // of when advance() is called
  unsigned threads = 1;

  [[nodiscard]] SwarmOptions swarm_options() const {
    SwarmOptions options;
    options.threshold_m = scene.options.threshold_m;
    options.vertical_m = scene.options.vertical_m;
    options.heights_apart =
        std::any_of(scene.tracks.begin(), scene.tracks.end(),
                    [](const Track& track) { return !track.heights_m.empty(); });
    options.leave_factor = leave_factor;
    options.max_age_s = max_age_s;
    options.horizon_s = 0.0;
    options.threads = threads;
    return options;
  }
  [[nodiscard]] ConflictOptions limits(double factor) const {
    ConflictOptions options;
    options.threshold_m = scene.options.threshold_m * factor;
    if (scene.options.vertical_m) options.vertical_m = *scene.options.vertical_m * factor;
    options.max_gap_s = max_age_s;
    return options;
  }
  [[nodiscard]] double ends_s() const {
    double last = -std::numeric_limits<double>::infinity();
    for (const Track& track : scene.tracks) {
      if (!track.fixes.empty()) last = std::max(last, track.fixes.back().time_s);
    }
    return std::min(last + waits_s, kLargestInMotion);
  }
};

Result<Events> events_of(const ReportedRecording& reported) {
  std::vector<PositionReport> reports;
  for (PointId id = 0; id < reported.scene.tracks.size(); ++id) {
    const Track& track = reported.scene.tracks[id];
    for (std::size_t i = 0; i < track.fixes.size(); ++i) {
      PositionReport report{id, track.fixes[i].time_s, track.fixes[i].position};
      if (!track.heights_m.empty()) report.height_m = track.heights_m[i];
      reports.push_back(report);
    }
  }
  std::stable_sort(
      reports.begin(), reports.end(),
      [](const PositionReport& a, const PositionReport& b) { return a.time_s < b.time_s; });
  if (reports.empty()) return Events{};
  Swarm swarm(reported.swarm_options());
  Random asks(reported.asks_seed, 0);
  Events events;
  const auto take = [&](const Result<Events>& more) -> std::optional<Error> {
    if (!more) return more.error();
    events.insert(events.end(), more->begin(), more->end());
    return std::nullopt;
  };
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const Status taken = swarm.update(reports[i]);
    if (!taken) return taken.error();
    const bool all_of_this_time =
        i + 1 == reports.size() || reports[i].time_s < reports[i + 1].time_s;
    if (!all_of_this_time || !asks.coin()) continue;
    if (auto error = take(swarm.advance(reports[i].time_s))) return *error;
  }
  if (auto error = take(swarm.finish(reported.ends_s()))) return *error;
  return events;
}

bool falls_silent(const Track& track, double time_s, const ReportedRecording& reported) {
  for (std::size_t i = 0; i < track.fixes.size(); ++i) {
    if (track.fixes[i].time_s != time_s) continue;
    const bool last = i + 1 == track.fixes.size();
    return (last ? reported.ends_s() : track.fixes[i + 1].time_s) - time_s > reported.max_age_s;
  }
  return false;
}

std::string fault_of_pair(const ReportedRecording& reported, PointId i, PointId j,
                          const Events& events) {
  Events entered;
  Events over;
  for (const SwarmEvent& event : events) {
    if (event.first != i || event.second != j) continue;
    if (event.kind == EventKind::kEntered) entered.push_back(event);
    if (event.kind == EventKind::kLeft || event.kind == EventKind::kLost ||
        event.kind == EventKind::kEnded) {
      over.push_back(event);
    }
  }
  const auto earlier = [](const SwarmEvent& a, const SwarmEvent& b) { return a.time_s < b.time_s; };
  std::stable_sort(entered.begin(), entered.end(), earlier);
  std::stable_sort(over.begin(), over.end(), earlier);
  const Track& first = reported.scene.tracks[i];
  const Track& second = reported.scene.tracks[j];
  const ConflictOptions enter = reported.limits(1.0);
  const ConflictOptions leave = reported.limits(reported.leave_factor);
  const PairOracle inner(first, second, enter);
  const PairOracle outer(first, second, leave);
  const std::vector<Stretch> inside = inner.stretches();
  std::size_t encounters = 0;
  for (const Stretch& stretch : outer.stretches()) {
    const bool any = std::any_of(inside.begin(), inside.end(), [&](const Stretch& one) {
      return one.first_cut >= stretch.first_cut && one.last_cut <= stretch.last_cut;
    });
    if (!any) continue;
    if (encounters == entered.size()) return "an event of entering is missing";
    if (encounters == over.size()) return "an event of leaving is missing";
    const SwarmEvent& in = entered[encounters];
    const SwarmEvent& out = over[encounters];
    ++encounters;
    std::string fault = inner.fault_at(in.time_s, in.distance_m);
    if (!fault.empty()) return "entered: " + fault;
    fault = outer.fault_at(out.time_s, out.distance_m);
    if (!fault.empty()) return "over: " + fault;
    EventKind kind = EventKind::kLeft;
    if (stretch.cut_off) {
      const double at = outer.cut_s(stretch.last_cut);
      const bool silent = falls_silent(first, at, reported) || falls_silent(second, at, reported);
      kind = silent ? EventKind::kLost : EventKind::kEnded;
      if (out.time_s != at) return "it does not end at the last report";
    }
    if (out.kind != kind) return "left, lost and ended are mistaken for each other";
  }
  if (entered.size() != encounters) return "entered once too often";
  if (over.size() != encounters) return "left, lost or ended once too often";
  return "";
}

std::string fault_of(const ReportedRecording& reported) {
  const auto events = events_of(reported);
  if (!events) return to_string(events.error());
  for (PointId i = 0; i < reported.scene.tracks.size(); ++i) {
    for (PointId j = i + 1; j < reported.scene.tracks.size(); ++j) {
      const std::string fault = fault_of_pair(reported, i, j, *events);
      if (fault.empty()) continue;
      return std::to_string(i) + "-" + std::to_string(j) + ": " + fault;
    }
  }
  return "";
}

std::string text_of(const ReportedRecording& reported) {
  char text[200];
  std::snprintf(
      text, sizeof text,
      "leaves at %a times the threshold, stale after %a s, finished after %a s, asks %llu\n",
      reported.leave_factor, reported.max_age_s, reported.waits_s,
      static_cast<unsigned long long>(reported.asks_seed));
  std::string all = text + differential::text_of(reported.scene);
  const auto events = events_of(reported);
  if (!events) return all;
  for (const SwarmEvent& e : *events) {
    std::snprintf(text, sizeof text, "  event %d of %llu-%llu at %a s, %a m\n",
                  static_cast<int>(e.kind), static_cast<unsigned long long>(e.first),
                  static_cast<unsigned long long>(e.second), e.time_s, e.distance_m);
    all += text;
  }
  return all;
}

double some_time_between_fixes(const RecordingScene& scene, Random& random) {
  std::vector<double> times = {1.0};
  for (const Track& track : scene.tracks) {
    for (std::size_t i = 1; i < track.fixes.size(); ++i) {
      times.push_back(track.fixes[i].time_s - track.fixes[i - 1].time_s);
    }
  }
  return random.one_of(times);
}

std::optional<std::string> examine(Random& random, Tally& tally) {
  tally.scene();
  ReportedRecording reported{random_recording(random)};
  // Between two times from fix to fix: it is not the question here how differences round.
  reported.max_age_s = some_time_between_fixes(reported.scene, random) * random.between(1.01, 1.9);
  if (random.coin()) reported.max_age_s *= 1e6;
  reported.max_age_s = std::clamp(reported.max_age_s, kSmallestInMotion, kLargestInMotion);
  reported.leave_factor = random.coin() ? 1.1 : 1.0 + random.whole(0, 2) * 0.5;
  reported.waits_s = reported.max_age_s * (random.coin() ? 0.25 : 2.5);
  reported.asks_seed = random.next();
  reported.threads = random.once_in(8) ? 3 : 1;
  if (reported.scene.tracks.empty() || !(reported.ends_s() > -1e300)) return std::nullopt;
  tally.answer(reported.scene.options.vertical_m ? "events, vertical" : "events");
  if (fault_of(reported).empty()) return std::nullopt;
  reported.scene.tracks = shrunk(reported.scene.tracks, [&](const std::vector<Track>& tracks) {
    ReportedRecording less = reported;
    less.scene.tracks = tracks;
    return !fault_of(less).empty();
  });
  return "Swarm, " + text_of(reported) + "  " + fault_of(reported) + "\n";
}

}  // namespace

Examiner swarm_examiner() {
  return {"swarms", examine};
}

}  // namespace beespace::differential
