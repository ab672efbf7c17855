// From files, folders or standard input to the recording of bees that move.
//
// Reads, each plain or gzip-compressed and told by its content:
// - text tables of fixes (id, time, position, perhaps velocity), one table of many bees or a file a
//   bee, also a folder or a zip of them;
// - the same tables as JSON, as pandas writes them: records, columns, an object a line;
// - Skybrush shows (.skyc, or one JSON file);
// - aircraft: aircraft.json of readsb and dump1090, state vectors of OpenSky, both also a series
//   of files, and BaseStation (SBS-1) messages. Bees are named by the address of the aircraft;
// - DAIDALUS encounters (.daa), and where BlueSky scenarios (.scn) create their aircraft;
// - MAVLink telemetry logs (.tlog). Bees are named by their system id, in several inputs with the
//   name of the file before it;
// - PX4 logs (ULog), each of one drone, which is named after the file. Several share a clock by the
//   time of GPS, or not at all.
//
// Nothing is converted but units: positions stay as the input has them (see recording.hpp), times
// become seconds. What several files say of the same id is one bee's.
#pragma once

#include "io/recording/recording.hpp"
#include "io/recording/recording_options.hpp"

#include <beespace/result.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// `paths` are names of files and folders, or "-" for standard input. Of a folder, all its .csv,
// .tsv and .txt files are read, in the order of their names; where there is none, its .json files,
// otherwise its .tlog files, or its .ulg and .bin files. Errors carry the file (of a zip
// "show.skyc!drones/1/trajectory.json"), and line and column or record where there are such.
Result<Recording> load_recording(const std::vector<std::string>& paths,
                                 const RecordingOptions& options = {});

// The same for one input in memory (copied); `name` stands for the file.
Result<Recording> load_recording_from_memory(std::string_view content, const std::string& name,
                                             const RecordingOptions& options = {});

}  // namespace beespace::io
