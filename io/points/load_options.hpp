// How a snapshot is to be read.
#pragma once

#include "io/bytes/progress.hpp"
#include "io/frames/coordinate_frame.hpp"
#include "io/units/heights.hpp"
#include "io/units/unit_wishes.hpp"

#include <cstdint>
#include <string>

namespace beespace::io {

enum class Format : std::uint8_t { kAuto, kText, kNpy, kRawFloat64 };

struct LoadOptions {
  Frame frame = Frame::kAuto;
  Format format = Format::kAuto;
  bool format_can_be_said = false;  // whether an error may advise to say --format
  std::string columns = {};  // "lon=1,lat=2,height=3", by number (from 1) or name; empty: automatic
  UnitWishes units = {};     // where the header names none
  HeightSource heights = HeightSource::kAuto;  // of tables that have several
  bool skip_bad = false;  // leave bad records out and list them, instead of failing at the first
  unsigned threads = 1;
  Progress* progress = nullptr;  // optional; must outlive the call
};

}  // namespace beespace::io
