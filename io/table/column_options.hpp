// How the columns of a table are to be taken.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/units/heights.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/unit_overrides.hpp"

#include <optional>
#include <string>

namespace beespace::io {

struct ColumnOptions {
  Frame frame = Frame::kAuto;
  std::string columns = {};  // "lon=1,lat=2,height=3", by number (from 1) or name; empty: automatic
  UnitOverrides units = {};  // where the header names none
  std::optional<StatedLength> pixel = {};      // coordinates are pixels, each so long
  HeightSource heights = HeightSource::kAuto;  // of tables, and of aircraft, that have several
  // Where velocities are not needed: those whose unit would have to be said are not read.
  bool velocities_needed = true;
  bool skip_bad = false;  // leave bad records out and list them, instead of failing at the first
};

}  // namespace beespace::io
