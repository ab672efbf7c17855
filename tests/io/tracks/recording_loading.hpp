// Short ways to load recordings that a test writes down, to pack them, and to say what must come
// out.
#pragma once

#include "io/load_recording.hpp"
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>
#include <zip.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {

inline Result<Recording> record(std::string_view text, const RecordingOptions& options = {}) {
  return load_recording_from_memory(text, "bees.csv", options);
}

inline RecordingOptions on_one_clock() {
  RecordingOptions options;
  options.one_clock = true;
  return options;
}

inline RecordingOptions columns_are(std::string columns, Unit unit = Unit::kSecond) {
  RecordingOptions options;
  options.columns = std::move(columns);
  options.time_unit = unit;
  return options;
}

inline RecordingOptions skipping_bad() {
  RecordingOptions options;
  options.skip_bad = true;
  return options;
}

// The recording, or an empty one (and a failed test) when loading fails.
inline Recording recording_of(const Result<Recording>& loaded) {
  EXPECT_TRUE(loaded.has_value()) << (loaded ? "" : to_string(loaded.error()));
  return loaded ? loaded.value() : Recording();
}

inline std::vector<std::string> ids_of(const Recording& recording) {
  std::vector<std::string> ids;
  for (const RecordedBee& bee : recording.bees) ids.push_back(bee.id);
  return ids;
}

inline std::vector<double> times_of(const RecordedBee& bee) {
  std::vector<double> times;
  for (const Fix& fix : bee.fixes) times.push_back(fix.time_s);
  return times;
}

inline bool has_note(const Recording& recording, std::string_view part) {
  return std::any_of(
      recording.notes.begin(), recording.notes.end(),
      [part](const std::string& note) { return note.find(part) != std::string::npos; });
}

using Members = std::vector<std::pair<std::string, std::string>>;  // name, content

// A zip archive of these files.
inline std::string zipped(const Members& members, zip_int32_t method = ZIP_CM_DEFLATE) {
  const TemporaryFolder folder;
  const std::string path = folder.file("made.zip");
  int problem = 0;
  zip_t* const archive = zip_open(path.c_str(), ZIP_CREATE, &problem);
  EXPECT_NE(archive, nullptr);
  if (archive == nullptr) return {};
  for (const auto& [name, content] : members) {
    zip_source_t* const source = zip_source_buffer(archive, content.data(), content.size(), 0);
    const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    EXPECT_GE(index, 0);
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), method, 0);
  }
  EXPECT_EQ(zip_close(archive), 0);
  return content_of(path);
}

}  // namespace beespace::io
