// How a table of fixes is laid out: which columns hold the id, the time, the position and the
// velocity. Told by the names in the header and the caller's overrides; nothing is guessed.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/problems/left_out.hpp"
#include "io/recording/recording_options.hpp"
#include "io/table/table_layout.hpp"
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

struct TimeChoice {
  std::size_t column = 0;
  Unit unit = Unit::kSecond;
  bool iso = false;  // dates and times, not numbers
  bool since_1970 = false;
  bool by_size = false;  // the unit was told by the size of the numbers
  bool named = false;    // the header alone, or the format, says the unit
  // Of whole seconds, as ROS has them: the column of what is to be added, in nanoseconds.
  std::optional<std::size_t> nanoseconds = {};
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

struct TrackLayout {
  TableLayout table = {};  // the position in table.choice, and the id
  Frame frame = Frame::kAuto;
  std::string frame_reason = {};
  std::optional<TimeChoice> time = {};  // none: a snapshot
  std::optional<VelocityChoice> velocity = {};
  // Of aircraft, what may be unknown is left out where it is: a record without a place is no
  // mistake.
  bool of_aircraft = false;
  const LeftOutReason* no_height = nullptr;   // what to say of such a record
  std::optional<std::size_t> label = {};      // what each is called beside its id: the flight
  std::optional<std::size_t> on_ground = {};  // of those that are left out
  std::optional<std::size_t> axes_name = {};  // of ROS: what x, y, z are counted in ("map")
  std::vector<UnitTaken> units = {};          // of positions and velocities
  std::vector<std::string> notes = {};
};

// The values of a report, in the order in which they are read.
struct TrackSlot {
  static constexpr std::size_t kId = 0;
  static constexpr std::size_t kTime = 1;
  static constexpr std::size_t kPosition = 2;  // three of them
  static constexpr std::size_t kVelocity = 5;  // three of them
  static constexpr std::size_t kLabel = 8;
  static constexpr std::size_t kOnGround = 9;
  static constexpr std::size_t kNanoseconds = 10;
  static constexpr std::size_t kAxesName = 11;
  static constexpr std::size_t kNothing = 12;  // where columns go that are not asked for
};

// By column: which slot it fills. An id may be read from a column that is something else too, but
// not the other way round.
std::vector<std::uint8_t> slots_of(const TrackLayout& layout);

// `text` has no byte-order mark. `bare_skybrush`: a table without a header is a Skybrush CSV.
// Errors: those of find_layout(), kInvalidArgument where a unit of time must be said,
// kUnsupportedFormat for a unit that is not read; with line, without source.
Result<TrackLayout> find_track_layout(std::string_view text, const RecordingOptions& options,
                                      bool bare_skybrush);

// The same for records whose columns are known already: `table` says how `text`, one or more of
// them, is split, and what the columns are called and hold. Errors without line.
Result<TrackLayout> choose_track_layout(TableLayout table, std::string_view text,
                                        const RecordingOptions& options);

}  // namespace beespace::io
