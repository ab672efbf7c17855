#include "io/load_recording.hpp"

#include "io/byte_source.hpp"
#include "io/gzip.hpp"
#include "io/recording_assembly.hpp"
#include "io/recording_sources.hpp"
#include "io/text_check.hpp"
#include "io/track_table.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace beespace::io {
namespace {

// One input, whatever it holds.
std::optional<Error> read_source(Bytes bytes, const std::string& path,
                                 RecordingAssembly& assembly) {
  const RecordingOptions& options = assembly.options();
  const std::string name = source_name(path);
  assembly.begin_source(name);
  assembly.add_bytes(bytes.view.size());
  if (is_gzip(bytes.view)) {
    auto unpacked = gunzip(bytes.view, name, nullptr);
    if (!unpacked) return unpacked.error();
    bytes = std::move(unpacked).value();
    if (is_gzip(bytes.view)) {
      return Error{ErrorCode::kUnsupportedFormat,
                   "this is compressed twice; unpack it once first: gzip -dc",
                   {}};
    }
  }
  if (options.progress != nullptr) options.progress->total += bytes.view.size();
  return read_track_table(
      {bytes.view, stem_of(path), options.format == RecordingFormat::kSkybrushCsv}, assembly);
}

std::optional<Error> placed(std::optional<Error> error, const std::string& path) {
  if (error && error->place.source.empty()) error->place.source = source_name(path);
  return error;
}

std::optional<Error> read_path(const std::string& path, RecordingAssembly& assembly) {
  if (is_folder(path)) {
    const auto tables = tables_in(path);
    if (!tables) return tables.error();
    for (const std::string& table : *tables) {
      if (auto error = read_path(table, assembly)) return error;
    }
    return std::nullopt;
  }
  auto bytes = open_bytes(path, nullptr);
  if (!bytes) return bytes.error();
  return placed(read_source(std::move(bytes).value(), path, assembly), path);
}

}  // namespace

Result<Recording> load_recording(const std::vector<std::string>& paths,
                                 const RecordingOptions& options) {
  if (paths.empty()) {
    return Error{ErrorCode::kInvalidArgument, "no input is named; name a file, a folder, or -", {}};
  }
  if (options.progress != nullptr) {
    options.progress->done = 0;
    options.progress->total = 0;
  }
  RecordingAssembly assembly(options);
  for (const std::string& path : paths) {
    if (auto error = read_path(path, assembly)) return *std::move(error);
  }
  return assembly.finish();
}

Result<Recording> load_recording_from_memory(std::string_view content, const std::string& name,
                                             const RecordingOptions& options) {
  GrowingBytes copy;
  copy.make_room(content.size());
  std::copy(content.begin(), content.end(), copy.free_begin());
  copy.add(content.size());
  RecordingAssembly assembly(options);
  if (auto error = placed(read_source(copy.release(), name, assembly), name)) {
    return *std::move(error);
  }
  return assembly.finish();
}

}  // namespace beespace::io
