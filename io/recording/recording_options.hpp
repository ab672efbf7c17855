// How a recording is to be read.
#pragma once

#include "io/bytes/progress.hpp"
#include "io/table/column_options.hpp"
#include "io/units/iso_time.hpp"
#include "io/units/time_zone.hpp"
#include "io/units/units.hpp"

#include <cstdint>
#include <optional>

namespace beespace::io {

enum class RecordingFormat : std::uint8_t {
  kAuto,
  kTable,         // a text table, by the names of its columns
  kSkybrushCsv,   // the same; without a header it is t [ms], x, y, z and perhaps a colour
  kSkybrushShow,  // .skyc, or the show in one JSON file
};

// Columns may have a time and a velocity, too: "id=1,time=2,lon=3,lat=4,height=5,ve=6,vn=7,vu=8".
struct RecordingOptions : ColumnOptions {
  RecordingFormat format = RecordingFormat::kAuto;
  Unit time_unit = Unit::kUnstated;  // kUnstated: as the header says
  // Times of several inputs, or vehicles, count from one zero, where nothing says whether they do.
  bool one_clock = false;
  // Of dates and times that name none; and in which people are told what counts from 1970.
  std::optional<TimeZone> time_zone = {};
  DateOrder dates = DateOrder::kUnsaid;  // of those whose year is last and that do not tell it
  std::optional<double> frames_per_second = {};  // of tables that count the pictures of a video
  // Of tables of poses: places of a smaller likelihood are as if they were not there. DeepLabCut
  // does not draw what is below 0.6, if it is not told otherwise.
  double least_likelihood = 0.6;
  // Of shows, keep the time in which a drone stands on the ground; aircraft on the ground, too.
  bool grounded = false;
  // Of recordings: a cut of a sector, which traffic enters and leaves (see Recording::sector).
  bool sector = false;
  // It is compared with another one, which the same is said about: the unit of times may be that of
  // the other, where these have theirs.
  bool one_of_several = false;
  Progress* progress = nullptr;  // optional; must outlive the call
};

}  // namespace beespace::io
