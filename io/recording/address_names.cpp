#include "io/recording/address_names.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

// Perhaps behind the sign of those that are none of the ICAO's, "~3c6444". Sets `letters` where
// there are some, which may be capitals or not.
bool is_address(std::string_view id, bool& letters) {
  constexpr std::size_t kDigits = 6;
  if (id.starts_with('~')) id.remove_prefix(1);
  letters = false;
  if (id.size() != kDigits) return false;
  return std::all_of(id.begin(), id.end(), [&letters](char c) {
    const bool letter = (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    letters = letters || letter;
    return letter || (c >= '0' && c <= '9');
  });
}

}  // namespace

bool names_address(std::string_view column) {
  return is_one_of(
      "icao24 icao hex hexid hex_id icao_24 icao_address icao24_address icao_hex "
      "hex_code hexcode mode_s modes mode_s_address",
      plain_name(column));
}

std::string_view AddressNames::name_of(std::string_view id) {
  bool letters = false;
  if (!is_address(id, letters) || !letters) return id;
  key_ = lower_case(id);
  const auto [known, first] = names_.try_emplace(key_, Name{std::string(id)});
  Name& name = known->second;
  if (!first && !name.twice && name.text != id) {
    name.twice = true;
    if (spelt_twice_++ == 0) example_ = id;
  }
  return name.text;
}

}  // namespace beespace::io
