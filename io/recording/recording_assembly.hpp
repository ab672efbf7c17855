// Several inputs -> one recording: what they must agree on, and what must be told.
//
// Used in this order: begin_source(), then agree(), bad(), note(), tracks() for what is in it, for
// each input; finish() at the end.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/frames/frame_decision.hpp"
#include "io/problems/left_out.hpp"
#include "io/recording/address_names.hpp"
#include "io/recording/bare_midnights.hpp"
#include "io/recording/doubled_hours.hpp"
#include "io/recording/file_names.hpp"
#include "io/recording/frozen_places.hpp"
#include "io/recording/ground_claims.hpp"
#include "io/recording/heightless.hpp"
#include "io/recording/part_spans.hpp"
#include "io/recording/recording.hpp"
#include "io/recording/recording_options.hpp"
#include "io/recording/ros_frames.hpp"
#include "io/recording/set_names.hpp"
#include "io/recording/stated_accuracy.hpp"
#include "io/recording/take_offs.hpp"
#include "io/recording/track_gathering.hpp"
#include "io/units/heights.hpp"
#include "io/units/unit_taken.hpp"

#include <beespace/conflict.hpp>
#include <beespace/result.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace beespace::io {

// What an input says of all its bees.
struct SourceFacts {
  Frame frame = Frame::kAuto;  // kAuto: the values must tell
  Naming naming = Naming::kSure;
  std::string frame_reason = {};
  std::size_t dimensions = 3;
  bool has_time = true;
  bool since_1970 = false;
  std::optional<WallClock> clock = {};
  bool own_origin = false;  // places may count from where the vehicle was switched on
  std::string axes = {};    // of ROS: the frame of the first position
  // Of positions, where nothing says that they are in metres: see doubt_of_metres().
  std::optional<double> doubted_above_mps = {};
  std::optional<double> stamps_ahead_s = {};  // of ROS, of the times of recording
  bool since_start = false;                   // times count since the one vehicle was switched on
  bool begins_at_zero = false;                // the first one is 0
  bool small_times = false;                   // TimeChoice::is_small
  // Nothing says that times of several such count from one zero.
  bool zero_unsaid = false;
  bool of_aircraft = false;           // by its format, or what its columns are called
  bool of_animals = false;            // what is known to write tables of animals wrote it
  bool of_drones = false;             // what their autopilots logged
  bool called_drones = false;         // Recording::called_drones
  bool y_is_down = false;             // Recording::y_is_down
  bool flies_on = false;              // Recording::flies_on
  bool names_bees = false;            // by an id: there may be several in it
  Unit time_unit = Unit::kUnstated;   // in which times are numbers
  Unit named_time = Unit::kUnstated;  // that of the times, where nothing but the header says it
  HeightDatum heights = HeightDatum::kUnstated;
  Unit height_unit = Unit::kMetre;  // in which TrackGathering is told them as they are stated
  std::vector<UnitTaken> units = {};
  HeightColumns height_columns = {};  // of animals, of which some may have none
  std::string description = {};       // "text, comma-separated"
  std::string shift = {};             // how to add something to times, where zero_unsaid
  std::string heights_beside = {};    // Recording::heights_beside
  std::string other_heights = {};     // how to take those above something else: ", or take ..."
  // Of what has a layout of its own: which of the options that were given are not for it.
  std::optional<Error> unused_options = {};
  // Where times may begin again with each trial, and where an animal may have several tags at
  // once: which column tells, and what to do then.
  struct Parts {
    std::string column = {};
    std::string advice = {};
  };
  Parts trials = {};
  Parts scenes = {};  // where places of each camera, side or arena may have an origin of its own
  Parts tags = {};
  // From whose beginning times count, and in whose arena places are counted, as the file says:
  // those of one trial have one clock, those of one arena one origin. Empty where it does not say.
  std::string trial = {};
  std::string arena = {};
};

class RecordingAssembly {
 public:
  explicit RecordingAssembly(const RecordingOptions& options) : options_(options) {}

  [[nodiscard]] const RecordingOptions& options() const { return options_; }
  // Whatever is wrong from here on is blamed on `name`.
  void begin_source(std::string name) {
    sources_.push_back(std::move(name));
    in_records_.push_back(false);
  }
  // The lines of origins in this source are those of records, from 1: it has no lines that say
  // anything.
  void count_records() { in_records_.back() = true; }
  [[nodiscard]] std::uint32_t source() const {
    return static_cast<std::uint32_t>(sources_.size() - 1);
  }

  [[nodiscard]] const std::string& source_name() const { return sources_.back(); }
  // Whether there is more than one input, so that what is called by numbers alone needs a name of
  // its source before it.
  void expect_several() { several_ = true; }
  // The frame was judged by all positions while they came, of which not all are there any more.
  void settled_frame() { frame_is_settled_ = true; }
  [[nodiscard]] bool has_several() const { return several_; }
  // What to call the source in ids, the same for every call until the next source begins: `stem`,
  // or where another source has it already, all of the source's name, numbered if need be.
  std::string name_of_source(std::string stem);
  // Whether a source is called so already.
  [[nodiscard]] bool is_taken(const std::string& name) const { return stems_.contains(name); }
  // Of sources that are to be begun: those of one stem are called by what differs in their names.
  void expect_sources(const std::vector<std::string>& sources);

  // What to call a bee whose id is unique within a study, or the like, only.
  std::string_view name_within_set(std::string_view id, std::string_view set) {
    return set_names_.name_of(id, set);
  }
  // What to call a bee whose id may be that of another one in another file, until all are known.
  std::string_view name_within_file(std::string_view file, std::string_view id) {
    return file_names_.name_of(file, id);
  }
  // What to call an aircraft of that address, which another input may write in capitals.
  std::string_view name_of_address(std::string_view address) {
    return address_names_.name_of(address);
  }
  // Of times of day without a date: whether one comes before the last one of that bee, so that
  // another day may have begun.
  bool goes_back(std::string_view id, double time_s);
  // Of dates and times of a clock whose zone is not known: by how much it goes back here, as where
  // clocks are set back at night, and the same times come again; otherwise nothing.
  std::optional<double> set_back_by(std::string_view id, double time_s);

  // Errors: kUnknownFrame, kMissingColumn, kInvalidArgument for inputs that do not go together:
  // in frame, time, whether there are heights or what these are counted from.
  std::optional<Error> agree(const SourceFacts& facts);
  // Of ROS: positions of a bee are counted in axes of that name, which must be one for all, and not
  // one of each robot. Errors: kUnknownFrame.
  std::optional<Error> agree_on_axes(std::string_view name, std::string_view id);
  // Of eastings and northings, as the input calls their zone and as all of that zone are called.
  // Errors: kUnknownFrame.
  std::optional<Error> agree_on_zone(std::string_view stated, std::string_view zone);
  // Of times of a clock whose zone each record says: that of all must be one. Errors:
  // kInvalidArgument.
  std::optional<Error> agree_on_clock_zone(std::string_view zone);
  // What they agree on so far; null where nothing was read.
  [[nodiscard]] const SourceFacts* facts() const { return facts_ ? &*facts_ : nullptr; }
  // The midnight that all inputs without a time zone count from: that of the first of them.
  [[nodiscard]] WallClock common_clock(const WallClock& clock) const;
  // Whether heights as they are stated have several units.
  [[nodiscard]] bool several_height_units() const { return several_height_units_; }
  // A fix of those that are not kept until the end is so high.
  void reach(double height_m) { highest_m_ = std::max(highest_m_, height_m); }
  // Of sources that were begun.
  [[nodiscard]] ErrorLocation location_of(Origin origin) const;
  [[nodiscard]] Error conflict_error(const TimeConflict& conflict) const;
  // Whether a clock may begin again unseen: times count from a zero of their own.
  [[nodiscard]] bool may_begin_again() const;
  [[nodiscard]] Error restart_error(const RestartedClock& restarted) const;
  // Says it once, however often it is handed in.
  void note(std::string text);
  // An error that skip_bad leaves out: nothing then, and a record of that bee is missing; no id
  // where it is not known. Otherwise the error, with its source.
  std::optional<Error> bad(Error error, std::string_view id = {});
  void declare_threshold(double metres);
  // The input was written then, whenever the positions in it were heard.
  void written_at(double time_s);
  // Of several shows the stricter limits count, and a place only where all have the same.
  void declare_show(ShowFacts facts);
  [[nodiscard]] bool is_show() const { return recording_.show.has_value(); }
  // Of a show that was declared: how high its lowest place is.
  void declare_ground(double height_m);
  // The clock of the source, a log, is set by so many times of GPS, nine of ten of which agree
  // within that.
  void set_by_gps(std::size_t times, std::uint64_t spread_micros) {
    clocks_set_.push_back({sources_.back(), times, spread_micros});
  }
  void add_bytes(std::uint64_t count) { recording_.bytes += count; }
  TrackGathering& tracks() { return tracks_; }
  // As many records of that bee, or of an unknown one, may hide what it did.
  void miss(std::uint64_t records, std::string_view id);
  DoubledHours& doubled_hours() { return doubled_hours_; }
  BareMidnights& bare_midnights() { return bare_midnights_; }
  // A record of that bee is left out without being a mistake.
  void leave_out(const LeftOutReason& reason, std::string_view id);
  // A file, or a folder, beside those that are read: who may be in it is not known.
  void leave_file_out(std::string_view name);
  // Likewise one of them of which nothing could be read.
  void leave_broken_file_out(Error error);
  // So many vehicles were where they say at another time: MissingRecords::untimed.
  void doubt_times(std::uint64_t vehicles) { recording_.missing.untimed += vehicles; }
  // A record of that trial, whose times may begin again in another one; of an animal, by that tag.
  void take_trial(std::string_view trial, double time_s, Origin origin) {
    trials_.take({}, trial, time_s, origin);
  }
  // A record of that scene within a trial, whose places may have an origin of their own.
  void take_scene(std::string_view trial, std::string_view scene, double time_s, Origin origin) {
    scenes_.take(trial, scene, time_s, origin);
  }
  // A record of a picture of that video.
  void take_picture(std::string_view video, double time_s, Origin origin) {
    videos_.take({}, video, time_s, origin);
  }
  void take_tag(std::string_view id, std::string_view tag, double time_s, Origin origin) {
    tags_.take(id, tag, time_s, origin);
  }
  // A place of that bee is one of Argos' Doppler shifts, which may be off by kilometres.
  void take_rough(std::string_view id);
  // A place of that bee may be off by so much, as that column says.
  void take_accuracy(std::string_view id, double off_m, std::string_view column) {
    accuracy_.take(id, off_m, column);
  }
  // A report of an aircraft, in a format in which it may say that it is on the ground: where it is
  // kept, and where it is not since it says so, which is counted once it is known whether it flies.
  void flies_at(std::string_view id, const Fix& fix);
  void claims_ground(std::string_view id, const Fix& fix) {
    claim(id, fix, GroundClaim::kSaysOnGround);
  }
  // The same of a drone whose autopilot says that it has landed; its fix is added, too.
  void has_landed(std::string_view id, const Fix& fix) { claim(id, fix, GroundClaim::kLanded); }
  // What records say of where their bees took off.
  [[nodiscard]] TakeOffs& take_offs() { return take_offs_; }
  // It is a rover or a boat, by its own word.
  void stays_on_surface(std::string_view id) { on_surface_.emplace(id); }
  // A record says that the bee is on the ground, but not how it could be; it is kept.
  void keep_in_flight() { ++kept_in_flight_; }
  // A record says that an aircraft stands in the air; what its velocity is is not known.
  void doubt_standing() { ++doubted_standing_; }
  // It was heard of, though not its place: if no place comes from anywhere, a record is left out
  // for that reason.
  void heard_of(const LeftOutReason& reason, std::string_view id);
  // It was there, at no known place.
  void unplaced(std::string_view id, double time_s);
  // The same of one that tells of no position at all, as many messages of aircraft do: that counts
  // for the ends of cuts of a sector only.
  void positionless(std::string_view id, double time_s);
  // Of fixes that are handed out as they come: whether there are two such records or more between
  // these two, so far; and those between which there are.
  [[nodiscard]] bool is_lost_between(const std::string& id, const TimeSpan& fixes) const;
  // From the first of them to the last; nothing of fewer than two.
  [[nodiscard]] std::optional<TimeSpan> unplaced_span(const std::string& id) const;
  void lose(const std::string& id, const TimeSpan& between) { lost_[id].push_back(between); }
  // Others tell its places, and say them again until they hear anew.
  void told_by_others(std::string_view id) { told_by_others_.emplace(id); }
  // Once all came: bees that may be somewhere else at the end than they say.
  void note_frozen(const FrozenEnds& ends);
  // The place of that fix is one that the bee had left (see stale_places.hpp): it counts for none.
  void stale(const std::string& id, const Fix& fix);
  // Two bees seem to share that id: they are not known.
  void share(const SharedTrack& track);
  // That bee jumps: where it is is not known all the time.
  void jump(const SharedTrack& track);
  // How many records without any id came before, over all inputs.
  [[nodiscard]] std::uint64_t nameless() const { return nameless_; }
  void add_nameless(std::uint64_t count) { nameless_ += count; }

  // Errors: kTimeOrder, kUnknownFrame, kNoPoints.
  Result<Recording> finish();

 private:
  [[nodiscard]] std::string place_text(Origin origin) const;
  std::optional<Error> settle_times();
  [[nodiscard]] std::optional<Error> settle_restart() const;
  [[nodiscard]] std::optional<Error> settle_files() const;
  [[nodiscard]] std::optional<Error> settle_midnights() const;
  [[nodiscard]] std::optional<Error> settle_heightless() const;
  std::optional<Error> settle_shows();
  std::optional<Error> settle_frame();
  void leave_out_zeros();
  void leave_out_zero_runs();
  void leave_out_stale_places();
  void leave_out_frozen_places();
  void leave_out_frozen_in_air();
  void find_doubtful_tracks();
  void leave_out_spikes(const std::unordered_set<std::string>& shared);
  void settle_heard();
  void claim(std::string_view id, const Fix& fix, GroundClaim claims);
  void settle_claim(const std::string& id, const GroundClaims::Run& run);
  // Of aircraft that take off from the ground, or land there, when they did.
  void settle_ground(RecordedBee& bee) const;
  void settle_unplaced(RecordedBee& bee);
  void settle_beside(RecordedBee& bee) const;
  static void settle_label(RecordedBee& bee);
  [[nodiscard]] MissingRecords missing() const;
  [[nodiscard]] std::optional<Error> doubtful_heights() const;
  [[nodiscard]] std::optional<Error> own_grounds() const;
  [[nodiscard]] std::optional<Error> doubtful_units() const;
  void note_counts();
  void note_clocks();
  void note_one_clock();
  [[nodiscard]] Error nothing_left() const;
  std::optional<Error> agree_on_heights(const SourceFacts& facts);
  [[nodiscard]] std::optional<Error> agree_on_origins(const SourceFacts& facts);
  [[nodiscard]] std::optional<Error> agree_on_zeros(const SourceFacts& facts);
  [[nodiscard]] std::optional<Error> overlapping_trials() const;
  [[nodiscard]] std::optional<Error> overlapping_scenes() const;
  [[nodiscard]] std::optional<Error> overlapping_videos() const;
  [[nodiscard]] std::optional<Error> overlapping_tags() const;
  void agree_on_units(const SourceFacts& facts);

  const RecordingOptions& options_;
  Recording recording_;
  TrackGathering tracks_;
  LeftOut left_out_;
  Heightless heightless_;
  GroundClaims claims_;
  std::unordered_map<std::string, std::vector<GroundClaims::Run>> grounded_;  // or perhaps, by id
  std::unordered_map<std::string, std::set<double>> unplaced_;                // times by id
  std::unordered_map<std::string, std::set<double>> positionless_;            // the same, and more
  std::unordered_map<std::string, std::vector<TimeSpan>> lost_;  // by id, of those handed out
  std::unordered_set<std::string> told_by_others_;               // by id
  TakeOffs take_offs_;
  std::unordered_set<std::string> on_surface_;  // by id
  std::unordered_set<std::string> shared_ids_;
  std::uint64_t kept_in_flight_ = 0;
  std::uint64_t doubted_standing_ = 0;
  AccuracyGathering accuracy_;
  std::uint64_t rough_records_ = 0;
  std::unordered_set<std::string> rough_ids_;
  std::uint64_t missing_ = 0;  // records
  std::uint64_t missing_without_id_ = 0;
  std::vector<std::string> missing_ids_;  // of the others, each once, in the order of the input
  std::unordered_set<std::string> missing_known_;  // the same
  std::vector<std::pair<LeftOutReason, std::string>> heard_;
  std::vector<std::string> sources_;
  std::vector<bool> in_records_;           // by source
  std::unordered_set<std::string> stems_;  // those given away by name_of_source()
  std::unordered_map<std::string, std::string> names_apart_;  // of sources that share a stem
  std::string source_stem_;                                   // the last of them
  SetNames set_names_;
  PartSpans trials_;
  PartSpans scenes_;  // within each trial
  PartSpans videos_;  // by name
  PartSpans tags_;    // within each animal
  AddressNames address_names_;
  FileNames file_names_;
  DoubledHours doubled_hours_;
  BareMidnights bare_midnights_;
  std::unordered_map<std::string, double> times_of_day_s_;  // by bee: the last one
  // The same of dates and times, and how many records came in order.
  struct ClockTime {
    double last_s = 0.0;
    double step_s = 0.0;  // by which the last one came after the one before
    std::uint64_t in_order = 0;
  };
  std::map<std::string, ClockTime, std::less<>> clock_times_;
  std::size_t named_sources_ = 0;  // how many sources were begun when it was given away
  bool several_ = false;
  bool frame_is_settled_ = false;
  bool shows_apart_ = false;          // which count from different places, as far as they say
  std::optional<SourceFacts> facts_;  // of all inputs so far
  std::string facts_source_;          // who said so first
  // That of the first, as long as options are for none of them.
  std::optional<Error> unused_options_;
  std::vector<std::uint32_t> zeros_unsaid_;              // sources: SourceFacts::zero_unsaid
  std::string shift_;                                    // of the last of them
  std::optional<std::string> zero_source_;               // whose times begin at 0,
  bool zero_names_bees_ = false;                         // and whether it names bees
  HeightDatum stated_heights_ = HeightDatum::kUnstated;  // by the source that states it
  std::string stated_by_;
  std::uint64_t nameless_ = 0;
  struct ClockSet {
    std::string source;
    std::size_t times = 0;
    std::uint64_t spread_micros = 0;
  };
  std::vector<ClockSet> clocks_set_;
  RosFrames ros_frames_;
  double highest_m_ = 0.0;
  std::optional<std::string> zone_;
  std::string stated_zone_;
  std::optional<std::string> clock_zone_;
  bool several_height_units_ = false;
};

}  // namespace beespace::io
