#include "io/tracks/track_columns.hpp"

#include "io/table/position_columns.hpp"

#include <utility>

namespace beespace::io {
namespace {

NamePattern time_names() {
  NamePattern pattern;
  pattern.role = Role::kTime;
  pattern.words = {
      {Says::kNoun | Says::kJoined, "time timestamp", Role::kTime, "English"},
      {Says::kNoun, "t timestamps ts datetime stamp", Role::kTime, "English"},
      {Says::kNoun, "simt", Role::kTime, "BlueSky"},
      {Says::kNoun, "zeit uhrzeit", Role::kTime, "German"},
      {Says::kNoun, "tiempo hora", Role::kTime, "Spanish"},
      {Says::kNoun, "temps heure", Role::kTime, "French"},
      {Says::kNoun, "tempo ora", Role::kTime, "Italian, Portuguese"},
      {Says::kForeign,
       "min mins minute minutes h hr hour hours d day days tow ticks frames jd mjd"},
      {Says::kSince1970, "unix posix epoch 1970"},
      {Says::kBeside,
       "since start elapsed over utc iso iso8601 8601 rfc3339 boot begin sim simulation in of the "
       "from acq "
       "flight mission sample header field message msg ros date datum fecha gmt "
       // Druid: when a place was taken, not when it was sent.
       "collecting"},
  };
  pattern.needed = Says::kNoun;
  pattern.unit = UnitPlace::kAnywhere;
  pattern.quantity = Quantity::kTime;
  pattern.unit_alone = true;
  return pattern;
}

// When the position of a record was measured, which may be long before the record was written:
// "lastposupdate" of OpenSky, "last_position" of traffic.
NamePattern position_time_names() {
  NamePattern pattern;
  pattern.words = {
      {Says::kPart,
       "lastposupdate last-pos-update lastpositionupdate last-position-update last-position "
       "lastposition time-position timeposition position-time",
       Role::kPositionTime, "OpenSky, traffic"},
  };
  pattern.whole = true;
  pattern.unit = UnitPlace::kLast;
  pattern.quantity = Quantity::kTime;
  return pattern;
}

// Times of a zone, by its name alone, and of the clocks of a place: whole names.
NamePattern zone_time_names() {
  NamePattern pattern;
  pattern.words = {
      {Says::kNoun, "utc gmt", Role::kTime, "of a zone"},
      {Says::kNoun,
       "lmt lmt-time lmt-datetime time-lmt local local-time localtime time-local local-datetime "
       "local-date-time localdatetime datetime-local date-time-local local-timestamp "
       "localtimestamp timestamp-local timestamplocal",
       Role::kTime, "of a place"},
  };
  pattern.needed = Says::kNoun;
  pattern.whole = true;
  return pattern;
}

// "date", "UTC_date", "Datum".
NamePattern date_names() {
  NamePattern pattern;
  pattern.role = Role::kDate;
  pattern.words = {
      {Says::kNoun, "date day", Role::kDate, "English"},
      {Says::kNoun, "datum", Role::kDate, "German"},
      {Says::kNoun, "fecha", Role::kDate, "Spanish"},
      {Says::kNoun, "data", Role::kDate, "Italian, Portuguese"},
      {Says::kBeside, "utc gps gmt"},
  };
  pattern.needed = Says::kNoun;
  return pattern;
}

// Of tables made of videos. A "frame_id" names the axes.
NamePattern frame_names() {
  NamePattern pattern;
  pattern.words = {
      {Says::kPart,
       "frame frames frame-number frame-no frame-nr frame-num frame-index frame-idx framenumber "
       "frameno framenr frameindex frameidx image-number imagenumber",
       Role::kFrame, "video tracking"},
  };
  pattern.whole = true;
  return pattern;
}

// "groundspeed", "ground_speed_kt", "gs", "vertical_rate", "climb rate [ft/min]".
NamePattern speeds_over_ground() {
  NamePattern pattern;
  pattern.words = {
      {Says::kPart, "groundspeed ground-speed gs", Role::kGroundSpeed, "aviation"},
      {Says::kPart, "speed-over-ground", Role::kGroundSpeed, "shipping"},
      {Says::kPart,
       "vertical-rate verticalrate vert-rate vertrate vertical-speed climb-rate climb "
       "rate-of-climb roc rocd baro-rate geom-rate v-s",
       Role::kClimb, "aviation"},
  };
  pattern.whole = true;
  pattern.unit = UnitPlace::kLast;
  pattern.quantity = Quantity::kSpeed;
  return pattern;
}

NamePattern directions_over_ground() {
  NamePattern pattern;
  pattern.words = {
      {Says::kPart, "track track-deg track-degrees track-\u00b0 true-track track-angle",
       Role::kTrack, "aviation"},
      {Says::kPart, "course-over-ground cog", Role::kTrack, "shipping"},
  };
  pattern.whole = true;
  return pattern;
}

ColumnSchema make_track_columns() {
  const ColumnSchema& position = position_columns();
  ColumnSchema schema = position;
  schema.roles = {
      {Role::kId, "id"},
      {Role::kTime, "time",
       "*time* *date* *stamp* *clock* *epoch* *zeit* *hora* *temps* *utc* *gmt* *lmt* *local*"},
      {Role::kDate, "date"},
      {Role::kFrame, "frame"},
  };
  for (const RoleFacts& facts : position.roles) {
    if (facts.role != Role::kId) schema.roles.push_back(facts);
  }
  constexpr std::array<std::string_view, 6> kVelocities = {"vx", "vy", "vz", "ve", "vn", "vu"};
  for (std::size_t i = 0; i < kVelocities.size(); ++i) {
    schema.roles.push_back({part_of(Role::kVelocityX, i % 3), kVelocities[i]});
  }
  schema.groups.push_back(
      {"velocity",
       {Role::kVelocityX, Role::kVelocityY, Role::kVelocityZ},
       Frame::kAuto,
       "a velocity needs vx and vy (or ve and vn), and vz (vu) where bees climb"});
  schema.names = {
      position_time_names(), time_names(),     date_names(),         zone_time_names(),
      frame_names(),         velocity_names(), speeds_over_ground(), directions_over_ground()};
  schema.names.insert(schema.names.end(), position.names.begin(), position.names.end());
  return schema;
}

}  // namespace

NamePattern velocity_names() {
  constexpr unsigned kBoth = Says::kNoun | Says::kPart;
  NamePattern pattern;
  pattern.words = {
      {Says::kPart, "x", Role::kVelocityX},
      {Says::kPart, "y", Role::kVelocityY},
      {Says::kPart, "z", Role::kVelocityZ},
      {Says::kPart, "e east", Role::kVelocityEast},
      {Says::kPart, "n north", Role::kVelocityNorth},
      {Says::kPart, "u up", Role::kVelocityUp},
      {Says::kPart, "d down", Role::kVelocityDown},
      {kBoth, "vx", Role::kVelocityX},
      {kBoth, "vy", Role::kVelocityY},
      {kBoth, "vz", Role::kVelocityZ},
      {kBoth, "ve", Role::kVelocityEast},
      {kBoth, "vn", Role::kVelocityNorth},
      {kBoth, "vu", Role::kVelocityUp},
      {kBoth, "vd", Role::kVelocityDown},
      {Says::kNoun, "v vel velocity speed", Role::kNone, "English"},
      {Says::kNoun, "velocidad", Role::kNone, "Spanish"},
      {Says::kNoun, "vitesse", Role::kNone, "French"},
      {Says::kNoun, "geschwindigkeit", Role::kNone, "German"},
      {Says::kNoun, "velocita", Role::kNone, "Italian"},
      {Says::kForeign, "min h hr hour minute"},
  };
  pattern.needed = kBoth;
  pattern.unit = UnitPlace::kLast;
  pattern.quantity = Quantity::kSpeed;
  return pattern;
}

const ColumnSchema& track_columns() {
  static const ColumnSchema schema = make_track_columns();
  return schema;
}

}  // namespace beespace::io
