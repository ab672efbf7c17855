#include "io/problems/json_kind.hpp"

#include <array>
#include <cstddef>

namespace beespace::io {
namespace {

constexpr std::size_t kFrontOfJson = std::size_t{1} << 16;

struct Kind {
  std::string_view key;  // in quotes
  std::string_view words;
};

// The keys that say more first: shows have "settings", and so may anything.
constexpr std::array<Kind, 13> kKinds = {{
    {"\"obstacles\"",
     "JSON with obstacles; give it with --obstacles to 'beespace simulate', 'advise' or 'verify'"},
    {"\"number_of_animals\"",
     "JSON that describes a session of idtracker.ai, without the places; make CSV of its "
     "trajectories: idtrackerai_csv FOLDER, with the folder of the session"},
    {"\"FeatureCollection\"",
     "GeoJSON, which beespace writes and does not read; export the positions as CSV"},
    {"\"Feature\"",
     "GeoJSON, which beespace writes and does not read; export the positions as CSV"},
    {"\"aircraft\"",
     "JSON with aircraft (readsb, dump1090); 'beespace replay' and 'beespace predict' read it"},
    {"\"states\"",
     "JSON with state vectors (OpenSky); 'beespace replay' and 'beespace predict' read it"},
    {"\"performances\"", "JSON of a drone show (VVIZ); 'beespace replay' reads it"},
    {"\"swarm\"", "JSON of a Skybrush show; 'beespace replay' reads it"},
    {"\"trajectory\"",
     "JSON of a Skybrush trajectory, which is a part of a show; 'beespace replay' reads the show"},
    {"\"hex\"", "JSON of aircraft, an object a line; 'beespace watch' reads it"},
    {"\"lat\"",
     "JSON with a table of positions; 'beespace replay' and 'beespace predict' read it, and "
     "'beespace watch' where each is an object on a line"},
    {"\"latitude\"",
     "JSON with a table of positions; 'beespace replay' and 'beespace predict' read it, and "
     "'beespace watch' where each is an object on a line"},
    {"\"time_s\"",
     "JSON with a table of positions; 'beespace replay' and 'beespace predict' read it, and "
     "'beespace watch' where each is an object on a line"},
}};

}  // namespace

std::string json_words(std::string_view text) {
  const std::string_view front = text.substr(0, kFrontOfJson);
  for (const Kind& kind : kKinds) {
    if (front.find(kind.key) != std::string_view::npos) return std::string(kind.words);
  }
  return "JSON of a kind that beespace does not know; export the positions as CSV with a header "
         "such as id,lon,lat,height or id,x,y,z";
}

}  // namespace beespace::io
