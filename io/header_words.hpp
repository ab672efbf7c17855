// What the name of a column says: which coordinate it holds, in which unit, in which frame.
//
// Words are looked for as whole tokens, in any case, in several languages: "lat", "GPS latitude",
// "longitud [deg]", "alt_m", "Coordenada x de la abeja".
#pragma once

#include "io/load_points.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

enum class Role : std::uint8_t { kNone, kLongitude, kLatitude, kHeight, kX, kY, kZ, kId };

struct HeaderWord {
  Role role = Role::kNone;
  // The frame that this name alone speaks for; kAuto when it does not say.
  Frame frame = Frame::kAuto;
  bool course_format = false;     // a coordinate of a bee, as in the course files
  std::string foreign_unit = {};  // a unit that is not read: "ft", "km", ...
};

HeaderWord read_header_word(std::string_view name);

}  // namespace beespace::io
