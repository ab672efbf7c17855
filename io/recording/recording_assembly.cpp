#include "io/recording/recording_assembly.hpp"

#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/swapped_degrees.hpp"
#include "io/recording/unit_doubts.hpp"
#include "io/recording/zero_places.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace beespace::io {
namespace {

std::string number_text(double value) {
  std::array<char, 32> text = {};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string frame_words(Frame frame) {
  return frame == Frame::kWgs84 ? "in degrees" : "in metres";
}

std::string height_words(HeightDatum heights) {
  switch (heights) {
    case HeightDatum::kEllipsoid:
      return "above the WGS84 ellipsoid";
    case HeightDatum::kMeanSeaLevel:
      return "above mean sea level";
    case HeightDatum::kPressure:
      return "by pressure";
    case HeightDatum::kHome:
      return "above the place of take-off";
    case HeightDatum::kUnstated:
      break;
  }
  return "not said to be above anything";
}

std::string clock_words(const SourceFacts& facts) {
  if (!facts.clock) return "counted from a zero of their own";
  return facts.clock->dated ? "dates without a time zone" : "times of day without a date";
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

}  // namespace

std::optional<Error> RecordingAssembly::agree(const SourceFacts& facts) {
  const auto disagree = [this](ErrorCode code, const std::string& message) {
    return Error{code, message, {sources_.back()}};
  };
  if (!facts_) {
    facts_ = facts;
    facts_source_ = sources_.back();
    recording_.units = facts.units;
    return agree_on_heights(facts.heights);
  }
  if (facts.frame != facts_->frame && facts.frame != Frame::kAuto &&
      facts_->frame != Frame::kAuto) {
    return disagree(ErrorCode::kUnknownFrame,
                    "this is " + frame_words(facts.frame) + ", but " + facts_source_ + " is " +
                        frame_words(facts_->frame) +
                        "; read them apart, or convert one of them first");
  }
  // A height that is missing is not 0.
  if (facts.dimensions != facts_->dimensions) {
    return disagree(ErrorCode::kMissingColumn,
                    std::string("there are ") + (facts.dimensions == 2 ? "no " : "") +
                        "heights here, but " + (facts.dimensions == 2 ? "" : "none ") + "in " +
                        facts_source_ +
                        "; give heights to all, or leave them out of all with --columns " +
                        (facts.frame == Frame::kWgs84 ? "lon=...,lat=..." : "x=...,y=...") +
                        ", or read them apart");
  }
  if (facts.has_time != facts_->has_time) {
    return disagree(ErrorCode::kMissingColumn,
                    std::string("there is ") + (facts.has_time ? "a" : "no") + " time here, but " +
                        (facts.has_time ? "none" : "one") + " in " + facts_source_ +
                        "; read them apart");
  }
  if (facts.since_1970 != facts_->since_1970) {
    return disagree(ErrorCode::kInvalidArgument,
                    std::string("times here ") +
                        (facts.since_1970 ? "are counted from 1970" : "have a zero of their own") +
                        ", but those of " + facts_source_ +
                        (facts.since_1970 ? " have a zero of their own" : " do not") +
                        (facts.clock || facts_->clock
                             ? "; say of dates without a time zone which it is, with --time-zone"
                             : "; read them apart, or name the column unix_time_s if it counts "
                               "from 1970"));
  }
  if (facts.clock.has_value() != facts_->clock.has_value() ||
      (facts.clock && facts.clock->dated != facts_->clock->dated)) {
    return disagree(ErrorCode::kInvalidArgument, "times here are " + clock_words(facts) +
                                                     ", but those of " + facts_source_ + " are " +
                                                     clock_words(*facts_) + "; read them apart");
  }
  if (facts_->frame == Frame::kAuto) {
    facts_->frame = facts.frame;
    facts_->frame_reason = facts.frame_reason;
  }
  if (facts.named_time != facts_->named_time) facts_->named_time = Unit::kUnstated;
  facts_->supposed_metres = facts_->supposed_metres || facts.supposed_metres;
  // The least that any of them says.
  facts_->naming = std::min(facts_->naming, facts.naming);
  if (auto error = agree_on_heights(facts.heights)) return error;
  agree_on_units(facts);
  if (facts.description != facts_->description) facts_->description = "several formats";
  return std::nullopt;
}

std::optional<Error> RecordingAssembly::agree_on_heights(HeightDatum heights) {
  if (heights != HeightDatum::kUnstated) {
    if (stated_heights_ != HeightDatum::kUnstated && heights != stated_heights_) {
      return Error{ErrorCode::kInvalidArgument,
                   "heights here are " + height_words(heights) + ", but elsewhere, as in " +
                       stated_by_ + ", " + height_words(stated_heights_) + "; read them apart",
                   {sources_.back()}};
    }
    if (stated_by_.empty()) stated_by_ = sources_.back();
    stated_heights_ = heights;
  }
  if (heights == facts_->heights) return std::nullopt;
  note("some inputs say that heights are " + height_words(stated_heights_) +
       ", others say nothing; they are compared as they are");
  facts_->heights = HeightDatum::kUnstated;
  return std::nullopt;
}

std::optional<Error> RecordingAssembly::agree_on_axes(std::string_view name) {
  if (!axes_name_) {
    axes_name_ = name;
    axes_source_ = sources_.back();
  }
  if (*axes_name_ == name) return std::nullopt;
  return Error{ErrorCode::kUnknownFrame,
               "this position is in the frame " + excerpt(name) + " of ROS, but others, as in " +
                   axes_source_ + ", are in " + excerpt(*axes_name_) +
                   ": they cannot be compared; bring all into one, as by the transforms of /tf",
               {}};
}

std::optional<Error> RecordingAssembly::agree_on_zone(std::string_view stated,
                                                      std::string_view zone) {
  if (!zone_) {
    zone_ = zone;
    stated_zone_ = stated;
    note("eastings and northings are of UTM zone " + excerpt(stated) + ", all of them");
  }
  if (*zone_ == zone) return std::nullopt;
  return Error{ErrorCode::kUnknownFrame,
               "this easting and northing are of UTM zone " + excerpt(stated) +
                   ", but those before are of " + excerpt(stated_zone_) +
                   ": they cannot be compared; take longitude and latitude, as with --columns "
                   "lon=...,lat=..., or bring all into one zone",
               {}};
}

// Each is converted by its own; heights as they are stated can be compared only in one unit.
void RecordingAssembly::agree_on_units(const SourceFacts& facts) {
  for (const UnitTaken& taken : facts.units) {
    auto& known = recording_.units;
    if (std::find(known.begin(), known.end(), taken) == known.end()) known.push_back(taken);
  }
  if (facts.height_unit == facts_->height_unit) return;
  note("inputs state heights in different units; they are compared in metres");
  facts_->height_unit = Unit::kMetre;
  several_height_units_ = true;
}

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
  source_stem_ = std::move(stem);
  if (stems_.insert(source_stem_).second) return source_stem_;
  source_stem_ = sources_.back();
  for (std::size_t number = 2; !stems_.insert(source_stem_).second; ++number) {
    source_stem_ = sources_.back() + "#" + std::to_string(number);
  }
  return source_stem_;
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
  constexpr std::uint64_t kInOrder = 3;        // so that a table in no order is none
  auto at = clock_times_.find(id);
  if (at == clock_times_.end()) at = clock_times_.try_emplace(std::string(id)).first;
  ClockTime& clock = at->second;
  const double back_s = clock.last_s - time_s;
  if (clock.in_order == 0 || back_s <= 0.0) {
    clock.last_s = time_s;
    ++clock.in_order;
    return std::nullopt;
  }
  const bool is_long = back_s >= 0.5 * kHour_s && back_s < kHour_s;
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
}

void RecordingAssembly::leave_file_out(std::string_view name) {
  MissingRecords& missing = recording_.missing;
  ++missing.files;
  if (missing.file_names.size() < MissingRecords::kMostNamed) missing.file_names.emplace_back(name);
}

void RecordingAssembly::settle_claim(const std::string& id, std::uint64_t claims, bool in_flight) {
  for (std::uint64_t i = 0; i < claims; ++i) leave_out(in_flight ? kGroundInFlight : kOnGround, id);
}

void RecordingAssembly::flies_at(std::string_view id, const Fix& fix) {
  claims_.take(id, fix, false, facts_ ? facts_->frame : Frame::kWgs84,
               [this](const auto&... of) { settle_claim(of...); });
}

void RecordingAssembly::claims_ground(std::string_view id, const Fix& fix) {
  claims_.take(id, fix, true, facts_ ? facts_->frame : Frame::kWgs84,
               [this](const auto&... of) { settle_claim(of...); });
}

void RecordingAssembly::heard_of(const LeftOutReason& reason, std::string_view id) {
  heard_.emplace_back(reason, id);
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
  if (++missing.shared > MissingRecords::kMostNamed) return;
  missing.shared_ids.push_back(track.id);
  note("bee " + excerpt(track.id) + " is at two places in turn, from " + place_text(track.first) +
       " on, " + number_text(track.time_s) +
       " s, as if two had this id: where they are is not known; give each an id of its own");
}

void RecordingAssembly::jump(const SharedTrack& track) {
  MissingRecords& missing = recording_.missing;
  if (++missing.jumping > MissingRecords::kMostNamed) return;
  missing.jumping_ids.push_back(track.id);
  note("bee " + excerpt(track.id) + " jumps to where it is in " + place_text(track.first) + ", " +
       number_text(track.time_s) +
       " s, faster than anything that flies, or than it says itself: a place or a time is wrong, "
       "and where it is is not known; correct such records, or leave them out");
}

// Where no place is known, zeros may be written.
void RecordingAssembly::leave_out_zeros() {
  if (!facts_ || facts_->frame != Frame::kWgs84 || frame_is_settled_) return;
  ZeroPlaces zeros;
  for (const Point& at : tracks_.positions()) zeros.look_at(at);
  tracks_.leave_out([&zeros](const Fix& fix) { return zeros.is_none(fix.position); },
                    [this](const std::string& id) { leave_out(kZeroPlace, id); });
}

// Once all is settled.
void RecordingAssembly::find_doubtful_tracks() {
  std::unordered_set<std::string> shared;
  for (const SharedTrack& track : tracks_.shared(recording_.frame)) {
    share(track);
    shared.insert(track.id);
  }
  for (const SharedTrack& track : tracks_.jumping(recording_.frame)) {
    if (!shared.contains(track.id)) jump(track);
  }
}

// Once all is read.
MissingRecords RecordingAssembly::missing() const {
  MissingRecords missing = recording_.missing;
  missing.count = missing_;
  missing.without_id = missing_without_id_;
  missing.bees = missing_ids_.size();
  for (const std::string& id : missing_ids_) {
    if (tracks_.contains(id)) continue;
    ++missing.nowhere;
    if (missing.nowhere_ids.size() < MissingRecords::kMostNamed) missing.nowhere_ids.push_back(id);
  }
  return missing;
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
  if (show->place != facts.place) {
    note("the shows are at different places, or not all say theirs; none is taken");
    show->place.reset();
  }
  show->cues.insert(show->cues.end(), facts.cues.begin(), facts.cues.end());
}

void RecordingAssembly::declare_ground(double height_m) {
  auto& ground_m = recording_.show->ground_m;
  ground_m = std::min(ground_m.value_or(height_m), height_m);
}

Error RecordingAssembly::conflict_error(const TimeConflict& conflict) const {
  const std::string first = place_text(conflict.first);
  std::string message = "bee " + excerpt(conflict.id) + " is at another place at the same time";
  if (facts_ && facts_->has_time) {
    message += ", " + number_text(conflict.time_s) + " s, in " + first +
               "; correct one of them, or name the column that tells the bees apart with "
               "--columns id=...";
  } else {
    message = "bee " + excerpt(conflict.id) + " comes twice, before in " + first +
              "; without a time each bee has one record";
  }
  return {ErrorCode::kTimeOrder, message + std::string(kOrLeaveOut), location_of(conflict.second)};
}

std::optional<Error> RecordingAssembly::settle_times() {
  std::vector<TimeConflict> conflicts;
  tracks_.settle([&conflicts](const TimeConflict& conflict) { conflicts.push_back(conflict); });
  std::sort(conflicts.begin(), conflicts.end(), [](const TimeConflict& a, const TimeConflict& b) {
    if (a.second.source != b.second.source) return a.second.source < b.second.source;
    return a.second.line < b.second.line;
  });
  for (const TimeConflict& conflict : conflicts) {
    if (auto error = bad(conflict_error(conflict), conflict.id)) return error;
  }
  return std::nullopt;
}

std::optional<Error> RecordingAssembly::settle_frame() {
  if (!facts_ || frame_is_settled_) return std::nullopt;
  SourceFacts& facts = *facts_;
  const bool bare = options_.frame == Frame::kAuto && facts.naming == Naming::kBareAxes;
  if (facts.frame == Frame::kAuto || bare) {
    const std::vector<Point> points = tracks_.positions();
    if (points.empty()) return std::nullopt;
    const Extent extent = extent_of(points);
    if (facts.frame == Frame::kAuto) {
      auto decision = frame_from_values(points, extent, facts.dimensions, facts.naming);
      if (!decision) {
        Error error = std::move(decision).error();
        error.location.source = facts_source_;
        if (error.location.record) {
          error.location = location_of(tracks_.origin(*error.location.record));
        }
        return error;
      }
      facts.frame = decision->frame;
      facts.frame_reason = decision->reason;
      if (!decision->note.empty()) note(decision->note);
    } else if (auto error = contradiction_to_metres(points, extent, facts.dimensions)) {
      error->location.source = facts_source_;
      return error;
    }
  }
  return std::nullopt;
}

void RecordingAssembly::note_counts() {
  if (const auto count = tracks_.out_of_order(); count > 0) {
    note(counted(count, "record goes", "records go") +
         " back in time; the records of each bee are brought into the order of time");
  }
  if (const auto count = tracks_.repeated(); count > 0) {
    note(counted(count, "record repeats", "records repeat") +
         " a time and place of the same bee and " + (count == 1 ? "is" : "are") + " left out");
  }
  if (const auto count = tracks_.clashing(); count > 0) {
    note(counted(count, "record says", "records say") +
         " another place for a time that the same bee has been heard at (times are rounded); the "
         "first is taken");
  }
  for (std::string& text : left_out_.notes()) note(std::move(text));
  if (kept_in_flight_ > 0) {
    note(counted(kept_in_flight_, "record says", "records say") +
         " that an aircraft is on the ground, but it is higher than any airport, or faster or "
         "steeper than it could be there: taken for flying, and kept");
  }
  if (const auto count = tracks_.in_several_sources(); count > 0) {
    note(counted(count, "bee is", "bees are") +
         " in several files under the same id; each is taken for one, merged by time");
  }
  if (const auto count = set_names_.told_apart(); count > 0) {
    note(counted(count, "bee has", "bees have") +
         " the name of one of another study, trial, video or day; they are told apart, as in " +
         excerpt(set_names_.example()));
  }
  if (const auto count = tracks_.renamed(); count > 0) {
    note(counted(count, "bee has", "bees have") +
         " the name of another one; they are told apart as in 'name#2'");
  }
}

Error RecordingAssembly::nothing_left() const {
  std::string message = "no bee is left";
  if (!recording_.skipped.empty()) {
    const auto count = recording_.skipped_count;
    message = count == 1 ? "the only record is bad: "
                         : "all " + std::to_string(count) + " records are bad; the first: ";
    message += recording_.skipped.front().message;
  }
  const std::vector<std::string> left_out = left_out_.notes();
  for (const std::string& text : left_out) {
    message += (&text == &left_out.front() ? ": " : ". Also, ") + text;
  }
  return {ErrorCode::kNoPoints, message, {sources_.empty() ? "" : sources_.front()}};
}

// Headers are wrong about units now and then, and speeds show it.
std::optional<Error> RecordingAssembly::doubtful_units() const {
  if (facts_ && facts_->supposed_metres) {
    if (auto error = doubt_of_metres(recording_)) {
      error->location.source = facts_source_;
      return error;
    }
  }
  if (!facts_ || facts_->named_time == Unit::kUnstated) return std::nullopt;
  auto error = doubt_of_time_unit(recording_, facts_->named_time);
  if (error) error->location.source = facts_source_;
  return error;
}

// Heights without a unit that are metres of nothing that flies: they may be feet.
std::optional<Error> RecordingAssembly::doubtful_heights() const {
  constexpr double kHighest_m = 20'000.0;
  if (!facts_ || facts_->frame != Frame::kWgs84) return std::nullopt;
  const auto& units = recording_.units;
  const bool unsaid = std::any_of(units.begin(), units.end(), [](const UnitTaken& taken) {
    return taken.of == "heights" && taken.evidence == UnitEvidence::kUsual;
  });
  const double highest_m = std::max(highest_m_, tracks_.highest_m());
  if (!unsaid || !(highest_m > kHighest_m)) return std::nullopt;
  return Error{
      ErrorCode::kInvalidArgument,
      "heights go up to " + number_text(highest_m) +
          ", but no unit is named: are they metres, or feet? Say it in the header, or with "
          "--units height=ft or height=m",
      {facts_source_}};
}

Result<Recording> RecordingAssembly::finish() {
  settle_heard();
  claims_.finish([this](const auto&... of) { settle_claim(of...); });
  if (tracks_.empty()) return nothing_left();
  if (auto error = settle_frame()) return *std::move(error);
  leave_out_zeros();
  if (tracks_.empty()) return nothing_left();
  if (auto error = settle_times()) return *std::move(error);
  if (auto error = doubtful_heights()) return *std::move(error);
  if (facts_) {
    recording_.frame = facts_->frame;
    recording_.frame_reason = facts_->frame_reason;
    recording_.format_description = facts_->description;
    recording_.since_1970 = facts_->since_1970;
    recording_.clock = facts_->clock;
    if (facts_->since_1970) recording_.time_zone = options_.time_zone;
    recording_.flat = facts_->dimensions == 2;
    recording_.heights = facts_->heights;
    if (!several_height_units_) recording_.height_unit = facts_->height_unit;
  }
  if (!frame_is_settled_) find_doubtful_tracks();
  recording_.missing = missing();
  recording_.bees = tracks_.release();
  if (auto error = doubtful_units()) return *std::move(error);
  if (recording_.height_unit == Unit::kMetre) {
    for (RecordedBee& bee : recording_.bees) bee.stated_heights.clear();
  }
  note_counts();
  if (auto swapped = swapped_degrees(recording_)) {
    note(std::move(swapped->note));
    // Who says which column is which means it.
    if (options_.columns.empty()) recording_.missing.swapped = swapped->bees;
  }
  return std::move(recording_);
}

}  // namespace beespace::io
