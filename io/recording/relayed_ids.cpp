#include "io/recording/relayed_ids.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <cstdint>

namespace beespace::io {
namespace {

bool is_relayed(const RecordedBee& bee) {
  return bee.id.size() > 1 && bee.id.front() == '~';
}

}  // namespace

std::optional<std::string> relayed_ids_note(const std::vector<RecordedBee>& bees) {
  const auto relayed = std::count_if(bees.begin(), bees.end(), is_relayed);
  if (relayed == 0) return std::nullopt;
  const auto has_twin = [&bees](const RecordedBee& bee) {
    return is_relayed(bee) && std::any_of(bees.begin(), bees.end(), [&](const auto& other) {
             return other.id == bee.id.substr(1);
           });
  };
  auto shown = std::find_if(bees.begin(), bees.end(), has_twin);
  const bool twin = shown != bees.end();
  if (!twin) shown = std::find_if(bees.begin(), bees.end(), is_relayed);
  return counted(static_cast<std::uint64_t>(relayed), "id begins", "ids begin") +
         " with ~, as readsb marks what the ground tells (TIS-B, ADS-R): " + excerpt(shown->id) +
         (twin ? " and " + excerpt(shown->id.substr(1)) + " may be the same aircraft"
               : std::string(
                     " may be the same aircraft as one that is here under its own address")) +
         " (then a conflict of the two is none); of aircraft.json jq 'del(.aircraft[] | "
         "select(.hex | "
         "startswith(\"~\")))' FILE leaves such out";
}

}  // namespace beespace::io
