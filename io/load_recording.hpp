// From files, folders or standard input to the recording of bees that move.
//
// Reads, each plain or gzip-compressed and told by its content:
// - text tables of fixes (id, time, position, perhaps velocity), one table of many bees or a file a
//   bee, also a folder or a zip of them;
// - Skybrush shows (.skyc, or one JSON file);
// - aircraft: aircraft.json of readsb and dump1090, state vectors of OpenSky, both also a series
//   of files, and BaseStation (SBS-1) messages. Bees are named by the address of the aircraft;
// - MAVLink telemetry logs (.tlog). Bees are named by their system id, in several inputs with the
//   name of the file before it.
//
// Nothing is converted but units: positions stay as the input has them (see recording.hpp), times
// become seconds. What several files say of the same id is one bee's.
#pragma once

#include "io/load_points.hpp"
#include "io/recording.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

// `paths` are names of files and folders, or "-" for standard input. Of a folder, all its .csv,
// .tsv and .txt files are read, in the order of their names; where there is none, its .json files,
// otherwise its .tlog files. Errors carry the file (of a zip
// "show.skyc!drones/1/trajectory.json"), and line and column or record where there are such.
Result<Recording> load_recording(const std::vector<std::string>& paths,
                                 const RecordingOptions& options = {});

// The same for one input in memory (copied); `name` stands for the file.
Result<Recording> load_recording_from_memory(std::string_view content, const std::string& name,
                                             const RecordingOptions& options = {});

}  // namespace beespace::io
