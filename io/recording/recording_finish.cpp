// What is settled once all is read: times, the frame, what is left out or doubtful, and the notes.
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/left_out.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/coasting.hpp"
#include "io/recording/continued_logs.hpp"
#include "io/recording/doubled_drones.hpp"
#include "io/recording/local_topics.hpp"
#include "io/recording/missing_numbers.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/one_clock_note.hpp"
#include "io/recording/recording_assembly.hpp"
#include "io/recording/relayed_ids.hpp"
#include "io/recording/same_tracks.hpp"
#include "io/recording/show_ground.hpp"
#include "io/recording/swapped_degrees.hpp"
#include "io/recording/unit_doubts.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace beespace::io {

// Once all is settled.
void RecordingAssembly::find_doubtful_tracks() {
  std::unordered_set<std::string> shared;
  for (const SharedTrack& track : tracks_.shared(recording_.frame)) {
    share(track);
    shared.insert(track.id);
  }
  // Of reports as they were received it is said, and not believed.
  for (const TimeConflict& conflict : tracks_.contradicting(recording_.frame)) {
    if (!shared.insert(conflict.id).second) continue;
    share({conflict.id, conflict.time_s, conflict.second});
  }
  for (const SharedTrack& track : tracks_.jumping({recording_.frame, recording_.of_aircraft})) {
    if (!shared.contains(track.id)) jump(track);
  }
  if (recording_.missing.jumping > 0) leave_out_spikes(shared);
}

// Once all is read.
MissingRecords RecordingAssembly::missing() const {
  MissingRecords missing = recording_.missing;
  missing.count = missing_;
  missing.without_id = missing_without_id_;
  missing.bees = missing_ids_.size();
  missing.rough = rough_ids_.size();
  for (const std::string& id : missing_ids_) {
    if (tracks_.contains(id)) continue;
    ++missing.nowhere;
    if (missing.nowhere_ids.size() < MissingRecords::kMostNamed) missing.nowhere_ids.push_back(id);
  }
  return missing;
}

// Some have heights, and others have none at all.
std::optional<Error> RecordingAssembly::settle_heightless() const {
  if (!facts_ || !heightless_.any()) return std::nullopt;
  auto error = heightless_.question(facts_->height_columns, options_.columns,
                                    [this](const std::string& id) { return tracks_.contains(id); });
  if (error) error->location.source = facts_source_;
  return error;
}

std::optional<Error> RecordingAssembly::settle_shows() {
  if (!shows_apart_) return std::nullopt;
  if (options_.frame != Frame::kMetres) {
    return Error{ErrorCode::kInvalidArgument,
                 "the shows are at different places, or not all say theirs: how they lie to each "
                 "other is not known; read each for itself, or say --crs metres if all count from "
                 "one place"};
  }
  note("the shows are at different places, or not all say theirs; none is taken");
  recording_.show->place.reset();
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

// Of all logs in one sentence: of a fleet there are many.
void RecordingAssembly::note_clocks() {
  if (clocks_set_.empty()) return;
  std::size_t fewest = clocks_set_.front().times;
  std::uint64_t widest_micros = 0;
  for (const ClockSet& clock : clocks_set_) {
    fewest = std::min(fewest, clock.times);
    widest_micros = std::max(widest_micros, clock.spread_micros);
  }
  const std::string within =
      ", nine of ten of which agree within " + std::to_string((widest_micros + 500) / 1000) + " ms";
  if (clocks_set_.size() == 1) {
    return note("the clock of " + clocks_set_.front().source + " is set by " +
                counted(fewest, "time", "times") + " of GPS" + within);
  }
  note("the clocks of " + std::to_string(clocks_set_.size()) + " logs are set by GPS, each by " +
       counted(fewest, "time", "times") + " or more" + within);
}

void RecordingAssembly::note_one_clock() {
  std::vector<TimeSpan> files;
  files.reserve(zeros_unsaid_.size());
  for (const std::uint32_t source : zeros_unsaid_) {
    if (const auto span = tracks_.span_of(source)) files.push_back(*span);
  }
  if (auto text = one_clock_note(files, shift_)) note(*std::move(text));
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
  if (const auto count = bare_midnights_.count(); count > 0) {
    note(counted(count, "time is a day alone and is", "times are days alone and are") +
         " taken for midnight, as R writes it");
  }
  for (std::string& text : left_out_.notes()) {
    constexpr std::string_view kWhich = "with x and y, or lon and lat, only";
    const std::size_t at = text.find(kWhich);
    if (at != std::string::npos && facts_ && !facts_->height_columns.flat.empty()) {
      text.replace(at, kWhich.size(), facts_->height_columns.flat);
    }
    note(std::move(text));
  }
  if (kept_in_flight_ > 0) {
    note(counted(kept_in_flight_, "record says", "records say") +
         " that an aircraft is on the ground, but it is higher than any airport, or faster or "
         "steeper than it could be there: taken for flying, and kept");
  }
  if (doubted_standing_ > 0) {
    note(counted(doubted_standing_, "record says", "records say") +
         " that an aircraft stands still high in the air, which only those do whose category is "
         "that of helicopters, balloons or drones: its velocity is taken as not known");
  }
  if (rough_records_ > 0) {
    note(counted(rough_records_, "place is", "places are") +
         " by the Doppler shift of Argos (sensor-type), off by hundreds of metres or kilometres, "
         "and taken as " +
         (rough_records_ == 1 ? "it stands" : "they stand") +
         ": who comes how close cannot be told by them; leave them out of the table");
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
  if (const auto count = address_names_.spelt_twice(); count > 0) {
    note(counted(count, "address of an aircraft is", "addresses of aircraft are") +
         " written in capitals and in small letters, as " + excerpt(address_names_.example()) +
         ": one aircraft each");
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
  const std::vector<LeftOutReason> reasons = left_out_.reasons();
  const bool without_ellipsoid = std::any_of(
      reasons.begin(), reasons.end(),
      [](const LeftOutReason& reason) { return reason.which == kNoEllipsoidHeight.which; });
  if (without_ellipsoid && options_.heights == HeightSource::kAuto) {
    message +=
        "; so does, of 'replay', 'predict' and pictures, --separation enroute (or terminal), which "
        "says how close is too close, too";
  }
  return {ErrorCode::kNoPoints, message, {sources_.empty() ? "" : sources_.front()}};
}

// Headers are wrong about units now and then, and speeds show it.
std::optional<Error> RecordingAssembly::doubtful_units() const {
  // Two of one id are not fast.
  if (facts_ && facts_->doubted_above_mps && recording_.missing.shared == 0) {
    if (auto error = doubt_of_metres(recording_, *facts_->doubted_above_mps)) {
      error->location.source = facts_source_;
      return error;
    }
  }
  const bool is_said = options_.units.convention == UnitConvention::kAviation;
  if (facts_ && recording_.missing.shared == 0 && !is_said) {
    if (auto error = doubt_of_feet(recording_, highest_m_)) {
      error->location.source = facts_source_;
      return error;
    }
  }
  if (!facts_ || facts_->named_time == Unit::kUnstated) return std::nullopt;
  auto error = doubt_of_time_unit(recording_, facts_->named_time);
  if (error) error->location.source = facts_source_;
  return error;
}

std::optional<Error> RecordingAssembly::doubtful_heights() const {
  if (!facts_ || facts_->frame != Frame::kWgs84) return std::nullopt;
  auto error = doubt_of_heights(recording_.units, highest_m_);
  if (error) error->location.source = facts_source_;
  return error;
}

// Heights of several cannot be compared that each count from where it took off.
std::optional<Error> RecordingAssembly::own_grounds() const {
  if (!facts_ || facts_->frame != Frame::kWgs84 || stated_heights_ != HeightDatum::kHome ||
      options_.frame != Frame::kAuto || recording_.bees.size() < 2) {
    return std::nullopt;
  }
  return Error{ErrorCode::kInvalidArgument, std::string(kOwnGrounds), {stated_by_}};
}

Result<Recording> RecordingAssembly::finish() {
  if (options_.sector && is_show()) {
    return Error{ErrorCode::kInvalidArgument,
                 "a show is a plan, and its drones are in it from its beginning to its end; leave "
                 "--sector out",
                 {sources_.empty() ? "" : sources_.front()}};
  }
  recording_.sector = options_.sector;
  settle_heard();
  claims_.finish([this](const auto&... of) { settle_claim(of...); });
  if (auto error = doubled_hours_.unclear()) return *std::move(error);
  if (tracks_.empty()) return nothing_left();
  if (unused_options_) {
    unused_options_->location.source = facts_source_;
    return *std::move(unused_options_);
  }
  if (auto error = overlapping_videos()) return *std::move(error);
  if (auto error = overlapping_trials()) return *std::move(error);
  if (auto error = overlapping_scenes()) return *std::move(error);
  if (auto error = overlapping_tags()) return *std::move(error);
  if (auto error = settle_shows()) return *std::move(error);
  if (auto error = settle_frame()) return *std::move(error);
  if (facts_ && facts_->frame == Frame::kMetres && options_.frame == Frame::kAuto) {
    if (auto local = several_local_topics(tracks_)) {
      local->error.location = location_of(tracks_.origin(local->fix));
      return std::move(local->error);
    }
  }
  leave_out_zeros();
  if (tracks_.empty()) return nothing_left();
  if (auto error = settle_restart()) return *std::move(error);
  if (auto error = settle_times()) return *std::move(error);
  if (auto error = settle_files()) return *std::move(error);
  if (auto error = settle_midnights()) return *std::move(error);
  if (auto error = settle_heightless()) return *std::move(error);
  leave_out_zero_runs();
  if (!frame_is_settled_) {
    leave_out_stale_places();
    leave_out_frozen_places();
    leave_out_frozen_in_air();
  }
  if (auto doubled = doubled_drone(tracks_)) {
    return Error{ErrorCode::kInvalidArgument, std::move(doubled->problem),
                 location_of(tracks_.origin(doubled->fix))};
  }
  highest_m_ = std::max(highest_m_, tracks_.highest_m());
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
  recording_.accuracy = accuracy_.found();
  recording_.bees = tracks_.release();
  if (auto error = own_grounds()) return *std::move(error);
  for (RecordedBee& bee : recording_.bees) {
    settle_ground(bee);
    bee.on_surface = on_surface_.contains(bee.id);
    if (!take_offs_.empty()) bee.took_off_at_m = take_offs_.of(bee.id);
    bee.shared = shared_ids_.contains(bee.id);
    settle_unplaced(bee);
    settle_beside(bee);
    settle_label(bee);
  }
  // Of others it is asked anyway.
  if (options_.sector) lose_coasting(recording_.bees);
  if (std::any_of(recording_.bees.begin(), recording_.bees.end(),
                  [](const RecordedBee& bee) { return !bee.landed.empty(); })) {
    note(
        "drones that say that they have landed stand on the ground: two that both stand "
        "are no conflict; --grounded takes them for flying");
  }
  if (auto error = doubtful_units()) return *std::move(error);
  if (recording_.height_unit == Unit::kMetre) {
    for (RecordedBee& bee : recording_.bees) bee.stated_heights.clear();
  }
  note_clocks();
  note_one_clock();
  note_counts();
  if (auto same = same_tracks_note(recording_.bees)) note(*std::move(same));
  if (is_show() || recording_.of_drones || recording_.called_drones) {
    if (auto missing = missing_numbers_note(recording_.bees)) note(*std::move(missing));
  }
  if (recording_.of_drones && several_) {
    if (auto continued = continued_logs_note(recording_.bees, sources_))
      note(*std::move(continued));
  }
  if (recording_.of_aircraft) {
    if (auto relayed = relayed_ids_note(recording_.bees)) note(*std::move(relayed));
  }
  if (!options_.grounded) leave_ground_time_out(recording_);
  file_names_.shorten(recording_);
  if (auto swapped = swapped_degrees(recording_)) {
    note(std::move(swapped->note));
    // Who says which column is which means it.
    if (options_.columns.empty()) recording_.missing.swapped = swapped->bees;
  }
  return std::move(recording_);
}

}  // namespace beespace::io
