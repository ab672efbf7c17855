// One line of a table of fixes -> whose, when, where and how fast, or what is wrong.
#pragma once

#include "io/problems/left_out.hpp"
#include "io/table/fields.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_marks.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

struct TrackRecord {
  // Of a time that clocks show twice: time_s is the first, and the other one so much later.
  struct Doubled {
    double by_s;
    Error unclear;  // what is wrong where nothing tells which is meant
  };

  // Why the record of an aircraft is left out, and read no further; or nothing.
  const LeftOutReason* left_out = nullptr;
  bool claim_is_placed = false;  // of one that is on the ground: time and position are known
  bool flies_on_ground = false;  // says that it is on the ground, but flies; it is kept
  bool doubts_standing = false;  // says that it stands in the air: its velocity is not known
  std::string_view label = {};   // what it is called beside its id; as long as that
  std::string_view id = {};      // as long as the line and the reader live
  double time_s = 0.0;           // 0 where there is no time
  std::optional<Doubled> doubled = {};
  bool is_bare_midnight = false;  // the time is a day alone, taken for its midnight,
  bool is_midnight = false;       // or midnight, written out
  bool is_rough = false;          // a place of Argos' Doppler shifts
  // How far off the place may be by the table itself; 0 where that is not said.
  double off_m = 0.0;
  bool is_timed = false;             // of one that is left out, or bad: its time is known
  Point position = {};               // metres, or degrees and a height in metres
  double stated_height = 0.0;        // or z, as the input has it
  Velocity velocity = {};            // not-a-number where it is unknown
  std::string_view set = {};         // study, trial: within which the id is unique; as the line
  std::string_view trial = {};       // what of that times may begin again with; as the line
  std::string_view scene = {};       // before which camera it is, on which side; as the line
  std::string_view tag = {};         // by which the place of an animal is known; as the line
  std::string_view axes_name = {};   // of ROS: what the position is counted in; as long as the line
  std::string_view zone = {};        // of UTM; as long as the line
  std::string_view clock_zone = {};  // of the time; the same
  TakeOffSaid take_off = {};         // where the table tells that
  std::string_view late_height = {};  // where there were none before (TrackLayout::no_height_yet)
};

class TrackRecordReader {
 public:
  explicit TrackRecordReader(const TrackLayout& layout);

  // From here on a time that clocks show twice is no mistake.
  void take_doubled() { takes_doubled_ = true; }

  // `line` has no line end. The error has its column, but no line, record or source yet.
  // Errors: those of read_record(), kInvalidLongitude, kInvalidLatitude, kInvalidHeight,
  // kOutsideDomain.
  std::optional<Error> read(std::string_view line, TrackRecord& record);

 private:
  std::optional<Error> read_id(TrackRecord& record);
  void read_label(TrackRecord& record);
  void read_sets(TrackRecord& record);
  void read_scenes(TrackRecord& record);
  [[nodiscard]] const LeftOutReason* reason_to_leave_out() const;
  [[nodiscard]] TextInSlot text_in_slot() const;
  [[nodiscard]] bool flies() const;
  [[nodiscard]] bool heights_contradict() const;
  [[nodiscard]] bool is_old() const;
  std::optional<Error> read_time(TrackRecord& record);
  std::optional<Error> read_stamp(std::string_view text, TrackRecord& record);
  std::optional<Error> read_position(TrackRecord& record);
  std::optional<Error> read_velocity(TrackRecord& record);
  void read_claim(TrackRecord& record);
  void read_accuracy(TrackRecord& record) const;

  const TrackLayout& layout_;
  bool names_aircraft_;       // which stand on the ground only
  bool takes_flight_levels_;  // "FL350" for a height
  bool takes_doubled_ = false;
  std::vector<std::uint8_t> slots_;  // by column: which slot it fills
  std::array<Field, TrackSlot::kNothing + 1> fields_ = {};
  std::string unquoted_id_;
  std::string unquoted_label_;
  std::string joined_scenes_;
  std::string joined_sets_;
  std::string joined_trials_;
};

}  // namespace beespace::io
