#include "report/recording_json.hpp"

#include "report/clock_offsets.hpp"
#include "report/fleet_json.hpp"
#include "report/quantised.hpp"
#include "report/shown_fixes.hpp"
#include "report/swarm_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::report {
namespace {

// What a page can hold and a browser can draw.
constexpr std::size_t kMostFixes = 6'000'000;
// Beyond so many fixes positions have fewer bits.
constexpr std::size_t kManyFixes = 2'000'000;

// Times as whole numbers of ticks.
class Clock {
 public:
  Clock(const TimeSpan& time, const ShownFixes& shown)
      : begins_s_(time.begins_s), tick_s_(tick_for(time, shown)) {}

  [[nodiscard]] Meaning meaning() const { return {tick_s_, 0.0}; }
  [[nodiscard]] std::uint32_t nearest(double time_s) const {
    return whole(std::round(ticks(time_s)));
  }
  [[nodiscard]] std::uint32_t before(double time_s) const {
    return whole(std::floor(ticks(time_s)));
  }
  [[nodiscard]] std::uint32_t after(double time_s) const { return whole(std::ceil(ticks(time_s))); }
  // How far a time is from the one it is told as.
  [[nodiscard]] double error_s(double time_s) const {
    return std::abs(tick_s_ * nearest(time_s) - (time_s - begins_s_));
  }

 private:
  [[nodiscard]] double ticks(double time_s) const { return (time_s - begins_s_) / tick_s_; }
  static std::uint32_t whole(double ticks) {
    return static_cast<std::uint32_t>(std::clamp(ticks, 0.0, kMostTicks));
  }

  // Most recordings have whole milliseconds, or microseconds: then ticks are regular, which costs
  // next to nothing. Of others milliseconds are enough, unless fixes are nearly as close.
  static double tick_for(const TimeSpan& time, const ShownFixes& shown) {
    const double lasts_s = time.ends_s - time.begins_s;
    const double exact_s = std::max(lasts_s / kMostTicks, 1e-9);
    for (const double tick_s : {1e-3, 1e-6}) {
      if (tick_s > exact_s && are_whole(shown.times_s, time.begins_s, tick_s)) return tick_s;
    }
    return exact_s < 1e-3 && shown.shortest_s > 1e-2 ? 1e-3 : exact_s;
  }

  static bool are_whole(const std::vector<double>& times_s, double begins_s, double tick_s) {
    return std::all_of(times_s.begin(), times_s.end(), [=](double time_s) {
      const double ticks = (time_s - begins_s) / tick_s;
      return std::abs(ticks - std::round(ticks)) < 1e-3;
    });
  }

  static constexpr double kMostTicks = 4'294'967'295.0;
  double begins_s_;
  double tick_s_;
};

// How far a bee may be from where it is shown because times are told in ticks: it is shown where it
// was no more than the largest error earlier, or later.
double flown_in_error_m(const ShownFixes& shown, const Clock& clock) {
  double farthest_m = 0.0;
  std::size_t next = 0;
  for (const std::uint32_t count : shown.counts) {
    double fastest_mps = 0.0;
    double error_s = 0.0;
    const std::size_t end = next + count;
    for (std::size_t i = next; i < end; ++i) {
      error_s = std::max(error_s, clock.error_s(shown.times_s[i]));
      if (i == next) continue;
      const double flown_m = distance(shown.positions[i - 1], shown.positions[i]);
      const double in_s = shown.times_s[i] - shown.times_s[i - 1];
      fastest_mps = std::max(fastest_mps, flown_m / in_s);
    }
    farthest_m = std::max(farthest_m, fastest_mps * error_s);
    next = end;
  }
  return farthest_m;
}

void write_fixes(io::JsonWriter& json, const ShownFixes& shown, const Quantised& positions,
                 const Clock& clock, Columns& columns) {
  std::vector<std::uint32_t> ticks;
  ticks.reserve(shown.times_s.size());
  for (const double time_s : shown.times_s) ticks.push_back(clock.nearest(time_s));
  json.begin_object("fixes");
  columns.add(json, "counts", shown.counts);
  columns.add(json, "time_s", ticks, Differences::kSecond, clock.meaning());
  write_positions(json, positions, Differences::kSecond, columns);
  json.end();
}

void write_conflicts(io::JsonWriter& json, const std::vector<Conflict>& conflicts,
                     const std::vector<Apart>& apart, const Clock& clock, Columns& columns) {
  std::array<std::vector<std::uint32_t>, 5> numbers;
  auto& [firsts, seconds, begins, closest, ends] = numbers;
  std::vector<double> distances_m;
  std::vector<std::uint8_t> certain;
  for (const Conflict& conflict : conflicts) {
    firsts.push_back(conflict.first);
    seconds.push_back(conflict.second);
    begins.push_back(clock.before(conflict.begins_s));
    closest.push_back(clock.nearest(conflict.closest_s));
    ends.push_back(clock.after(conflict.ends_s));
    distances_m.push_back(conflict.closest_m);
    certain.push_back(conflict.certain ? 1 : 0);
  }
  const auto add_times = [&](const char* name, const std::vector<std::uint32_t>& ticks) {
    columns.add(json, name, ticks, Differences::kNone, clock.meaning());
  };
  json.begin_object("conflicts");
  columns.add(json, "first", firsts);
  columns.add(json, "second", seconds);
  add_times("begins_s", begins);
  add_times("closest_s", closest);
  add_times("ends_s", ends);
  columns.add(json, "distance_m", distances_m);
  columns.add(json, "certain", certain);
  write_apart(json, apart, columns);
  json.end();
}

// Whole numbers of steps, and where they begin.
class Steps {
 public:
  Steps(const std::vector<double>& values, double step) : step_(step) {
    if (values.empty()) return;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    low_ = *low;
    step_ = std::max(step, (*high - *low) / 4e9);
  }
  [[nodiscard]] Meaning meaning() const { return {step_, low_}; }
  [[nodiscard]] std::vector<std::uint32_t> of(const std::vector<double>& values) const {
    std::vector<std::uint32_t> steps;
    steps.reserve(values.size());
    for (const double value : values) {
      steps.push_back(static_cast<std::uint32_t>(std::round((value - low_) / step_)));
    }
    return steps;
  }

 private:
  double low_ = 0.0;
  double step_;
};

// Lengths of ways, to a hundred-thousandth of the threshold.
void write_lengths(io::JsonWriter& json, const char* name, const std::vector<double>& lengths_m,
                   double threshold_m, Columns& columns) {
  const Steps steps(lengths_m, std::max(1e-9, 1e-5 * threshold_m));
  columns.add(json, name, steps.of(lengths_m), Differences::kSecond, steps.meaning());
}

void write_pair_ways(io::JsonWriter& json, const RecordingFacts& facts, double begins_s,
                     Columns& columns) {
  std::vector<std::uint32_t> counts;
  std::vector<double> times_s;
  std::array<std::vector<double>, 6> along;
  std::vector<double> heights_m;
  for (const PairWay& way : facts.pair_ways) {
    counts.push_back(static_cast<std::uint32_t>(way.times_s.size()));
    for (const double time_s : way.times_s) times_s.push_back(time_s - begins_s);
    for (const Point& p : way.ways) {
      along[0].push_back(p.x);
      along[1].push_back(p.y);
      along[2].push_back(p.z);
    }
    for (const Point& p : way.ground_ways) {
      along[3].push_back(p.x);
      along[4].push_back(p.y);
      along[5].push_back(p.z);
    }
    heights_m.insert(heights_m.end(), way.heights_m.begin(), way.heights_m.end());
  }
  json.begin_object("pair_ways");
  columns.add(json, "counts", counts);
  columns.add(json, "time_s", times_s);
  constexpr std::array<const char*, 6> kNames = {"x", "y", "z", "ground_x", "ground_y", "ground_z"};
  const bool on_earth = facts.swarm.origin.has_value();
  const double threshold_m = facts.swarm.threshold_m;
  for (std::size_t i = 0; i < (on_earth ? kNames.size() : 3); ++i) {
    write_lengths(json, kNames[i], along[i], threshold_m, columns);
  }
  if (on_earth) write_lengths(json, "height", heights_m, threshold_m, columns);
  json.end();
}

// Of one bee after the other.
void write_spans(io::JsonWriter& json, const char* name, const std::vector<AtRisk>& spans,
                 const Clock& clock, Columns& columns) {
  std::array<std::vector<std::uint32_t>, 3> numbers;
  auto& [bees, begins, ends] = numbers;
  for (const AtRisk& of : spans) {
    bees.push_back(of.bee);
    begins.push_back(clock.before(of.span.begins_s));
    ends.push_back(clock.after(of.span.ends_s));
  }
  json.begin_object(name);
  columns.add(json, "bee", bees, Differences::kFirst);
  columns.add(json, "begins_s", begins, Differences::kNone, clock.meaning());
  columns.add(json, "ends_s", ends, Differences::kNone, clock.meaning());
  json.end();
}

// When bees are there, and it is not known where.
void write_unknown(io::JsonWriter& json, const std::vector<Gap>& unknown, const Clock& clock,
                   Columns& columns) {
  if (unknown.empty()) return;
  std::vector<AtRisk> spans;
  spans.reserve(unknown.size());
  for (const Gap& gap : unknown) spans.push_back({gap.track, {gap.begins_s, gap.ends_s}});
  write_spans(json, "unknown", spans, clock, columns);
}

void write_open(io::JsonWriter& json, const std::vector<TimeSpan>& open, double begins_s,
                Columns& columns) {
  if (open.empty()) return;
  std::vector<double> begins;
  std::vector<double> ends;
  for (const TimeSpan& span : open) {
    begins.push_back(span.begins_s - begins_s);
    ends.push_back(span.ends_s - begins_s);
  }
  json.begin_object("open");
  columns.add(json, "begins_s", begins);
  columns.add(json, "ends_s", ends);
  json.end();
}

void write_separation(io::JsonWriter& json, const std::vector<Separation>& separation,
                      const std::vector<TimeSpan>& open, double begins_s, Columns& columns) {
  std::vector<double> times_s;
  std::vector<double> distances_m;
  std::vector<std::uint32_t> firsts;
  std::vector<std::uint32_t> seconds;
  std::vector<Apart> apart;
  for (const auto& [time_s, closest, of_pair] : separation) {
    if (of_pair) apart.push_back(*of_pair);
    times_s.push_back(time_s - begins_s);
    distances_m.push_back(closest.distance_m);
    firsts.push_back(closest.first);
    seconds.push_back(closest.second);
  }
  json.begin_object("separation");
  columns.add(json, "time_s", times_s);
  columns.add(json, "distance_m", distances_m);
  columns.add(json, "first", firsts);
  columns.add(json, "second", seconds);
  write_apart(json, apart, columns);
  write_open(json, open, begins_s, columns);
  json.end();
}

void write_closest(io::JsonWriter& json, const char* key, const Conflict& closest,
                   const std::optional<Apart>& apart, double begins_s) {
  json.begin_object(key);
  json.member("first", closest.first).member("second", closest.second);
  json.member("distance_m", closest.closest_m);
  json.member("time_s", closest.closest_s - begins_s);
  if (apart) write_apart(json, *apart);
}

void write_risk(io::JsonWriter& json, const RecordingFacts& facts, double begins_s) {
  double bee_seconds = 0.0;
  std::uint64_t bees = 0;
  for (std::size_t i = 0; i < facts.at_risk.size(); ++i) {
    const auto& [bee, span] = facts.at_risk[i];
    bee_seconds += span.ends_s - span.begins_s;
    if (i == 0 || facts.at_risk[i - 1].bee != bee) ++bees;
  }
  json.begin_object("risk");
  json.member("conflicts", facts.conflict_count).member("possible", facts.possible_count);
  json.member("pairs", facts.pair_count).member("bees", bees);
  json.member("bee_seconds", bee_seconds);
  if (facts.low_count > 0) json.member("left_out", facts.low_text);
  if (!facts.unknown.empty()) json.member("unknown", facts.unknown);
  if (facts.nowhere_count > 0) json.member("nowhere", facts.nowhere_count);
  if (facts.nothing_compared) json.member("nothing_compared", true);
  if (facts.closest) {
    write_closest(json, "closest", *facts.closest, facts.closest_apart, begins_s);
    // Or both do, which the closest in the air is told beside, too.
    if (facts.closest_stands || facts.closest_in_the_air) json.member("stands", true);
    json.end();
  }
  if (facts.closest_in_the_air) {
    write_closest(json, "closest_in_the_air", *facts.closest_in_the_air,
                  facts.closest_in_the_air_apart, begins_s);
    json.end();
  }
  json.end();
}

// What a clock shows that is not that of UTC.
void write_clock(io::JsonWriter& json, const io::Calendar& calendar, const TimeSpan& time) {
  json.begin_object("clock").member("dated", calendar.since_1970 || calendar.clock->dated);
  if (calendar.is_local()) json.member("zone", calendar.zone->name());
  json.begin_array("offsets");
  for (const ClockOffset& offset : clock_offsets(calendar, time)) {
    json.begin_object().member("from_s", offset.from_s - time.begins_s);
    json.member("ahead_s", offset.ahead_s).end();
  }
  json.end().end();
}

void write_time(io::JsonWriter& json, const RecordingFacts& facts, const TimeSpan& time) {
  const io::Calendar& calendar = facts.calendar;
  json.begin_object("time").member("begins_s", time.begins_s).member("ends_s", time.ends_s);
  json.member("since_1970", calendar.since_1970);
  if (calendar.is_local() || (!calendar.since_1970 && calendar.clock)) {
    write_clock(json, calendar, time);
  }
  json.end();
}

// How the limits of a drone show are kept.
void write_limits(io::JsonWriter& json, const RecordingFacts& facts, double begins_s) {
  json.begin_object("limits_kept").member("count", facts.excess_count);
  json.begin_array("greatest");
  for (const DeclaredLimit& limit : facts.declared) {
    json.begin_object().member("limit", limit.name).member("most", limit.most);
    json.member("value", limit.greatest).member("bee", limit.bee);
    json.member("time_s", limit.time_s - begins_s).end();
  }
  json.end().begin_array("excesses");
  for (const LimitExcess& excess : facts.excesses) {
    json.begin_object().member("limit", excess.limit).member("bee", excess.bee);
    json.member("begins_s", excess.span.begins_s - begins_s);
    json.member("ends_s", excess.span.ends_s - begins_s);
    json.member("value", excess.greatest).member("time_s", excess.time_s - begins_s).end();
  }
  json.end();
  if (!facts.not_looked_at.empty()) json.member("not_looked_at", facts.not_looked_at);
  json.end();
}

// What a drone show says of itself.
void write_show(io::JsonWriter& json, const RecordingFacts& facts, double begins_s) {
  const io::ShowLimits& limits = facts.limits;
  if (limits.any()) {
    json.begin_object("limits");
    if (limits.horizontal_mps) json.member("horizontal_mps", *limits.horizontal_mps);
    if (limits.climb_mps) json.member("climb_mps", *limits.climb_mps);
    if (limits.descent_mps) json.member("descent_mps", *limits.descent_mps);
    if (limits.height_m) json.member("height_m", *limits.height_m);
    json.end();
  }
  if (!facts.declared.empty() || !facts.not_looked_at.empty()) write_limits(json, facts, begins_s);
  if (facts.cues.empty()) return;
  json.begin_array("cues");
  for (const io::ShowCue& cue : facts.cues) {
    json.begin_object().member("time_s", cue.time_s - begins_s).member("name", cue.name).end();
  }
  json.end();
}

TimeSpan time_of(const ShownFixes& shown) {
  if (shown.times_s.empty()) return {};
  const auto [first, last] = std::minmax_element(shown.times_s.begin(), shown.times_s.end());
  return {*first, *last};
}

}  // namespace

void write_swarm(io::JsonWriter& json, const RecordingFacts& facts, Columns& columns) {
  const ShownFixes shown = shown_fixes(facts.tracks, facts.gaps, kMostFixes);
  const TimeSpan time = time_of(shown);
  const Clock clock(time, shown);
  const Quantised positions =
      quantised(shown.positions, shown.positions.size() > kManyFixes ? 14 : 16);
  SwarmFacts swarm = facts.swarm;
  if (shown.every > 1) {
    swarm.notes.push_back("one fix in " + std::to_string(shown.every) +
                          " is shown; what is said of conflicts comes from all");
  }
  json.begin_object().member("kind", "recording");
  write_facts(json, swarm, facts.tracks.size(), columns);
  json.member("position_error_m",
              positions.error_m + shown.error_m + flown_in_error_m(shown, clock) + facts.bend_m);
  write_time(json, facts, time);
  write_fixes(json, shown, positions, clock, columns);
  columns.add(json, "absent_after", shown.absent_after, Differences::kFirst);
  write_conflicts(json, facts.conflicts, facts.conflicts_apart, clock, columns);
  write_spans(json, "at_risk", facts.at_risk, clock, columns);
  write_unknown(json, facts.unknown_spans, clock, columns);
  write_pair_ways(json, facts, time.begins_s, columns);
  write_separation(json, facts.separation, facts.separation_open, time.begins_s, columns);
  write_risk(json, facts, time.begins_s);
  write_show(json, facts, time.begins_s);
  if (facts.fleet) write_fleet(json, *facts.fleet, time.begins_s, columns);
  json.end();
}

}  // namespace beespace::report
