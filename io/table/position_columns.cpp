#include "io/table/position_columns.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"

#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::string_view kMetreWords = "m meter meters metre metres metro metros mts";
constexpr std::string_view kArticles =
    "the of in de la el der die das du des dell della di l d le da do del las los les a von each "
    "cada";
constexpr std::string_view kBees = "abeja* bee* biene* abeille* abelha* ape api";

// A coordinate of a bee and nothing else: units and frames are for the general rules.
NamePattern course_coordinate() {
  NamePattern pattern;
  pattern.words = {
      {Says::kPart, "x", Role::kLongitude},
      {Says::kPart, "y", Role::kLatitude},
      {Says::kPart, "z", Role::kHeight},
      {Says::kNoun, "coord* koord*"},
      {Says::kQualifier, kBees},
      {Says::kConfirms, kMetreWords, Role::kHeight},
      {Says::kBeside, kArticles},
  };
  pattern.needed = Says::kPart | Says::kNoun | Says::kQualifier;
  pattern.course = true;
  return pattern;
}

NamePattern coordinate() {
  NamePattern pattern;
  pattern.words = {
      {Says::kPart, "lon long lng longitude", Role::kLongitude, "English"},
      {Says::kPart, "longitud", Role::kLongitude, "Spanish"},
      {Says::kPart, "laenge länge längengrad laengengrad", Role::kLongitude, "German"},
      {Says::kPart, "lengte lengtegraad", Role::kLongitude, "Dutch"},
      {Says::kPart, "longitudine", Role::kLongitude, "Italian"},
      {Says::kPart, "долгота", Role::kLongitude, "Russian"},
      {Says::kPart, "boylam", Role::kLongitude, "Turkish"},
      {Says::kPart, "lat latitude", Role::kLatitude, "English"},
      {Says::kPart, "latitud", Role::kLatitude, "Spanish"},
      {Says::kPart, "breite breitengrad", Role::kLatitude, "German"},
      {Says::kPart, "breedte breedtegraad", Role::kLatitude, "Dutch"},
      {Says::kPart, "latitudine", Role::kLatitude, "Italian"},
      {Says::kPart, "широта", Role::kLatitude, "Russian"},
      {Says::kPart, "enlem", Role::kLatitude, "Turkish"},
      {Says::kPart, "height altitude alt elevation elev", Role::kHeight, "English"},
      {Says::kPart | Says::kBeforeUnit, "h", Role::kHeight},  // "gs_km_h" is no height
      {Says::kPart, "altura altitud elevación elevacion", Role::kHeight, "Spanish"},
      {Says::kPart, "höhe hoehe", Role::kHeight, "German"},
      {Says::kPart, "hauteur élévation", Role::kHeight, "French"},
      {Says::kPart, "hoogte", Role::kHeight, "Dutch"},
      {Says::kPart, "quota altezza altitudine", Role::kHeight, "Italian"},
      {Says::kPart, "высота", Role::kHeight, "Russian"},
      {Says::kPart, "yükseklik", Role::kHeight, "Turkish"},
      {Says::kPart, "geoaltitude", Role::kHeight, "OpenSky", HeightDatum::kEllipsoid},
      // With its unit, as "altitudeAMSL [m]"; without it the source says what it is.
      {Says::kPart, "altitudeamsl", Role::kHeight, "QGroundControl", HeightDatum::kMeanSeaLevel},
      {Says::kPart, "baroaltitude", Role::kHeight, "OpenSky", HeightDatum::kPressure},
      {Says::kPart, "x", Role::kX},
      {Says::kPart, "y", Role::kY},
      {Says::kPart, "z", Role::kZ},
      {Says::kPart, "east easting", Role::kX, "surveying"},
      {Says::kPart, "north northing", Role::kY, "surveying"},
      {Says::kPart, "up", Role::kZ, "surveying"},
      // "LAT_N"
      {Says::kConfirms, "n", Role::kLatitude},
      {Says::kConfirms, "e", Role::kLongitude},
      {Says::kDegrees, "deg degree degrees grad grados ° dd"},
      {Says::kForeign, "rad radian radians"},
      {Says::kLength, "ecef enu ned local"},
      {Says::kBeside, "baro barometric pressure", Role::kNone, "aviation", HeightDatum::kPressure},
      {Says::kBeside, "geo geom geometric geodetic ellipsoidal ellipsoid", Role::kNone, "aviation",
       HeightDatum::kEllipsoid},
      {Says::kBeside, "msl amsl sealevel sea", Role::kNone, "aviation", HeightDatum::kMeanSeaLevel},
      {Says::kBeside, "level", Role::kNone, "sea level"},
      // "height-above-ellipsoid"
      {Says::kBeside, "above", Role::kNone, "Movebank"},
      {Says::kForeign, "px pixel pixels"},
      // What may stand beside a coordinate without changing what it is.
      {Says::kBeside, "gps wgs84 decimal drone aircraft coord* koord* hive comb"},
      {Says::kBeside, kBees},
      {Says::kBeside, kArticles},
      {0, "pos position"},
      {Says::kOther,
       "std sigma err error acc accuracy var cov delta diff rel vel speed velocity rate relative "
       "min max ref home start last prev base target next goal origin accel gyro mag force "
       "previous size old end first v"},
  };
  pattern.unit = UnitPlace::kAnywhere;
  pattern.prefix = true;
  return pattern;
}

// What tells bees apart: a word among others, or one of these alone.
NamePattern id_word() {
  NamePattern pattern;
  pattern.role = Role::kId;
  pattern.words = {
      {Says::kNoun, "id name identifier uuid label hexid", Role::kId, "English"},
      {Says::kNoun, "icao icao24 hex callsign", Role::kId, "aviation"},
      // Movebank's move and move2, Vectronic, and others who join the words.
      {Says::kNoun,
       "animalid individualid tagid ringid collarid deviceid sensorid transmitterid birdid fishid "
       "trackid trajectoryid particleid objectid agentid beeid collarserialnumber identity",
       Role::kId, "biology"},
      {Says::kNoun,
       "droneid uavid vehicleid robotid sysid systemid vehiclename dronename robotname", Role::kId,
       "robotics"},
      {Says::kNoun, "nombre", Role::kId, "Spanish"},
      {Says::kNoun, "nom", Role::kId, "French"},
      {Says::kOther, "frame child_frame", Role::kNone, "robotics"},  // whose axes, or which picture
  };
  pattern.needed = Says::kNoun;
  pattern.anything = true;
  return pattern;
}

NamePattern mover() {
  NamePattern pattern;
  pattern.role = Role::kId;
  pattern.words = {
      {Says::kNoun, "bee boid agent object", Role::kId, "English"},
      {Says::kNoun, "drone uav vehicle robot aircraft rigid-body rigidbody", Role::kId, "robotics"},
      {Says::kNoun, "uri", Role::kId, "Crazyflie"},  // "radio://0/80/2M/E7E7E7E7E1"
      {Says::kNoun,
       "animal individual subject fish bird ant bat insect mouse rat tag collar ring band "
       "transmitter",
       Role::kId, "biology"},
      {Says::kNoun, "particle trajectory", Role::kId, "particle tracking"},
      {Says::kNoun, "tier vogel ringnummer sendernummer roboter drohne", Role::kId, "German"},
      {Says::kNoun, "abeja", Role::kId, "Spanish"},
      {Says::kNoun, "biene", Role::kId, "German"},
      {Says::kNoun, "abeille", Role::kId, "French"},
  };
  pattern.needed = Says::kNoun;
  pattern.whole = true;
  return pattern;
}

ColumnSchema make_position_columns() {
  constexpr std::string_view kHeightStems =
      "*alt* *hei* *elev* *höhe* *hoeh* *hgt* *высот* *depth*";
  ColumnSchema schema;
  schema.roles = {
      {Role::kLongitude, "lon", "*lon* *lng* *läng* *laeng* *долг* *boylam*"},
      {Role::kLatitude, "lat", "*lat* *breit* *breed* *шир* *enlem*"},
      {Role::kHeight, "height", kHeightStems},
      {Role::kX, "x"},
      {Role::kY, "y"},
      {Role::kZ, "z", kHeightStems},
      {Role::kId, "id"},
  };
  schema.groups = {
      {"position", {Role::kLongitude, Role::kLatitude, Role::kHeight}, Frame::kWgs84},
      {"position", {Role::kX, Role::kY, Role::kZ}, Frame::kMetres},
  };
  schema.names = {course_coordinate(), coordinate(), mover(), id_word()};
  // "px", "x1", "e" and "n" among them.
  schema.hints =
      "*lat* *lon* *lng* *alt* *breit* *läng* *laeng* *шир* *долг* *enlem* *boylam* *heigh* *höhe* "
      "*hoehe* *выс* *elev* *coord* *koord* e n ?x x? ?y y? ?z z?";
  return schema;
}

bool names_height(std::string_view word) {
  return is_one_of("alt* hei* elev* hgt agl hagl", word);
}

}  // namespace

bool counts_from_takeoff(std::string_view name) {
  constexpr std::string_view kFromThere = "rel relative agl hagl takeoff home launch";
  const std::vector<std::string> words = split_words(name);
  bool height = false;
  bool from_there = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string pair = i == 0 ? "" : words[i - 1] + "-" + word;
    const bool joined = is_one_of(
        "relalt relaltitude relativealt relativealtitude relativeheight "
        "altrel altrelative altitudeabovehome altitudeaboveterr "
        "altituderelative altaboveground heightabovetakeoff",
        word);
    height = height || joined || names_height(word);
    from_there = from_there || joined || is_one_of(kFromThere, word) ||
                 is_one_of("take-off above-ground above-terrain", pair);
  }
  return height && from_there;
}

bool names_flight_level(std::string_view name) {
  return is_one_of("flight_level flightlevel flight_levels fl", plain_name(name));
}

const ColumnSchema& position_columns() {
  static const ColumnSchema schema = make_position_columns();
  return schema;
}

}  // namespace beespace::io
