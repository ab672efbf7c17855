// How a recording is to be read.
#pragma once

#include "io/bytes/progress.hpp"
#include "io/frames/coordinate_frame.hpp"
#include "io/units/heights.hpp"
#include "io/units/unit_wishes.hpp"

#include <cstdint>
#include <string>

namespace beespace::io {

enum class RecordingFormat : std::uint8_t {
  kAuto,
  kTable,         // a text table, by the names of its columns
  kSkybrushCsv,   // the same; without a header it is t [ms], x, y, z and perhaps a colour
  kSkybrushShow,  // .skyc, or the show in one JSON file
};

enum class TimeUnit : std::uint8_t {
  kAuto,  // as the header says
  kSeconds,
  kMilliseconds,
  kMicroseconds,
  kNanoseconds,
};

struct RecordingOptions {
  Frame frame = Frame::kAuto;
  RecordingFormat format = RecordingFormat::kAuto;
  std::string columns = {};  // "id=1,time=2,lon=3,lat=4,height=5,ve=6,vn=7,vu=8"; empty: automatic
  TimeUnit time_unit = TimeUnit::kAuto;
  UnitWishes units = {};  // where the header names none
  bool skip_bad = false;  // leave bad records out and list them, instead of failing
  // Of shows, keep the time in which a drone stands on the ground; aircraft on the ground, too.
  bool grounded = false;
  HeightSource heights = HeightSource::kAuto;  // of aircraft; other inputs have one kind of height
  Progress* progress = nullptr;                // optional; must outlive the call
};

}  // namespace beespace::io
