#include "io/recording/recording_sources.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/signatures.hpp"
#include "io/problems/your_threshold.hpp"
#include "io/recording/left_out_files.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <ios>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace beespace::io {
namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// Whether the name ends in one of these, in any case, perhaps with .gz or .zst behind.
bool has_ending(std::string_view name, std::initializer_list<std::string_view> endings) {
  const std::string lower = lower_case(name);
  std::string_view rest = lower;
  if (ends_with(rest, ".gz")) rest.remove_suffix(3);
  if (ends_with(rest, ".zst")) rest.remove_suffix(4);
  return std::any_of(endings.begin(), endings.end(),
                     [rest](std::string_view ending) { return ends_with(rest, ending); });
}

// What idtracker.ai writes beside its trajectories.
bool is_beside_trajectories(std::string_view name) {
  const std::string lower = lower_case(name);
  return is_one_of("areas.csv id_probabilities.csv lengths.csv attributes.json", lower);
}

// What lies beside the tables of a show: moments with names, and no places.
bool is_beside_flights(std::string_view name) {
  return lower_case(name) == "cues.csv";
}

// What readsb and dump1090 write beside their snapshots: of the receiver, and of no aircraft.
bool is_beside_snapshots(std::string_view name) {
  return is_one_of("receiver.json stats.json status.json outline.json clients.json", name);
}

bool is_snapshot_name(std::string_view name) {
  return name == "aircraft.json" || (name.starts_with("history_") && name.ends_with(".json"));
}

// In which ArduPilot keeps the number of the last log.
bool is_number_of_last_log(std::string_view name) {
  return lower_case(name) == "lastlog.txt";
}

std::string_view name_in_folder(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

// Messages of aircraft as receivers send them, which are often kept in a .log.
bool is_message_log(const std::string& path) {
  if (!has_ending(path, {".log"})) return false;
  std::array<char, 4> head = {};
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), head.size());
  return std::string_view(head.data(), static_cast<std::size_t>(file.gcount())) == "MSG,";
}

// What a folder has, by kind.
struct Listed {
  std::vector<std::string> tables = {};
  std::vector<std::string> texts = {};
  std::vector<std::string> shows = {};
  std::vector<std::string> folders = {};
  std::vector<std::string> documents = {};
  std::vector<std::string> logs = {};
  std::vector<std::string> flights = {};
  std::vector<std::string> others = {};
  std::vector<std::string> of_receiver = {};
  std::vector<std::string> last_logs = {};
  std::string_view foreign = {};  // what is said of a show of other editors
  std::error_code problem = {};

  std::vector<std::string>& of(std::string_view name, const std::string& path) {
    if (is_folder(path)) return folders;
    if (is_message_log(path)) return tables;
    if (is_table_name(name)) return has_ending(name, {".txt"}) ? texts : tables;
    if (has_ending(name, {".skyc", ".vviz"})) return shows;
    if (has_ending(name, {".json", ".ndjson", ".jsonl"})) return documents;
    if (is_telemetry_name(name)) return logs;
    return is_flight_log_name(name) ? flights : others;
  }
  // Of idtracker.ai the trajectories alone are tables of places.
  void leave_trajectories() {
    const auto named = [](const std::string& path, const auto& is) {
      return is(std::string_view(path).substr(path.rfind('/') + 1));
    };
    const bool trajectories = std::any_of(tables.begin(), tables.end(), [&](const auto& path) {
      return named(path, [](std::string_view name) { return name == "trajectories.csv"; });
    });
    if (!trajectories) return;
    for (auto* kind : {&tables, &documents}) {
      std::erase_if(*kind, [&](const auto& path) { return named(path, is_beside_trajectories); });
    }
  }
  // Where there are other tables, a sheet of cues is none of a drone.
  void leave_cues() {
    const auto cues = std::stable_partition(tables.begin(), tables.end(), [](const auto& path) {
      return !is_beside_flights(name_in_folder(path));
    });
    if (cues != tables.begin()) tables.erase(cues, tables.end());
  }
  // Of readsb and dump1090 the snapshots alone have aircraft.
  void leave_receiver() {
    const bool snapshots = std::any_of(documents.begin(), documents.end(), [](const auto& path) {
      return is_snapshot_name(name_in_folder(path));
    });
    if (!snapshots) return;
    const auto aside = std::stable_partition(
        documents.begin(), documents.end(),
        [](const auto& path) { return !is_beside_snapshots(name_in_folder(path)); });
    of_receiver.assign(aside, documents.end());
    documents.erase(aside, documents.end());
  }
  // Beside logs of ArduPilot, and there alone, what counts them is none.
  void leave_last_log() {
    const bool logs_of_ardupilot =
        std::any_of(flights.begin(), flights.end(),
                    [](const auto& path) { return has_ending(path, {".bin"}); });
    if (!logs_of_ardupilot) return;
    const auto aside = std::stable_partition(tables.begin(), tables.end(), [](const auto& path) {
      return !is_number_of_last_log(name_in_folder(path));
    });
    last_logs.assign(aside, tables.end());
    tables.erase(aside, tables.end());
  }
  // The kind that is read.
  std::vector<std::string>& chosen() {
    if (!tables.empty()) return tables;
    if (!shows.empty()) return shows;
    if (!documents.empty()) return documents;
    return !logs.empty() ? logs : flights;
  }
};

// Whether it is a folder, in which nothing may be that is looked for.
bool is_harmless_folder(const std::filesystem::directory_entry& entry) {
  std::error_code problem;
  if (!entry.is_directory(problem)) return false;
  if (entry.path().filename().string().front() == '.') return true;
  std::filesystem::recursive_directory_iterator inside(entry.path(), problem);
  for (; !problem && inside != std::filesystem::recursive_directory_iterator();
       inside.increment(problem)) {
    if (!inside->is_directory(problem) && !holds_no_places(inside->path().string())) return false;
  }
  return !problem;
}

Listed listed(const std::string& folder) {
  Listed found;
  std::filesystem::directory_iterator entry(folder, found.problem);
  for (; !found.problem && entry != std::filesystem::directory_iterator();
       entry.increment(found.problem)) {
    const std::string name = entry->path().filename().string();
    const std::string path = entry->path().string();
    if (holds_no_places(name) || is_harmless_folder(*entry)) continue;
    if (name.front() == '.') {
      found.others.push_back(path);
      continue;
    }
    found.of(name, path).push_back(path);
    if (found.foreign.empty()) found.foreign = foreign_show(name);
  }
  // Texts are tables, unless they seem to lie beside a show.
  auto& beside = found.tables.empty() && !found.shows.empty() ? found.others : found.tables;
  beside.insert(beside.end(), found.texts.begin(), found.texts.end());
  found.texts.clear();
  found.leave_trajectories();
  found.leave_cues();
  found.leave_receiver();
  found.leave_last_log();
  return found;
}

// "traces/12, or all of one time, traces/*"; the first alone where nothing is read of the others.
std::string with_those_beside(const std::string& first, const std::string& folder,
                              const std::vector<std::string>& folders) {
  const bool several = std::any_of(folders.begin(), folders.end(), [&](const std::string& other) {
    return other != first && !listed(other).chosen().empty();
  });
  if (!several) return first;
  return first + ", or " + (std::filesystem::path(folder) / "*").string() +
         " for all of them, if they are of one time";
}

// The same of a folder within `inside`: of those of its name within the folders beside that one, as
// mav0/leica0 and mav1/leica0.
std::string with_those_alike(std::string first, const std::string& inside,
                             const std::string& folder, const std::vector<std::string>& beside) {
  const std::string within = first.substr(inside.size());
  const bool any = std::any_of(beside.begin(), beside.end(), [&](const std::string& other) {
    return other != inside && is_folder(other + within) && !listed(other + within).chosen().empty();
  });
  if (!any) return first;
  return first + ", or " + (std::filesystem::path(folder) / "*").string() + within +
         " for all of them, if they are of one time";
}

// Folders below this one that have something that is read, at most `depth` levels deep: the first,
// and all beside it where there are several.
std::string first_folder_with_recordings(const std::string& folder, int depth) {
  Listed found = listed(folder);
  std::sort(found.folders.begin(), found.folders.end());
  for (const std::string& inside : found.folders) {
    if (!listed(inside).chosen().empty()) return with_those_beside(inside, folder, found.folders);
    if (depth == 1) continue;
    if (std::string deeper = first_folder_with_recordings(inside, depth - 1); !deeper.empty()) {
      return with_those_alike(std::move(deeper), inside, folder, found.folders);
    }
  }
  return {};
}

// As rosbag2 records: what is in it, beside the messages.
bool is_bag_folder(const Listed& found, const std::string& folder) {
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::path(folder) / "metadata.yaml", ignored) &&
         std::any_of(found.others.begin(), found.others.end(), [](const std::string& path) {
           return has_ending(path, {".db3", ".mcap"});
         });
}

// All files of a folder with the ending of that one, as a shell takes it.
std::string all_alike(const std::string& path) {
  const std::filesystem::path file(path);
  const std::string folder = file.parent_path().string();
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  const bool plain = folder.find_first_not_of(kPlain) == std::string::npos;
  return (plain ? folder : "'" + folder + "'") + "/*" + file.extension().string();
}

// Of lines that take several files: as if they had been told of all that are alike.
bool name_all_alike(const std::string& first, std::string& message) {
  constexpr std::string_view kFirst = "\" FILE";
  constexpr std::string_view kOthers = ", with the names of the others behind the first one";
  const std::size_t at = message.find(kFirst);
  const std::size_t others = message.find(kOthers);
  if (at == std::string::npos || others == std::string::npos) return false;
  message.erase(others, kOthers.size());
  message.replace(at, kFirst.size(), "\" " + all_alike(first));
  return true;
}

// Of what other programs wrote, what to do with the first one, and so with the others.
std::optional<Error> first_foreign(const std::vector<std::string>& others) {
  // As much as names in it are looked for from the beginning on.
  constexpr std::size_t kHead = std::size_t{1} << 22;
  std::string head(kHead, '\0');
  std::ifstream file(others.front(), std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  if (!is_foreign_file(head)) return std::nullopt;
  std::string message = "this is " + words_of_signature(head);
  if (others.size() > 1 && !name_all_alike(others.front(), message)) {
    message += "; likewise " + std::to_string(others.size() - 1) + " more in this folder";
  }
  return Error{ErrorCode::kUnsupportedFormat, std::move(message), {others.front()}};
}

Error nothing_to_read(Listed found, const std::string& folder) {
  constexpr int kDepth = 6;  // year, month, day, traces and a part of these, as readsb has them
  if (is_bag_folder(found, folder)) {
    return {ErrorCode::kUnsupportedFormat, "this is " + words_of_bag_folder(), {folder}};
  }
  if (!found.others.empty()) {
    std::sort(found.others.begin(), found.others.end());
    if (auto error = first_foreign(found.others)) return *std::move(error);
  }
  std::string message =
      "there is no .csv, .tsv or .txt file in this folder, nor any .igc, .so6, .skyc, .json, "
      ".ndjson, .tlog, .ulg or .bin";
  if (!found.others.empty()) {
    message += ", but " + found.others.front() +
               (found.others.size() == 1 ? ""
                                         : " and " + std::to_string(found.others.size() - 1) +
                                               " more, which say when named what to do");
  }
  const std::string inside = first_folder_with_recordings(folder, kDepth);
  // Of each encounter, and each run of a simulator, the clock begins anew.
  constexpr std::array<std::string_view, 3> kEachByItself = {".daa", ".log", ".scn"};
  const auto of_that =
      std::find_if(kEachByItself.begin(), kEachByItself.end(), [&found](std::string_view ending) {
        return std::all_of(found.others.begin(), found.others.end(),
                           [ending](const std::string& name) { return name.ends_with(ending); });
      });
  if (inside.empty() && found.others.size() > 1 && of_that != kEachByItself.end()) {
    message += "; each of these is a recording of its own, as a rule: for f in \"" + folder;
    message.append("\"/*").append(*of_that).append("; do beespace ");
    message += *of_that == ".scn" ? "predict" : "replay";
    message.append(" \"$f\" ").append(kYourThreshold).append("; done");
    return {ErrorCode::kNoPoints, std::move(message), {folder}};
  }
  message += inside.empty() ? "; name the files, or the folder that holds them"
                            : "; folders in it are not looked into: name " + inside;
  // As idtracker.ai writes them, in pixels.
  if (inside.ends_with("trajectories_csv")) {
    message += ", and say how long a pixel is, as in --scale 0.1mm";
  }
  return {ErrorCode::kNoPoints, message, {folder}};
}

}  // namespace

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return path != "-" && std::filesystem::is_directory(path, ignored);
}

bool is_telemetry_name(std::string_view name) {
  return has_ending(name, {".tlog"});
}

bool is_flight_log_name(std::string_view name) {
  return has_ending(name, {".ulg", ".ulog", ".bin"});
}

bool is_table_name(std::string_view name) {
  return has_ending(name, {".csv", ".tsv", ".txt", ".igc", ".so6"});
}

std::string_view foreign_show(std::string_view name) {
  if (!has_ending(name, {".path", ".path3"})) return {};
  return "these are paths of a drone show (DSS), which are not read; export the show as .skyc, or "
         "as "
         "CSV with a table a drone";
}

Result<std::vector<std::string>> recordings_in(const std::string& folder) {
  Listed found = listed(folder);
  if (found.problem) {
    return Error{ErrorCode::kCannotOpen,
                 "cannot read this folder: " + found.problem.message() + "; check its permissions",
                 {folder}};
  }
  auto& chosen = found.chosen();
  if (chosen.empty() && !found.foreign.empty()) {
    return Error{ErrorCode::kUnsupportedFormat, std::string(found.foreign), {folder}};
  }
  if (chosen.empty()) return nothing_to_read(std::move(found), folder);
  if (&chosen == &found.shows && chosen.size() > 1) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "there are " + std::to_string(chosen.size()) +
                     " shows (.skyc) in this folder, each of which is one of its own; name the one "
                     "that is meant, or all that fly at the same time",
                 {folder}};
  }
  std::sort(chosen.begin(), chosen.end());
  return std::move(chosen);
}

std::vector<std::string> recordings_left_in(const std::string& folder) {
  Listed found = listed(folder);
  const std::vector<std::string>* const chosen = &found.chosen();
  std::vector<std::string> left;
  for (const auto* kind : {&found.shows, &found.documents, &found.logs, &found.flights,
                           &found.folders, &found.others}) {
    if (kind != chosen) left.insert(left.end(), kind->begin(), kind->end());
  }
  std::erase_if(left, [&](const std::string& path) {
    return std::any_of(chosen->begin(), chosen->end(), [&](const std::string& read) {
      // MAVProxy writes the same without times beside a log.
      return path == read + ".raw" || is_other_form_of(path, read.substr(0, read.rfind('.')));
    });
  });
  return left;
}

std::vector<std::string> receiver_files_in(const std::string& folder) {
  std::vector<std::string> files = listed(folder).of_receiver;
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> last_logs_in(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  const bool any_log = std::any_of(paths.begin(), paths.end(), [](const std::string& path) {
    return has_ending(path, {".bin"}) && !is_folder(path);
  });
  for (const std::string& path : paths) {
    if (is_folder(path)) {
      const std::vector<std::string> inside = listed(path).last_logs;
      files.insert(files.end(), inside.begin(), inside.end());
    } else if (any_log && is_number_of_last_log(name_in_folder(path))) {
      files.push_back(path);
    }
  }
  return files;
}

std::string stem_of(std::string_view path) {
  if (path == "-") return "stdin";
  const std::size_t slash = path.rfind('/');
  if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
  std::string_view stem = path;
  if (ends_with(lower_case(stem), ".gz")) stem.remove_suffix(3);
  if (ends_with(lower_case(stem), ".zst")) stem.remove_suffix(4);
  const std::size_t dot = stem.rfind('.');
  if (dot != std::string_view::npos && dot > 0) stem = stem.substr(0, dot);
  return std::string(stem.empty() ? path : stem);
}

}  // namespace beespace::io
