#include "io/recording/left_out_files.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/recording_sources.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::string_view kForPeople =
    "md rst pdf rtf doc docx odt ppt pptx odp html htm png jpg jpeg gif bmp svg tif tiff webp heic "
    "eps mp3 wav ogg flac m4a aac mp4 m4v mov avi mkv webm blend blend1 py ipynb r m sh bat yaml "
    "yml "
    "toml ini cfg parm param params czml";
constexpr std::string_view kOfSystems =
    "__macosx thumbs.db desktop.ini $recycle.bin lost+found icon\r";
constexpr std::string_view kOfRecordings =
    "csv tsv txt ndjson jsonl tlog ulg ulog skyc zip gz zst bin dat";
// Of the forms for globes and maps CZML is written for looking at alone.
constexpr std::string_view kOtherForms =
    "kml kmz geojson h5 hdf5 pickle pkl npy npz mat slp xlsx parquet rlog";

constexpr std::string_view kPartsOfShows =
    "lights.json yaw.json yawControl.json pyro.json cues.json";

std::string_view name_in(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

std::string_view ending_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos || dot == 0 ? std::string_view() : name.substr(dot + 1);
}

bool is_title_of_words(std::string_view lower) {
  const std::string_view stem = lower.substr(0, lower.find('.'));
  const std::string_view ending = ending_of(lower);
  if (!ending.empty() && ending != "txt") return false;
  return lower.starts_with("readme") || lower.starts_with("license") ||
         lower.starts_with("licence") ||
         is_one_of("read_me read-me copying notice notes changelog changes authors", stem);
}

// In ascending order.
std::string left_out_text(const std::vector<std::string>& names) {
  const std::string more =
      names.size() == 1 ? " is" : " and " + std::to_string(names.size() - 1) + " more are";
  return names.front() + more + " left out";
}

bool is_named(const std::string& path, const std::vector<std::string>& paths) {
  const auto normal = [](const std::string& of) {
    const std::string text = std::filesystem::path(of).lexically_normal().string();
    return text.ends_with('/') ? text.substr(0, text.size() - 1) : text;
  };
  return std::any_of(paths.begin(), paths.end(),
                     [&](const std::string& other) { return normal(other) == normal(path); });
}

// They have no aircraft, but a name may be meant for something else.
void note_receiver_files(const std::vector<std::string>& paths, RecordingAssembly& assembly) {
  for (const std::string& path : paths) {
    if (!is_folder(path)) continue;
    std::string names;
    for (const std::string& file : receiver_files_in(path)) {
      if (is_named(file, paths)) continue;
      names.append(names.empty() ? "" : ", ").append(name_in(file));
    }
    if (names.empty()) continue;
    std::string text = "of " + path;
    text.append(" these are not read, as they tell of the receiver, not of aircraft: ");
    assembly.note(text.append(names));
  }
}

void note_last_logs(const std::vector<std::string>& paths, RecordingAssembly& assembly) {
  std::string names;
  for (const std::string& file : last_logs_in(paths)) {
    names.append(names.empty() ? "" : ", ").append(file);
  }
  if (names.empty()) return;
  assembly.note("not read, as it has the number of the last log of ArduPilot and no places: " +
                names);
}

}  // namespace

bool holds_no_places(std::string_view path) {
  const std::string lower = lower_case(name_in(path));
  const std::string_view ending = ending_of(lower);
  if (lower.empty() || lower.starts_with("._")) return true;
  if (lower.front() == '.') return !is_one_of(kOfRecordings, ending);
  return is_one_of(kOfSystems, lower) || is_title_of_words(lower) || is_one_of(kForPeople, ending);
}

bool is_other_form_of(std::string_view name, std::string_view stem) {
  constexpr std::string_view kOfMeta = "_meta";  // of DeepLabCut
  const std::string_view ending = ending_of(name_in(name));
  if (!is_one_of(kOtherForms, lower_case(ending))) return false;
  name.remove_suffix(ending.size() + 1);
  if (name == stem) return true;
  return name.ends_with(kOfMeta) && name.substr(0, name.size() - kOfMeta.size()) == stem;
}

void count_left_out(const std::vector<std::string>& paths, RecordingAssembly& assembly) {
  note_receiver_files(paths, assembly);
  note_last_logs(paths, assembly);
  std::vector<std::string> left;
  for (const std::string& path : paths) {
    if (!is_folder(path)) continue;
    for (std::string& file : recordings_left_in(path)) {
      if (!is_named(file, paths)) left.push_back(std::move(file));
    }
  }
  if (left.empty()) return;
  std::sort(left.begin(), left.end());
  for (const std::string& file : left) assembly.leave_file_out(file);
  assembly.note("of a folder one kind of files is read: " + left_out_text(left) +
                "; name them, too, if they belong to it");
}

void count_left_out(std::vector<std::string> names, std::string_view read,
                    RecordingAssembly& assembly) {
  std::erase_if(names, [](const std::string& name) {
    return name.starts_with("__MACOSX/") || holds_no_places(name) ||
           is_one_of(kPartsOfShows, name_in(name));
  });
  if (names.empty()) return;
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    assembly.leave_file_out(assembly.source_name() + "!" + name);
  }
  names.front() = excerpt(names.front());
  assembly.note("of " + assembly.source_name() + ", an archive, " + std::string(read) +
                " read: " + left_out_text(names));
}

}  // namespace beespace::io
