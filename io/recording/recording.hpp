// What was recorded: bees with their ids, and where each was when.
//
// Positions are as the input gives them: metres (z up), or longitude and latitude in degrees (x and
// y) and height in metres (z). Heights that the input states in another unit are kept beside that.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/show_facts.hpp"
#include "io/recording/stated_accuracy.hpp"
#include "io/recording/wall_clock.hpp"
#include "io/units/heights.hpp"
#include "io/units/time_zone.hpp"
#include "io/units/unit_taken.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/conflict.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

struct RecordedBee {
  std::string id;
  std::vector<Fix> fixes;  // of strictly ascending times
  // One for each fix, or none: m/s along x, y, z, or east, north, up; not-a-number where unknown.
  std::vector<Velocity> velocities = {};
  // Heights as the input states them, in Recording::height_unit: one for each fix, or none where
  // that is the metre.
  std::vector<double> stated_heights = {};
  std::optional<BezierPath> path = {};  // instead of fixes, where the input has a curve
  // Instead of both, of a drone of a show that never takes off: where it stands all the time.
  std::optional<Point> stands = {};
  // Of aircraft that say so in records which are left out: until when they stand on the ground
  // before the first fix, and since when after the last one.
  std::optional<double> on_ground_until_s = {};
  std::optional<double> on_ground_from_s = {};
  std::optional<double> on_ground_heard_s = {};  // of the latter: when it last said so
  // Of a drone whose autopilot says when it has landed: when it surely stands, in ascending order.
  // Its fixes are kept: others may fly close to it.
  std::vector<TimeSpan> landed = {};
  // The height from which it took off, as its records say.
  std::optional<double> took_off_at_m = {};
  bool on_surface = false;  // it drives or swims, by its own word
  bool shared = false;      // two or more seem to have its id (see MissingRecords::shared)
  // Since when, and until when, it has records without a place, if it has any.
  std::optional<double> unplaced_from_s = {};
  std::optional<double> unplaced_until_s = {};
  // Of a cut of a sector: when it has such records, or none of a position at all, before its first
  // fix and after its last one; of several at one time one.
  std::vector<double> beside_s = {};
  // How often one of its fixes was said again, and of these how often its last one, as feeds do
  // that keep an aircraft for a while when they hear nothing more of it.
  std::uint64_t repeats = 0;
  std::uint64_t repeats_of_last = 0;
  // From a fix to the next one, where there are two records without a place between them, or more.
  std::vector<TimeSpan> lost = {};
  // What it is called beside its id: the flight, or several, one after the other; or nothing.
  std::string label = {};
  // Of several: since when it is called each, in order of time; of one, nothing.
  struct Called {
    double since_s;
    std::string label;
  };
  std::vector<Called> called = {};
};

// Records that were there but are left out, since their place, height or time is missing or bad:
// what is said of the others is not of all. Those that are known to be harmless do not count, as of
// aircraft on the ground, or the same fix said twice.
struct MissingRecords {
  std::uint64_t count = 0;
  std::uint64_t without_id = 0;          // of these: whose bee is not known
  std::uint64_t bees = 0;                // of how many bees the others are
  std::uint64_t nowhere = 0;             // how many of these bees have no known place at all
  std::vector<std::string> nowhere_ids;  // of the first kMostNamed of them

  // Ids that two bees seem to share (see shared_id.hpp): of none of these is it known where they
  // are, though their records are there. None of them counts above.
  std::uint64_t shared = 0;
  std::vector<std::string> shared_ids = {};  // of the first kMostNamed of them

  // Files and folders beside those that are read, whose names do not say that they are harmless
  // (see left_out_files.hpp). Their records do not count above.
  std::uint64_t files = 0;
  std::vector<std::string> file_names = {};  // of the first kMostNamed of them

  // Ids of bees that jump (see jumps.hpp): of none of these is it known where they are all the
  // time.
  std::uint64_t jumping = 0;
  std::vector<std::string> jumping_ids = {};  // of the first kMostNamed of them

  // Bees whose longitude and latitude seem to be under each other's name (see swapped_degrees.hpp):
  // they may be somewhere else. None of them counts above.
  std::uint64_t swapped = 0;

  // Vehicles whose own clock is not believed (see boot_clock.hpp): they were where they say at some
  // time before that came. None of them counts above.
  std::uint64_t untimed = 0;

  // Bees with places that are off by kilometres, as those of Argos are. None of them counts above.
  std::uint64_t rough = 0;

  // Whether all that was there is known.
  [[nodiscard]] bool none() const {
    return count == 0 && shared == 0 && files == 0 && jumping == 0 && swapped == 0 &&
           untimed == 0 && rough == 0;
  }

  static constexpr std::size_t kMostNamed = 3;
};

struct Recording {
  std::vector<RecordedBee> bees;   // in the order in which the input names them first
  Frame frame = Frame::kMetres;    // what the input was taken for: never kAuto
  std::string frame_reason;        // why, as a phrase
  std::string format_description;  // "text, comma-separated", "Skybrush show", ...
  bool since_1970 = false;  // times are seconds since 1970 (UTC), not from a zero of their own
  std::optional<WallClock> clock;     // or from a midnight of a clock whose zone is not known
  std::optional<TimeZone> time_zone;  // in which people are told times since 1970; none: UTC
  bool flat = false;                  // no input has heights: every z, or height, is 0
  HeightDatum heights = HeightDatum::kUnstated;
  Unit height_unit = Unit::kMetre;             // of RecordedBee::stated_heights
  std::vector<UnitTaken> units;                // of what was read; heights (or z) are among them
  std::optional<double> declared_threshold_m;  // the least distance that a show promises; 0: none
  // When the input itself was written, where it says so beside the times of its positions: its
  // present moment. Of several inputs the latest.
  std::optional<double> written_s = {};
  // It is asked about as a cut of a sector: before its first fix and after its last one a bee is
  // outside, and nothing is asked about it.
  bool sector = false;
  bool of_aircraft = false;    // its format or its columns say so
  bool of_animals = false;     // some of it is, by what wrote it
  bool of_drones = false;      // all of it is what autopilots logged
  bool called_drones = false;  // by the columns of tables, of all of it
  // "--columns lon=4,lat=3,height=6 --crs wgs84": what takes the heights above the place of
  // take-off that a table has beside those that are taken, if it has any.
  std::string heights_beside = {};
  bool y_is_down = false;  // all of it is counted as in a picture, from the corner above
  // It says how each flies from its last fix on, as a scenario of a simulator does: none is ever
  // out of reach.
  bool flies_on = false;
  std::optional<ShowFacts> show = {};  // of drone shows: plans, not what was flown
  std::vector<std::string> notes;      // what else was decided and must be told
  std::vector<Error> skipped;          // with skip_bad: the first bad records
  std::uint64_t skipped_count = 0;
  MissingRecords missing;  // bad records that were skipped are among them
  StatedAccuracy accuracy = {};
  std::uint64_t bytes = 0;
  // Where of each bee the ends alone are kept: the least and the greatest coordinates of all
  // places.
  struct Reach {
    Point least;
    Point greatest;
  };
  std::optional<Reach> reach = {};
};

}  // namespace beespace::io
