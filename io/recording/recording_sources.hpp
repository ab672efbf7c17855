// Which inputs a list of paths means, and what they are called.
#pragma once

#include <beespace/result.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// Whether `path` is a folder.
bool is_folder(const std::string& path);

// Whether a name ends as those of text tables do: .csv, .tsv or .txt, perhaps with .gz or .zst
// behind.
bool is_table_name(std::string_view name);

// Whether a name ends as those of logs of telemetry (.tlog), or of drones that log themselves
// (.ulg, .bin) do.
bool is_telemetry_name(std::string_view name);
bool is_flight_log_name(std::string_view name);

// What is said of an archive or a folder without tables that holds shows of other editors, by the
// name of a file in it; nothing where it is no such.
std::string_view foreign_show(std::string_view name);

// What there is to read in the folder, by name: its tables; where there is none, its show (.skyc),
// its .json and .ndjson files, otherwise its .tlog files, or its .ulg and .bin files. Hidden files
// are left out, and so is what holds no places (README.txt), and what idtracker.ai writes beside
// its trajectories.csv, or readsb beside its aircraft.json. Errors: kCannotOpen, kNoPoints when
// there is nothing, kUnsupportedFormat for several shows.
Result<std::vector<std::string>> recordings_in(const std::string& folder);

// What of a folder is not read beside what is, but for what is harmless (see left_out_files.hpp).
std::vector<std::string> recordings_left_in(const std::string& folder);

// What readsb and dump1090 tell of the receiver beside aircraft.json and history_0.json, in
// ascending order: these are not read, and harmless.
std::vector<std::string> receiver_files_in(const std::string& folder);

// LASTLOG.TXT of ArduPilot, in folders with its logs and among names of them: it has the number of
// the last log, and no places.
std::vector<std::string> last_logs_in(const std::vector<std::string>& paths);

// "swarm" of "data/swarm.csv.gz"; "stdin" of "-".
std::string stem_of(std::string_view path);

}  // namespace beespace::io
