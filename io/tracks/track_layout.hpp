// How a table of fixes is laid out: which columns hold the id, the time, the position and the
// velocity. Told by the names in the header and the caller's overrides; nothing is guessed.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/problems/left_out.hpp"
#include "io/recording/heightless.hpp"
#include "io/recording/recording_options.hpp"
#include "io/recording/wall_clock.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/fix_quality.hpp"
#include "io/tracks/sides.hpp"
#include "io/tracks/take_off_columns.hpp"
#include "io/units/iso_time.hpp"
#include "io/units/time_zone.hpp"
#include "io/units/unit_taken.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// What the column of the time holds.
enum class TimeForm : std::uint8_t {
  kNumbers,
  kDatesAndTimes,  // as ISO 8601 has them
  kClock,          // times of day, perhaps with the day in a column of its own
  kFrames,         // the numbers of pictures
};

struct TimeChoice {
  std::size_t column = 0;
  TimeForm form = TimeForm::kNumbers;
  Unit unit = Unit::kSecond;
  bool since_1970 = false;
  bool by_size = false;      // the unit was told by the size of the numbers
  bool named = false;        // the header alone, or the format, says the unit
  bool of_position = false;  // when it was measured: records in between say the position again
  bool since_start = false;  // of the vehicle whose table it is: those of others have other zeros
  // The first one is 0, and nothing says that the table of another vehicle, or of another trial,
  // has the same zero.
  bool begins_at_zero = false;
  bool zero_unsaid = false;    // nothing says that the table of another one has the same zero
  bool unit_is_asked = false;  // the caller alone says the unit
  bool is_small = false;       // the same, and the first one is too small for a common zero
  bool of_video = false;       // pictures of a video, which is another one than that of other files
  bool to_the_minute = false;  // the first time has no seconds
  DateOrder dates = DateOrder::kUnsaid;  // where the year is last
  std::string dates_reason = {};         // why it is that one
  std::optional<std::size_t> date = {};  // the column of the day
  bool bare_midnights = false;           // a day alone is its midnight: see bare_midnights.hpp
  std::optional<TimeZone> zone = {};     // of dates and times that name none themselves
  std::string zone_reason = {};          // why it is that one
  // Of dates and times, or times of day, without a zone: what they are counted from.
  std::optional<WallClock> clock = {};
  double frames_per_second = 0.0;
  double zero_s = 0.0;  // since 1970: what numbers count from, as the dates of `other` tell
  // Of whole seconds, as ROS has them: the column of what is to be added, in nanoseconds.
  std::optional<std::size_t> nanoseconds = {};
  // Of Telonics: the column of the time at which a fix was due, for records that have had none.
  std::optional<std::size_t> due = {};
  std::optional<std::size_t> other = {};  // another column that looks like a time, and is not taken
};

struct VelocityChoice {
  std::array<std::size_t, 3> columns = {};  // along x, y, z, or east, north, up
  std::size_t dimensions = 3;               // 2: there is no third one
  bool down = false;                        // the third one counts downwards
  // They are the speed over ground, its direction in degrees, and the climb rate.
  bool over_ground = false;
  std::array<Unit, 3> units = {Unit::kMetrePerSecond, Unit::kMetrePerSecond, Unit::kMetrePerSecond};
};

// What there is of a table when its layout is chosen.
enum class SeenRecords : std::uint8_t {
  kSome,       // some records, which say nothing of the others
  kBeginning,  // many: heights that they have none of are taken for empty, until one comes
  kWhole,      // all: heights that they have none of are empty
};

// The columns of the place on the Earth from which metres north, east and down are counted, which
// is another one for each drone; and those that say with 0 that it is not known.
struct LocalOrigin {
  std::size_t latitude = 0;
  std::size_t longitude = 0;
  std::size_t height = 0;
  std::vector<std::size_t> known = {};
};

struct AccuracyColumn {
  std::size_t column;
  Unit unit;
};

struct TrackLayout {
  TableLayout table = {};  // the position in table.choice, and the id
  Frame frame = Frame::kAuto;
  std::string frame_reason = {};
  std::optional<TimeChoice> time = {};  // none: a snapshot
  std::optional<VelocityChoice> velocity = {};
  // Of aircraft, what may be unknown is left out where it is: a record without a place is no
  // mistake.
  bool of_aircraft = false;
  bool of_animals = false;  // what wrote it is known to write tables of animals
  bool y_is_down = false;  // in pixels, or as a known program that follows animals in videos counts
  // Of other recordings, a record that says that its place is unknown ("NA") is no mistake either:
  // it is as good as none.
  bool places_may_be_unknown = false;
  bool infinite_is_unknown = false;
  bool z_is_down = false;       // of positions in metres
  bool scaled_degrees = false;  // longitude and latitude are whole numbers of 1e-7 degrees
  bool show = false;            // of a drone show: a path with colours
  // Of positions, where nothing says that they are in metres: see doubt_of_metres().
  std::optional<double> doubted_above_mps = {};
  bool ids_are_addresses = false;  // of aircraft, in capitals or not
  bool ids_within_file = false;    // of ROS: another file may call another bee so
  // Of aircraft with two kinds of heights, that which is not taken, and its unit: where it
  // contradicts the other one, neither is believed.
  Unit other_height_unit = Unit::kMetre;
  std::optional<std::size_t> other_height = {};
  std::optional<std::size_t> visible = {};       // who says no there is an outlier
  std::vector<std::size_t> marked = {};          // who says yes there is one, too,
  std::optional<std::size_t> marked_valid = {};  // unless here
  std::optional<std::size_t> tag = {};           // of animals, of which each should have one
  const LeftOutReason* no_height = nullptr;      // what to say of a record without a height,
  HeightColumns height_columns = {};             // of animals
  const LeftOutReason* without_id = nullptr;     // or without an id, where that may be empty
  std::optional<std::size_t> label = {};         // what each is called beside its id: the flight
  std::optional<std::size_t> on_ground = {};     // of those that are left out
  std::optional<std::size_t> axes_name = {};     // of ROS: what x, y, z are counted in ("map")
  std::string first_axes = {};                   // and that of the first record, if it is known
  std::optional<LocalOrigin> local_origin = {};  // of PX4's local positions: brought to degrees
  bool own_origin = false;  // of poses: they begin at 0, 0, 0, as where a robot was switched on
  // Of ROS: by how much the stamps of the header are later than the times of recording.
  std::optional<double> stamps_ahead_s = {};
  std::optional<FixQuality> quality = {};        // whether there was a fix
  std::optional<std::size_t> place_known = {};   // of PX4: who says no there does not know it,
  std::optional<std::size_t> height_known = {};  // or its height
  std::optional<std::size_t> lost = {};          // who says yes there guesses its place
  std::array<std::optional<std::size_t>, 2> off_m = {};  // of PX4: by how much it may be off
  std::optional<std::size_t> not_seen = {};              // of TRex: "missing"
  std::optional<std::size_t> sensor = {};                // of Movebank: which found the place
  std::optional<AccuracyColumn> accuracy = {};           // how far off each place may be
  std::optional<std::size_t> zone = {};                  // of UTM, in which x and y are counted
  Sides sides = {};                                      // of degrees without a sign
  std::optional<std::size_t> age = {};                   // of aircraft: how old the place is
  std::optional<std::size_t> clock_zone = {};            // of times of a clock: which is to be one
  std::vector<std::size_t> sets = {};             // within which ids are unique: studies, days
  std::vector<std::size_t> trials = {};           // which of `sets` times may begin again with
  std::vector<std::size_t> scenes = {};           // sides, cameras, arenas: see names_scene()
  std::optional<std::size_t> no_height_yet = {};  // of heights that the beginning has none of
  // Of Flightradar24: "48.0,2.0", latitude and longitude in one column.
  std::optional<std::size_t> joined_place = {};
  // Likewise: heights of 0 are of no one that flies, on the ground or where it is not known.
  bool ground_at_zero = false;
  bool keeps_grounded = false;        // aircraft on the ground count, too
  TakeOffColumns take_off = {};       // of what drones logged
  std::vector<UnitTaken> units = {};  // of positions and velocities
  // Of a beginning whose ids come once each: what is wrong if those of the whole do.
  std::optional<Error> perhaps_numbers = {};
  std::vector<std::string> notes = {};
};

// Whether ids of bees are told by the name of the file.
inline bool is_named_after_file(const TrackLayout& layout) {
  return layout.ids_within_file || (!layout.table.choice.id && layout.time);
}

// Whether an empty id is no mistake: of Flightradar24 a file is of one flight, which has a callsign
// or none.
inline bool is_named_by_file_where_empty(const TrackLayout& layout) {
  return layout.ids_within_file || layout.joined_place.has_value();
}

// The values of a report, in the order in which they are read.
struct TrackSlot {
  static constexpr std::size_t kId = 0;
  static constexpr std::size_t kTime = 1;
  static constexpr std::size_t kPosition = 2;  // three of them
  static constexpr std::size_t kVelocity = 5;  // three of them
  static constexpr std::size_t kLabel = 8;
  static constexpr std::size_t kOnGround = 9;
  static constexpr std::size_t kDate = 10;
  static constexpr std::size_t kVisible = 11;
  static constexpr std::size_t kNanoseconds = 12;
  static constexpr std::size_t kAxesName = 13;
  static constexpr std::size_t kLateHeight = 14;
  static constexpr std::size_t kOtherHeight = 15;
  static constexpr std::size_t kZone = 16;
  static constexpr std::size_t kQuality = 17;
  static constexpr std::size_t kNotSeen = 18;
  static constexpr std::size_t kSensor = 19;
  static constexpr std::size_t kTag = 20;
  static constexpr std::size_t kValid = 21;
  static constexpr std::size_t kClockZone = 22;
  static constexpr std::size_t kSide = 23;  // two of them
  static constexpr std::size_t kAge = 25;
  static constexpr std::size_t kPlaceKnown = 26;
  static constexpr std::size_t kHeightKnown = 27;
  static constexpr std::size_t kJoinedPlace = 28;
  static constexpr std::size_t kMarked = 29;  // as many as kMostMarked
  static constexpr std::size_t kMostMarked = 3;
  static constexpr std::size_t kSets = kMarked + kMostMarked;  // as many as kMostSets
  static constexpr std::size_t kMostSets = 6;
  static constexpr std::size_t kScenes = kSets + kMostSets;  // as many as kMostScenes
  static constexpr std::size_t kMostScenes = 3;
  static constexpr std::size_t kDue = kScenes + kMostScenes;
  static constexpr std::size_t kLost = kDue + 1;
  static constexpr std::size_t kOff = kLost + 1;  // two of them
  static constexpr std::size_t kAccuracy = kOff + 2;
  static constexpr std::size_t kAboveTakeOff = kAccuracy + 1;
  static constexpr std::size_t kStanding = kAboveTakeOff + 1;
  static constexpr std::size_t kNothing = kStanding + 1;  // where columns go that are not asked for
};

// By column: which slot it fills. An id may be read from a column that is something else too, but
// not the other way round.
std::vector<std::uint8_t> slots_of(const TrackLayout& layout);

// `text` has no byte-order mark. `bare_skybrush`: a table without a header is a Skybrush CSV.
// Errors: those of find_layout(), kInvalidArgument where a unit of time must be said,
// kUnsupportedFormat for a unit that is not read; with line, without source.
Result<TrackLayout> find_track_layout(std::string_view text, const RecordingOptions& options,
                                      bool bare_skybrush, SeenRecords seen = SeenRecords::kSome);

// The same for records whose columns are known already: `table` says how `text`, one or more of
// them, is split, and what the columns are called and hold. Errors without line.
Result<TrackLayout> choose_track_layout(TableLayout table, std::string_view text,
                                        const RecordingOptions& options,
                                        SeenRecords seen = SeenRecords::kSome);

}  // namespace beespace::io
