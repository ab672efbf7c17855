// What inputs must agree on to be one recording: whether they are in degrees or metres, have a
// time, what heights are above, axes, zones and units.
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/recording_assembly.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace beespace::io {
namespace {

std::string frame_words(Frame frame) {
  return frame == Frame::kWgs84 ? "in degrees" : "in metres";
}

// What --columns says to take both over ground.
std::string columns_of_place(const SourceFacts& facts, const SourceFacts& others) {
  const std::string& flat = facts.height_columns.flat;
  if (!flat.empty() && flat == others.height_columns.flat) return flat;
  return facts.frame == Frame::kWgs84 ? "lon=...,lat=..." : "x=...,y=...";
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

std::string zero_words(const SourceFacts& facts) {
  return facts.since_1970 ? "counted from 1970, or of a known time zone" : clock_words(facts);
}

// As ulog2csv names tables of topics: "drone6_vehicle_gps_position_0.csv".
bool are_topics_of_px4(std::string_view one, std::string_view other) {
  constexpr std::string_view kTopic = "_vehicle_";
  return one.find(kTopic) != std::string_view::npos && other.find(kTopic) != std::string_view::npos;
}

// Whether it means itself within quotes, in whatever program.
bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == ' ';
  });
}

// How to read one of several parts, and no other.
std::string one_at_a_time(const SourceFacts::Parts& parts, const std::string& part) {
  std::string text = "read one at a time";
  if (parts.advice.empty() || !is_plain(part)) return text;
  return text.append(", as by ").append(parts.advice).append(part).append("\"' FILE > one.csv");
}

}  // namespace

std::optional<Error> RecordingAssembly::agree(const SourceFacts& facts) {
  const auto disagree = [this](ErrorCode code, const std::string& message) {
    return Error{code, message, {sources_.back()}};
  };
  if (!facts.unused_options) unused_options_.reset();
  if (facts.zero_unsaid) {
    zeros_unsaid_.push_back(source());
    shift_ = facts.shift;
  }
  if (!facts_) {
    facts_ = facts;
    unused_options_ = facts.unused_options;
    facts_source_ = sources_.back();
    if (facts.begins_at_zero) {
      zero_source_ = facts_source_;
      zero_names_bees_ = facts.names_bees;
    }
    recording_.units = facts.units;
    recording_.of_aircraft = facts.of_aircraft;
    recording_.of_animals = facts.of_animals;
    recording_.of_drones = facts.of_drones;
    recording_.called_drones = facts.called_drones;
    recording_.heights_beside = facts.heights_beside;
    recording_.y_is_down = facts.y_is_down;
    recording_.flies_on = facts.flies_on;
    return agree_on_heights(facts);
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
                        columns_of_place(facts, *facts_) + ", or read them apart");
  }
  if (facts.has_time != facts_->has_time) {
    return disagree(ErrorCode::kMissingColumn,
                    std::string("there is ") + (facts.has_time ? "a" : "no") + " time here, but " +
                        (facts.has_time ? "none" : "one") + " in " + facts_source_ +
                        "; read them apart");
  }
  if (facts.since_1970 != facts_->since_1970) {
    return disagree(ErrorCode::kInvalidArgument,
                    "times here are " + zero_words(facts) + ", but those of " + facts_source_ +
                        " are " + zero_words(*facts_) +
                        (facts.clock || facts_->clock
                             ? "; say which time zone it is, with --time-zone UTC, or Europe/Madrid"
                         : are_topics_of_px4(facts_source_, sources_.back())
                             ? "; tables of topics, as ulog2csv makes them, are no bees each: read "
                               "the logs themselves (.ulg)"
                             : "; read them apart, or name the column unix_time_s if it counts "
                               "from 1970"));
  }
  if (auto error = agree_on_zeros(facts)) return error;
  if (facts.clock.has_value() != facts_->clock.has_value() ||
      (facts.clock && facts.clock->dated != facts_->clock->dated)) {
    return disagree(ErrorCode::kInvalidArgument, "times here are " + clock_words(facts) +
                                                     ", but those of " + facts_source_ + " are " +
                                                     clock_words(*facts_) + "; read them apart");
  }
  if (auto error = agree_on_origins(facts)) return error;
  if (facts_->frame == Frame::kAuto) {
    facts_->frame = facts.frame;
    facts_->frame_reason = facts.frame_reason;
  }
  if (facts.named_time != facts_->named_time) facts_->named_time = Unit::kUnstated;
  if (facts.doubted_above_mps) {
    facts_->doubted_above_mps = std::min(
        *facts.doubted_above_mps, facts_->doubted_above_mps.value_or(*facts.doubted_above_mps));
  }
  // The least that any of them says.
  facts_->naming = std::min(facts_->naming, facts.naming);
  recording_.of_aircraft = recording_.of_aircraft || facts.of_aircraft;
  recording_.of_animals = recording_.of_animals || facts.of_animals;
  recording_.of_drones = recording_.of_drones && facts.of_drones;
  recording_.called_drones = recording_.called_drones && facts.called_drones;
  recording_.y_is_down = recording_.y_is_down && facts.y_is_down;
  recording_.flies_on = recording_.flies_on && facts.flies_on;
  if (auto error = agree_on_heights(facts)) return error;
  if (facts_->trials.column.empty()) facts_->trials = facts.trials;
  if (facts_->scenes.column.empty()) facts_->scenes = facts.scenes;
  if (facts_->tags.column.empty()) facts_->tags = facts.tags;
  agree_on_units(facts);
  if (facts.description != facts_->description) facts_->description = "several formats";
  return std::nullopt;
}

// Times that are counted from a zero of each file's own cannot be compared.
std::optional<Error> RecordingAssembly::agree_on_zeros(const SourceFacts& facts) {
  const bool both_say = !facts.trial.empty() && !facts_->trial.empty();
  if (both_say && (facts.trial == facts_->trial || options_.one_clock)) return std::nullopt;
  if (both_say) {
    return Error{ErrorCode::kInvalidArgument,
                 "times here count from the beginning of " + facts.trial + ", but those of " +
                     facts_source_ + " from that of " + facts_->trial +
                     ": trials are not compared with each other; read the files of each trial for "
                     "themselves, or, if both began at one moment, say so with --one-clock",
                 {sources_.back()}};
  }
  const bool both = facts.begins_at_zero && zero_source_;
  const bool small = facts.small_times && facts_->small_times;
  if (facts.since_start || facts_->since_start || both || small) {
    // Of files that name their bees each may be a trial of its own.
    const bool trials = both && !facts.since_start && !facts_->since_start &&
                        (facts.names_bees || zero_names_bees_);
    return Error{
        ErrorCode::kInvalidArgument,
        "times here and in " + (both ? *zero_source_ : facts_source_) +
            (both ? " both begin at 0, and" : "") + " may be counted from a zero of each " +
            (trials ? "file's own, as of several trials: then they cannot be compared; read the "
                      "files each for itself, give times since 1970"
                    : "vehicle's own, as when it was switched on: then they cannot be compared; "
                      "give times since 1970 (of PX4 the logs themselves, .ulg)") +
            ", or, if all have one clock, say so with --one-clock",
        {sources_.back()}};
  }
  if (facts.begins_at_zero && !zero_source_) {
    zero_source_ = sources_.back();
    zero_names_bees_ = facts.names_bees;
  }
  return std::nullopt;
}

// Of places, and of the clocks of robots.
std::optional<Error> RecordingAssembly::agree_on_origins(const SourceFacts& facts) {
  constexpr double kMostClocksDiffer_s = 0.5;
  // Of two frames that cannot be compared there is nothing to ask.
  const bool frames_differ =
      !facts.axes.empty() && !facts_->axes.empty() && facts.axes != facts_->axes;
  if (facts.own_origin && facts_->own_origin && options_.frame == Frame::kAuto && !frames_differ) {
    return Error{
        ErrorCode::kUnknownFrame,
        "this trajectory and another one before it, as in " + facts_source_ +
            ", both begin at 0, 0, 0, or within 0.1 m of it, as if each were counted from where "
            "its robot was switched on: if all have one origin and direction, say so with "
            "--crs metres; else bring all into one",
        {sources_.back()}};
  }
  const bool both_say = !facts.arena.empty() && !facts_->arena.empty();
  if (both_say && facts.arena != facts_->arena && options_.frame == Frame::kAuto) {
    return Error{ErrorCode::kUnknownFrame,
                 "places here are of " + facts.arena + ", but those of " + facts_source_ + " of " +
                     facts_->arena +
                     ", which may have an origin of its own: read the files of each arena for "
                     "themselves, or, if all were calibrated together, say so with --crs metres",
                 {sources_.back()}};
  }
  facts_->own_origin = facts_->own_origin || facts.own_origin;
  if (!facts_->stamps_ahead_s) facts_->stamps_ahead_s = facts.stamps_ahead_s;
  if (!facts.stamps_ahead_s) return std::nullopt;
  const double differ_s = *facts.stamps_ahead_s - *facts_->stamps_ahead_s;
  if (std::abs(differ_s) <= kMostClocksDiffer_s) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "against the times of recording, the stamps of the header here are " +
                   grouped(std::abs(differ_s), 3) + " s " + (differ_s > 0.0 ? "later" : "earlier") +
                   " than those of " + facts_source_ +
                   ": the clocks of the robots differ; take the times of recording, which have one "
                   "clock, with --columns time=N, where N is their column (1 of bagpy's tables)",
               {sources_.back()}};
}

// What happened in one trial did not happen beside another one.
std::optional<Error> RecordingAssembly::overlapping_trials() const {
  const auto both = options_.one_clock ? std::nullopt : trials_.overlapping();
  if (!both || !facts_) return std::nullopt;
  const auto& [first, second] = *both;
  return Error{ErrorCode::kTimeOrder,
               "the times of " + excerpt(first.part) + " and " + excerpt(second.part) + ", which " +
                   facts_->trials.column + " tells apart, begin again or overlap: trials are not " +
                   "compared with each other; " + one_at_a_time(facts_->trials, second.part) +
                   "; if all have one clock, say so with --one-clock",
               location_of(second.begins)};
}

// Who is on the other side of a comb, or before another camera, is somewhere else.
std::optional<Error> RecordingAssembly::overlapping_scenes() const {
  const auto both = scenes_.overlapping();
  if (!both || !facts_) return std::nullopt;
  const auto& [first, second] = *both;
  return Error{ErrorCode::kUnknownFrame,
               "places here are of " + excerpt(second.part) + ", others at the same time of " +
                   excerpt(first.part) + ", as " + facts_->scenes.column +
                   " tells, which may have an origin of its own: scenes are not compared with " +
                   "each other; " + one_at_a_time(facts_->scenes, second.part) +
                   "; if all are counted from one origin, and bees can meet, say so with --crs "
                   "metres",
               location_of(second.begins)};
}

// Pictures are counted from the beginning of each video.
std::optional<Error> RecordingAssembly::overlapping_videos() const {
  const auto both = videos_.overlapping();
  if (!both) return std::nullopt;
  const auto& [first, second] = *both;
  return Error{ErrorCode::kInvalidArgument,
               "frames here and in " + first.part +
                   " may be counted from the beginning of a video each: then they cannot be "
                   "compared; read the files each for itself, or, if all are of one video, say so "
                   "with --one-clock",
               {second.part}};
}

// Places by two tags would be mixed.
std::optional<Error> RecordingAssembly::overlapping_tags() const {
  const auto both = tags_.overlapping();
  if (!both || !facts_) return std::nullopt;
  const auto& [first, second] = *both;
  return Error{ErrorCode::kMissingColumn,
               "bee " + excerpt(first.group) + " has two tags at once, " + excerpt(first.part) +
                   " and " + excerpt(second.part) + " (" + facts_->tags.column +
                   "), whose places would be mixed; " + facts_->tags.advice,
               location_of(second.begins)};
}

std::optional<Error> RecordingAssembly::agree_on_heights(const SourceFacts& facts) {
  const HeightDatum heights = facts.heights;
  if (heights != HeightDatum::kUnstated) {
    if (stated_heights_ != HeightDatum::kUnstated && heights != stated_heights_) {
      return Error{ErrorCode::kInvalidArgument,
                   "heights here are " + height_words(heights) + ", but elsewhere, as in " +
                       stated_by_ + ", " + height_words(stated_heights_) + "; read them apart" +
                       (facts.other_heights.empty() ? facts_->other_heights : facts.other_heights),
                   {sources_.back()}};
    }
    if (stated_by_.empty()) stated_by_ = sources_.back();
    stated_heights_ = heights;
  }
  if (facts_->other_heights.empty()) facts_->other_heights = facts.other_heights;
  if (heights == facts_->heights) return std::nullopt;
  note("some inputs say that heights are " + height_words(stated_heights_) +
       ", others say nothing; they are compared as they are");
  facts_->heights = HeightDatum::kUnstated;
  return std::nullopt;
}

std::optional<Error> RecordingAssembly::agree_on_axes(std::string_view name, std::string_view id) {
  return ros_frames_.agree(name, id, sources_.back(), options_.frame);
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

std::optional<Error> RecordingAssembly::agree_on_clock_zone(std::string_view zone) {
  if (!clock_zone_) clock_zone_ = zone;
  if (*clock_zone_ == zone) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "this time is of zone " + excerpt(zone) + ", but those before are of " +
                   excerpt(*clock_zone_) +
                   ": they are not of one clock; write them in UTC, or with their offset behind "
                   "them, as 2024-05-01T12:00:00+02:00; or, if the times are in UTC all the same, "
                   "say --time-zone UTC, or if all are of one place whose clocks are turned, that "
                   "place, as Europe/Madrid",
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

}  // namespace beespace::io
