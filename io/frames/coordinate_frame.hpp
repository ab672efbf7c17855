// What the coordinates of an input are: degrees and metres, or metres along three axes.
#pragma once

#include <cstdint>

namespace beespace::io {

enum class Frame : std::uint8_t { kAuto, kWgs84, kMetres };

}  // namespace beespace::io
