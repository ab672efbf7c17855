#include "io/recording/recording_assembly.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/names_apart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace beespace::io {
namespace {

// Whether two or more of them lie in between.
bool are_several(const std::set<double>& times_s, const TimeSpan& between) {
  if (!(between.begins_s < between.ends_s)) return false;
  const auto first = times_s.upper_bound(between.begins_s);
  const auto behind = times_s.lower_bound(between.ends_s);
  return first != behind && std::next(first) != behind;
}

// What to do where two have one id. Vehicles say their numbers themselves.
std::string_view own_id_advice(std::string_view description) {
  if (description.starts_with("MAVLink")) {
    return "give each vehicle a number of its own (MAV_SYS_ID of PX4, SYSID_THISMAV or MAV_SYSID "
           "of ArduPilot), and of this flight read the logs of the vehicles themselves (.ulg, "
           ".bin)";
  }
  return "give each an id of its own, in a column that --columns id=... names, or in a file of its "
         "own";
}

}  // namespace

WallClock RecordingAssembly::common_clock(const WallClock& clock) const {
  const bool known = facts_ && facts_->clock && facts_->clock->dated == clock.dated;
  return known ? *facts_->clock : clock;
}

void RecordingAssembly::note(std::string text) {
  auto& notes = recording_.notes;
  if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(std::move(text));
}

std::string RecordingAssembly::name_of_source(std::string stem) {
  if (named_sources_ == sources_.size()) return source_stem_;
  named_sources_ = sources_.size();
  const auto apart = names_apart_.find(sources_.back());
  source_stem_ = apart != names_apart_.end() ? apart->second : std::move(stem);
  if (stems_.insert(source_stem_).second) return source_stem_;
  source_stem_ = sources_.back();
  for (std::size_t number = 2; !stems_.insert(source_stem_).second; ++number) {
    source_stem_ = sources_.back() + "#" + std::to_string(number);
  }
  return source_stem_;
}

void RecordingAssembly::expect_sources(const std::vector<std::string>& sources) {
  names_apart_.merge(names_apart(sources));
}

bool RecordingAssembly::goes_back(std::string_view id, double time_s) {
  double& last_s = times_of_day_s_.try_emplace(std::string(id), time_s).first->second;
  if (time_s < last_s) return true;
  last_s = time_s;
  return false;
}

std::optional<double> RecordingAssembly::set_back_by(std::string_view id, double time_s) {
  constexpr double kDay_s = 86'400.0;
  constexpr double kHour_s = 3'600.0;
  constexpr double kLatest_s = 4.0 * kHour_s;  // no zone sets its clocks back later in the night
  constexpr double kStepsDiffer_s = 120.0;
  constexpr std::uint64_t kInOrder = 3;  // so that a table in no order is none
  auto at = clock_times_.find(id);
  if (at == clock_times_.end()) at = clock_times_.try_emplace(std::string(id)).first;
  ClockTime& clock = at->second;
  const double back_s = clock.last_s - time_s;
  if (clock.in_order == 0 || back_s <= 0.0) {
    clock.step_s = clock.in_order == 0 ? 0.0 : -back_s;
    clock.last_s = time_s;
    ++clock.in_order;
    return std::nullopt;
  }
  // Where it goes on at the same pace, an hour was set back; or else it is most of one.
  const bool goes_on = std::abs(back_s + clock.step_s - kHour_s) <= kStepsDiffer_s;
  const bool is_long = (back_s >= 0.5 * kHour_s && back_s < kHour_s) || goes_on;
  const bool at_night = time_s - std::floor(time_s / kDay_s) * kDay_s < kLatest_s;
  if (is_long && at_night && clock.in_order >= kInOrder) return back_s;
  clock.last_s = time_s;
  clock.in_order = 1;
  return std::nullopt;
}

void RecordingAssembly::miss(std::uint64_t records, std::string_view id) {
  missing_ += records;
  if (id.empty()) {
    missing_without_id_ += records;
  } else if (missing_known_.emplace(id).second) {
    missing_ids_.emplace_back(id);
  }
}

void RecordingAssembly::leave_out(const LeftOutReason& reason, std::string_view id) {
  left_out_.add(reason);
  if (!reason.harmless) miss(1, id);
  if (reason.which == kUnknownHeight.which) heightless_.take(id);
}

void RecordingAssembly::take_rough(std::string_view id) {
  ++rough_records_;
  rough_ids_.emplace(id);
}

void RecordingAssembly::leave_file_out(std::string_view name) {
  MissingRecords& missing = recording_.missing;
  ++missing.files;
  if (missing.file_names.size() < MissingRecords::kMostNamed) missing.file_names.emplace_back(name);
}

void RecordingAssembly::leave_broken_file_out(Error error) {
  leave_file_out(error.location.source);
  ++recording_.skipped_count;
  if (recording_.skipped.size() < kMostSkippedListed) {
    recording_.skipped.push_back(std::move(error));
  }
}

void RecordingAssembly::settle_claim(const std::string& id, const GroundClaims::Run& run) {
  for (std::uint64_t i = 0; i < run.claims && !run.landed; ++i) {
    leave_out(run.in_flight ? kGroundInFlight : kOnGround, id);
  }
  if (!run.in_flight) grounded_[id].push_back(run);
}

void RecordingAssembly::settle_ground(RecordedBee& bee) const {
  const auto known = grounded_.find(bee.id);
  if (known == grounded_.end() || bee.fixes.empty()) return;
  for (const GroundClaims::Run& run : known->second) {
    if (!run.surely_ground) continue;
    if (run.landed) bee.landed.push_back({run.begins_s, run.ends_s});
    const double first_s = bee.fixes.front().time_s;
    const double last_s = bee.fixes.back().time_s;
    if (run.begins_s <= first_s) {
      auto& until_s = bee.on_ground_until_s;
      until_s = std::max(until_s.value_or(run.ends_s), std::min(run.ends_s, first_s));
      until_s = std::min(*until_s, first_s);
    }
    if (run.ends_s >= last_s) {
      auto& from_s = bee.on_ground_from_s;
      const double begins_s = std::max(run.begins_s, last_s);
      from_s = std::min(from_s.value_or(begins_s), begins_s);
    }
  }
  // Files may come in another order than their times, so that a run may be cut into several, some
  // of which are too short to be sure by themselves.
  for (const GroundClaims::Run& run : known->second) {
    if (!bee.on_ground_from_s || run.ends_s < *bee.on_ground_from_s) continue;
    auto& heard_s = bee.on_ground_heard_s;
    heard_s = std::max(heard_s.value_or(run.ends_s), run.ends_s);
  }
  std::sort(bee.landed.begin(), bee.landed.end(),
            [](const TimeSpan& a, const TimeSpan& b) { return a.begins_s < b.begins_s; });
}

void RecordingAssembly::claim(std::string_view id, const Fix& fix, GroundClaim claims) {
  claims_.take(id, fix, claims, facts_ ? facts_->frame : Frame::kWgs84,
               [this](const auto&... of) { settle_claim(of...); });
}

void RecordingAssembly::flies_at(std::string_view id, const Fix& fix) {
  claim(id, fix, GroundClaim::kNone);
}

void RecordingAssembly::heard_of(const LeftOutReason& reason, std::string_view id) {
  heard_.emplace_back(reason, id);
}

void RecordingAssembly::written_at(double time_s) {
  recording_.written_s = std::max(time_s, recording_.written_s.value_or(time_s));
}

void RecordingAssembly::unplaced(std::string_view id, double time_s) {
  std::set<double>& times_s = unplaced_[std::string(id)];
  times_s.insert(times_s.end(), time_s);  // nearly always the last one
  positionless(id, time_s);
}

void RecordingAssembly::positionless(std::string_view id, double time_s) {
  if (options_.sector) positionless_[std::string(id)].insert(time_s);
}

void RecordingAssembly::settle_beside(RecordedBee& bee) const {
  const auto known = positionless_.find(bee.id);
  if (known == positionless_.end() || bee.fixes.empty()) return;
  for (const double time_s : known->second) {
    const bool within = time_s >= bee.fixes.front().time_s && time_s <= bee.fixes.back().time_s;
    if (!within) bee.beside_s.push_back(time_s);
  }
}

bool RecordingAssembly::is_lost_between(const std::string& id, const TimeSpan& fixes) const {
  if (unplaced_.empty()) return false;
  const auto known = unplaced_.find(id);
  if (known == unplaced_.end()) return false;
  return are_several(known->second, fixes);
}

std::optional<TimeSpan> RecordingAssembly::unplaced_span(const std::string& id) const {
  const auto known = unplaced_.find(id);
  if (known == unplaced_.end() || known->second.size() < 2) return std::nullopt;
  return TimeSpan{*known->second.begin(), *known->second.rbegin()};
}

void RecordingAssembly::settle_unplaced(RecordedBee& bee) {
  const auto known = unplaced_.find(bee.id);
  if (known == unplaced_.end()) return;
  const std::set<double>& times_s = known->second;
  bee.unplaced_from_s = *times_s.begin();
  bee.unplaced_until_s = *times_s.rbegin();
  for (std::size_t i = 1; i < bee.fixes.size(); ++i) {
    const TimeSpan between{bee.fixes[i - 1].time_s, bee.fixes[i].time_s};
    if (are_several(times_s, between)) bee.lost.push_back(between);
  }
  if (const auto lost = lost_.find(bee.id); lost != lost_.end()) {
    bee.lost.insert(bee.lost.end(), lost->second.begin(), lost->second.end());
    std::sort(bee.lost.begin(), bee.lost.end(),
              [](const TimeSpan& a, const TimeSpan& b) { return a.begins_s < b.begins_s; });
    bee.lost.erase(std::unique(bee.lost.begin(), bee.lost.end()), bee.lost.end());
  }
}

void RecordingAssembly::settle_label(RecordedBee& bee) {
  auto& called = bee.called;
  std::stable_sort(called.begin(), called.end(),
                   [](const auto& a, const auto& b) { return a.since_s < b.since_s; });
  const auto same = [](const auto& a, const auto& b) { return a.label == b.label; };
  called.erase(std::unique(called.begin(), called.end(), same), called.end());
  constexpr std::size_t kMostNamed = 3;
  for (std::size_t i = 0; i < called.size(); ++i) {
    if (i == kMostNamed) bee.label += ", ...";
    if (i < kMostNamed) bee.label += (i > 0 ? ", " : "") + called[i].label;
  }
  if (called.size() < 2) called.clear();
}

void RecordingAssembly::settle_heard() {
  std::unordered_set<std::string> said;
  for (const auto& [reason, id] : heard_) {
    if (!tracks_.contains(id) && said.insert(id).second) leave_out(reason, id);
  }
  heard_.clear();
}

void RecordingAssembly::share(const SharedTrack& track) {
  MissingRecords& missing = recording_.missing;
  shared_ids_.insert(track.id);
  if (++missing.shared > MissingRecords::kMostNamed) return;
  missing.shared_ids.push_back(track.id);
  note("bee " + excerpt(track.id) + " is at two places in turn, from " + place_text(track.first) +
       " on, " + moment_text(track.time_s, recording_) +
       ", as if two or more had this id: where they are is not known; " +
       std::string(own_id_advice(facts_ ? facts_->description : std::string())));
}

void RecordingAssembly::jump(const SharedTrack& track) {
  MissingRecords& missing = recording_.missing;
  if (++missing.jumping > MissingRecords::kMostNamed) return;
  missing.jumping_ids.push_back(track.id);
  note("bee " + excerpt(track.id) + " jumps to where it is in " + place_text(track.first) + ", " +
       moment_text(track.time_s, recording_) +
       ", faster than anything that flies, than it says itself, or, there and back, than it ever "
       "moves elsewhere: a place or a time is wrong, and where it is is not known; correct such "
       "records, or leave them out");
}

std::optional<Error> RecordingAssembly::bad(Error error, std::string_view id) {
  if (error.location.source.empty()) error.location.source = sources_.back();
  if (!options_.skip_bad) return error;
  ++recording_.skipped_count;
  miss(1, id);
  if (recording_.skipped.size() < kMostSkippedListed) {
    const std::size_t advice = error.message.rfind(kOrLeaveOut);
    if (advice != std::string::npos) error.message.erase(advice, kOrLeaveOut.size());
    recording_.skipped.push_back(std::move(error));
  }
  return std::nullopt;
}

void RecordingAssembly::declare_threshold(double metres) {
  auto& declared = recording_.declared_threshold_m;
  if (declared && *declared != metres) {
    note("the shows promise different least distances; the greater one is taken");
  }
  declared = std::max(declared.value_or(metres), metres);
}

ErrorLocation RecordingAssembly::location_of(Origin origin) const {
  ErrorLocation location;
  location.source = sources_[origin.source];
  if (in_records_[origin.source]) {
    location.record = std::uint64_t{origin.line} - 1;
  } else {
    location.line = std::uint64_t{origin.line};
  }
  return location;
}

std::string RecordingAssembly::place_text(Origin origin) const {
  const ErrorLocation at = location_of(origin);
  return at.source + (at.record ? ", record " + std::to_string(*at.record)
                                : ", line " + std::to_string(at.line.value_or(0)));
}

void RecordingAssembly::declare_show(ShowFacts facts) {
  auto& show = recording_.show;
  if (!show) {
    show = std::move(facts);
    return;
  }
  const auto stricter = [](std::optional<double>& limit, const std::optional<double>& other) {
    if (other && (!limit || *other < *limit)) limit = other;
  };
  stricter(show->limits.horizontal_mps, facts.limits.horizontal_mps);
  stricter(show->limits.climb_mps, facts.limits.climb_mps);
  stricter(show->limits.descent_mps, facts.limits.descent_mps);
  stricter(show->limits.height_m, facts.limits.height_m);
  const auto keep = [](auto& ours, const auto& theirs) {
    for (const auto& limit : theirs) {
      if (std::find(ours.begin(), ours.end(), limit) == ours.end()) ours.push_back(limit);
    }
  };
  keep(show->limits.accelerations, facts.limits.accelerations);
  keep(show->limits.navigation_m, facts.limits.navigation_m);
  keep(show->limits.not_looked_at, facts.limits.not_looked_at);
  shows_apart_ = shows_apart_ || show->place != facts.place;
  show->cues.insert(show->cues.end(), facts.cues.begin(), facts.cues.end());
}

void RecordingAssembly::declare_ground(double height_m) {
  auto& ground_m = recording_.show->ground_m;
  ground_m = std::min(ground_m.value_or(height_m), height_m);
}

}  // namespace beespace::io
