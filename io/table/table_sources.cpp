#include "io/table/table_sources.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace beespace::io {
namespace {

// A column that the source may leave out.
KnownColumn perhaps(std::string_view name, Role role, Unit unit = Unit::kUnstated,
                    HeightDatum datum = HeightDatum::kUnstated) {
  return {name, role, unit, datum, false};
}

// What state vectors of OpenSky have, in units of the SI or not.
constexpr std::string_view kNotOfTraffic =
    "velocity vertrate baroaltitude origin_country position_source sensors";

// A table of the history of OpenSky: "velocity" beside "icao24" and such heights is of no other
// one, whichever of its columns were left out.
TableSource history_of_opensky(std::vector<KnownColumn> columns) {
  columns.push_back(perhaps("time", Role::kTime, Unit::kSecond));
  columns.push_back(perhaps("heading", Role::kTrack));
  columns.push_back(perhaps("vertrate", Role::kClimb, Unit::kMetrePerSecond));
  TableSource source{"OpenSky", "groundspeed vertical_rate altitude alt_baro alt_geom",
                     std::move(columns)};
  source.since_1970 = true;
  return source;
}

// State vectors as the live interface of OpenSky (REST) names them, written as a table by hand:
// "true_track" beside "icao24" and "velocity" is of no other one.
TableSource states_of_opensky() {
  TableSource source{
      "OpenSky's live interface",
      "groundspeed track heading altitude alt_baro alt_geom",
      {{"icao24"},
       {"velocity", Role::kGroundSpeed, Unit::kMetrePerSecond},
       {"true_track", Role::kTrack},
       perhaps("time_position", Role::kTime, Unit::kSecond),
       perhaps("vertical_rate", Role::kClimb, Unit::kMetrePerSecond),
       perhaps("baro_altitude", Role::kHeight, Unit::kMetre, HeightDatum::kPressure),
       perhaps("geo_altitude", Role::kHeight, Unit::kMetre, HeightDatum::kEllipsoid)}};
  source.since_1970 = true;
  return source;
}

// A flight as Flightradar24 exports it (CSV), whose headers say no units: they are feet and knots.
TableSource flightradar24() {
  TableSource source{kFlightradar24,
                     "",
                     {{"timestamp", Role::kTime, Unit::kSecond},
                      {"utc"},
                      {"callsign", Role::kId},
                      {"position"},
                      {"altitude", Role::kHeight, Unit::kFoot, HeightDatum::kPressure},
                      {"speed", Role::kGroundSpeed, Unit::kKnot},
                      {"direction", Role::kTrack}}};
  source.since_1970 = true;
  return source;
}

// Positions as the data service of Flightradar24 delivers them, a file a flight that is called
// after it: heights in feet, speeds in knots; the id is that of the receiver that heard it.
TableSource delivery_of_flightradar24() {
  TableSource source{"the data service of Flightradar24",
                     "",
                     {{"snapshot_id", Role::kTime, Unit::kSecond},
                      {"altitude", Role::kHeight, Unit::kFoot, HeightDatum::kPressure},
                      {"heading", Role::kTrack},
                      {"latitude"},
                      {"longitude"},
                      {"radar_id"},
                      {"speed", Role::kGroundSpeed, Unit::kKnot}}};
  source.since_1970 = true;
  source.ground_at_zero = true;
  source.of_aircraft = true;
  source.no_id = "radar_id";
  return source;
}

// Live positions as the interface of Flightradar24 gives them (JSON): heights by pressure, in feet,
// speeds in knots and climb rates in feet per minute, as its documentation says.
TableSource positions_of_flightradar24() {
  TableSource source{"the interface of Flightradar24",
                     "",
                     {{"fr24_id"},
                      perhaps("hex", Role::kId),
                      perhaps("fr24_id", Role::kId),
                      {"lat"},
                      {"lon"},
                      {"track", Role::kTrack},
                      {"alt", Role::kHeight, Unit::kFoot, HeightDatum::kPressure},
                      {"gspeed", Role::kGroundSpeed, Unit::kKnot},
                      {"vspeed", Role::kClimb, Unit::kFootPerMinute},
                      {"timestamp", Role::kTime}}};
  source.ground_at_zero = true;
  return source;
}

// traffic: https://traffic-viz.github.io (columns of its Flight and Traffic tables). State vectors
// of OpenSky come from pyopensky and from traffic under the same names, in other units.
// OpenSky: the history tables state_vectors_data4, as its documentation lists them.
// BlueSky: its logs (bluesky/tools/datalog.py), which are in units of the SI.
// Movebank: its attribute dictionary (https://www.movebank.org/cms/movebank-content/
// movebank-attribute-dictionary); packages of R write dots for its hyphens. Times are UTC.
// TRex: https://trex.run/docs/formats.html; a file an individual. Of several places of a body that
// of the weighted centroid is taken; where it was not seen they are infinite.
// PX4: vehicle_global_position, and vehicle_local_position, as ulog2csv of pyulog writes them.
// Their times are those of each drone. QGroundControl: the table beside each .tlog, in the units of
// its settings.
// Telonics: its Data Converter (TDC), complete or condensed reports; the position is that of the
// time of the fix, where there is one, which may be a minute after the acquisition time. Wildlife
// Computers: -Locations.csv of its data portal, whose times are UTC. Axy-Trek of TechnoSmart: X, Y,
// Z are accelerations.
std::span<const TableSource> known_sources() {
  static const auto sources = std::to_array<TableSource>(
      {TableSource{kTraffic,
                   kNotOfTraffic,
                   {{"icao24"},
                    {"groundspeed", Role::kGroundSpeed, Unit::kKnot},
                    {"track", Role::kTrack},
                    {"vertical_rate", Role::kClimb, Unit::kFootPerMinute},
                    {"altitude", Role::kHeight, Unit::kFoot, HeightDatum::kPressure},
                    {"geoaltitude", Role::kHeight, Unit::kFoot, HeightDatum::kEllipsoid}}},
       TableSource{
           kTraffic,  // without heights above the ellipsoid: all these together are no other's
           kNotOfTraffic,
           {{"timestamp"},
            {"icao24"},
            {"callsign"},
            {"latitude"},
            {"longitude"},
            {"groundspeed", Role::kGroundSpeed, Unit::kKnot},
            {"track", Role::kTrack},
            {"vertical_rate", Role::kClimb, Unit::kFootPerMinute},
            {"altitude", Role::kHeight, Unit::kFoot, HeightDatum::kPressure}}},
       TableSource{kTraffic,  // where addresses and callsigns may have been left out
                   kNotOfTraffic,
                   {{"timestamp"},
                    perhaps("flight_id", Role::kId),
                    {"latitude"},
                    {"longitude"},
                    {"groundspeed", Role::kGroundSpeed, Unit::kKnot},
                    {"track", Role::kTrack},
                    {"vertical_rate", Role::kClimb, Unit::kFootPerMinute},
                    {"altitude", Role::kHeight, Unit::kFoot, HeightDatum::kPressure},
                    {"geoaltitude", Role::kHeight, Unit::kFoot, HeightDatum::kEllipsoid}}},
       TableSource{
           "OpenSky",
           "velocity vertrate baroaltitude",
           {{"icao24"},
            {"origin_country"},
            {"groundspeed", Role::kGroundSpeed},
            {"track", Role::kTrack},
            {"vertical_rate", Role::kClimb},
            {"altitude", Role::kHeight, Unit::kUnstated, HeightDatum::kPressure},
            perhaps("geoaltitude", Role::kHeight, Unit::kUnstated, HeightDatum::kEllipsoid)},
           false,
           false,
           false,
           false,
           false,
           "State vectors of OpenSky have such columns: pyopensky writes them in metres, "
           "and traffic in feet and knots"},
       history_of_opensky(
           {{"icao24"},
            {"velocity", Role::kGroundSpeed, Unit::kMetrePerSecond},
            {"baroaltitude", Role::kHeight, Unit::kMetre, HeightDatum::kPressure},
            perhaps("geoaltitude", Role::kHeight, Unit::kMetre, HeightDatum::kEllipsoid)}),
       history_of_opensky({{"icao24"},
                           {"velocity", Role::kGroundSpeed, Unit::kMetrePerSecond},
                           {"geoaltitude", Role::kHeight, Unit::kMetre, HeightDatum::kEllipsoid}}),
       states_of_opensky(),
       TableSource{"PX4 (ulog2csv)",
                   "",
                   {{"timestamp", Role::kTime, Unit::kMicrosecond},
                    {"lat"},
                    {"lon"},
                    {"alt", Role::kHeight, Unit::kMetre, HeightDatum::kMeanSeaLevel},
                    {"alt_ellipsoid", Role::kHeight, Unit::kMetre, HeightDatum::kEllipsoid}},
                   false,
                   false,
                   false,
                   false,
                   true},
       TableSource{"PX4 (ulog2csv)",
                   "",
                   {{"timestamp", Role::kTime, Unit::kMicrosecond},
                    {"x"},
                    {"y"},
                    {"z"},
                    {"ref_lat"},
                    {"ref_lon"},
                    {"ref_alt"}},
                   false,
                   false,
                   false,
                   false,
                   true},
       TableSource{kQGroundControl,
                   "",
                   {{"timestamp"},
                    {"altituderelative"},
                    {"altitudeamsl", Role::kHeight, Unit::kUnstated, HeightDatum::kMeanSeaLevel},
                    {"gps_lat"},
                    {"gps_lon"}},
                   false,
                   false,
                   false,
                   false,
                   false,
                   "QGroundControl writes it as its settings say"},
       TableSource{"BlueSky",
                   "",
                   {{"simt", Role::kTime, Unit::kSecond},
                    {"id", Role::kId},
                    {"lat"},
                    {"lon"},
                    perhaps("alt", Role::kHeight, Unit::kMetre, HeightDatum::kPressure),
                    perhaps("gs", Role::kGroundSpeed, Unit::kMetrePerSecond),
                    perhaps("trk", Role::kTrack),
                    perhaps("vs", Role::kClimb, Unit::kMetrePerSecond)}},
       TableSource{"BlueSky",  // with the name of what has the column before it, as in traf.alt
                   "",
                   {{"simt", Role::kTime, Unit::kSecond},
                    {"traf_id", Role::kId},
                    {"traf_lat"},
                    {"traf_lon"},
                    perhaps("traf_alt", Role::kHeight, Unit::kMetre, HeightDatum::kPressure),
                    perhaps("traf_gs", Role::kGroundSpeed, Unit::kMetrePerSecond),
                    perhaps("traf_trk", Role::kTrack),
                    perhaps("traf_vs", Role::kClimb, Unit::kMetrePerSecond)}},
       TableSource{
           "Movebank",
           "",
           {{"timestamp"},
            {"location_long"},
            {"location_lat"},
            perhaps("individual_local_identifier", Role::kId),
            perhaps("individual_id", Role::kId),
            perhaps("tag_local_identifier", Role::kId),
            perhaps("tag_id", Role::kId),
            perhaps("height_above_ellipsoid", Role::kHeight, Unit::kMetre, HeightDatum::kEllipsoid),
            perhaps("height_above_msl", Role::kHeight, Unit::kMetre, HeightDatum::kMeanSeaLevel),
            perhaps("ground_speed", Role::kGroundSpeed, Unit::kMetrePerSecond),
            perhaps("heading", Role::kTrack)},
           true,
           true},
       TableSource{"Telonics",
                   "",
                   {{"gps_fix_time", Role::kTime},
                    {"acquisition_time"},
                    {"gps_fix_attempt"},
                    {"gps_latitude"},
                    {"gps_longitude"}},
                   false,
                   true},
       TableSource{"Telonics",
                   "",
                   {{"acquisition_time", Role::kTime},
                    {"acquisition_start_time"},
                    {"gps_fix_attempt"},
                    {"gps_latitude"},
                    {"gps_longitude"}},
                   false,
                   true},
       TableSource{
           "Ornitela",
           "",
           {{"device_id", Role::kId},
            {"utc_datetime", Role::kTime},
            {"datatype"},
            {"satcount"},
            {"latitude"},
            {"longitude"},
            perhaps("msl_altitude_m", Role::kHeight, Unit::kMetre, HeightDatum::kMeanSeaLevel)},
           true,
           true},
       TableSource{"Druid",
                   "",
                   {{"uuid"},
                    {"collecting_time", Role::kTime},
                    {"transmitting_time"},
                    {"longitude"},
                    {"latitude"},
                    perhaps("altitude", Role::kHeight, Unit::kMetre)},
                   true,
                   true},
       TableSource{"Wildlife Computers",
                   "",
                   {{"deployid", Role::kId},
                    {"ptt", Role::kId},
                    {"date", Role::kTime},
                    {"type"},
                    {"quality"},
                    {"latitude"},
                    {"longitude"}},
                   true,
                   true},
       TableSource{
           "Axy-Trek",
           "",
           {{"tagid", Role::kId},
            {"timestamp"},
            {"x"},
            {"y"},
            {"z"},
            {"location_lat"},
            {"location_lon"},
            perhaps("height_above_msl", Role::kHeight, Unit::kMetre, HeightDatum::kMeanSeaLevel)},
           false,
           true},
       TableSource{"TRex",
                   "",
                   {{"frame"},
                    {"missing"},
                    {"time", Role::kTime, Unit::kSecond},
                    perhaps("x_wcentroid_cm", Role::kX, Unit::kCentimetre),
                    perhaps("y_wcentroid_cm", Role::kY, Unit::kCentimetre),
                    perhaps("x_cm", Role::kX, Unit::kCentimetre),
                    perhaps("y_cm", Role::kY, Unit::kCentimetre)},
                   false,
                   true,
                   true},
       flightradar24(),
       delivery_of_flightradar24(),
       positions_of_flightradar24()});
  return sources;
}

bool has_name(const std::vector<std::string>& names, std::string_view wanted) {
  return std::any_of(names.begin(), names.end(),
                     [wanted](const std::string& name) { return plain_name(name) == wanted; });
}

bool is_header_of(const TableSource& source, const std::vector<std::string>& names) {
  const auto there = [&names](const KnownColumn& column) {
    return !column.needed || has_name(names, column.name);
  };
  if (!std::all_of(source.columns.begin(), source.columns.end(), there)) return false;
  return std::none_of(names.begin(), names.end(), [&source](const std::string& name) {
    return is_one_of(source.contrary, plain_name(name));
  });
}

}  // namespace

const KnownColumn* TableSource::find(std::string_view column) const {
  const std::string plain = plain_name(column);
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&plain](const KnownColumn& known) {
        const bool says_more = known.unit != Unit::kUnstated || known.role == Role::kTrack ||
                               known.role == Role::kTime || known.role == Role::kId ||
                               known.datum != HeightDatum::kUnstated;
        return says_more && known.name == plain;
      });
  return found == columns.end() ? nullptr : &*found;
}

std::optional<std::size_t> TableSource::first(Role role,
                                              const std::vector<std::string>& names) const {
  for (const KnownColumn& known : columns) {
    if (known.role != role) continue;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (plain_name(names[i]) == known.name) return i;
    }
  }
  return std::nullopt;
}

const TableSource* source_of(const std::vector<std::string>& names) {
  for (const TableSource& source : known_sources()) {
    if (is_header_of(source, names)) return &source;
  }
  return nullptr;
}

}  // namespace beespace::io
