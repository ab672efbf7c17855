#include "io/load_recording.hpp"

#include "io/aircraft/aircraft_reading.hpp"
#include "io/aircraft/base_station_reading.hpp"
#include "io/aircraft/flightradar24_feed.hpp"
#include "io/aircraft/igc_log.hpp"
#include "io/ardupilot/dataflash_reading.hpp"
#include "io/ardupilot/dataflash_walk.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/gzip.hpp"
#include "io/bytes/utf16.hpp"
#include "io/bytes/windows_1252.hpp"
#include "io/bytes/zip_archive.hpp"
#include "io/encounters/bluesky_scenario.hpp"
#include "io/encounters/daidalus_encounter.hpp"
#include "io/encounters/so6_segments.hpp"
#include "io/json/json_document.hpp"
#include "io/mavlink/telemetry_log.hpp"
#include "io/mavlink/telemetry_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/json_kind.hpp"
#include "io/problems/signatures.hpp"
#include "io/problems/text_check.hpp"
#include "io/px4/flight_reading.hpp"
#include "io/px4/ulog_walk.hpp"
#include "io/recording/left_out_files.hpp"
#include "io/recording/recording_assembly.hpp"
#include "io/recording/recording_sources.hpp"
#include "io/shows/show_documents.hpp"
#include "io/shows/show_reading.hpp"
#include "io/shows/vviz_reading.hpp"
#include "io/table/decimal_comma.hpp"
#include "io/tracks/ethovision_table.hpp"
#include "io/tracks/json_table.hpp"
#include "io/tracks/motive_table.hpp"
#include "io/tracks/point_cells.hpp"
#include "io/tracks/pose_table.hpp"
#include "io/tracks/qtm_table.hpp"
#include "io/tracks/track_table.hpp"
#include "io/tracks/trackmate_table.hpp"
#include "io/tracks/vicon_table.hpp"
#include "io/tracks/wide_table.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

std::optional<Error> read_table(const Bytes& bytes, const std::string& path, bool bare_skybrush,
                                RecordingAssembly& assembly) {
  const RecordingOptions& options = assembly.options();
  if (options.progress != nullptr) options.progress->total += bytes.view.size();
  return read_track_table({bytes.view, stem_of(path), bare_skybrush}, assembly);
}

// Beside what is for people, what the system that packed an archive has put there.
bool is_of_archive(std::string_view name, bool (*is_such)(std::string_view)) {
  const bool hidden =
      name.substr(name.rfind('/') + 1).starts_with('.') || name.starts_with("__MACOSX/");
  return is_such(name) && !hidden && !holds_no_places(name);
}

// The tables of an archive, by name; where there is none, its logs, of one kind as in folders.
Result<std::vector<std::string>> tables_of(const ZipArchive& archive, const std::string& source) {
  std::vector<std::string> tables;
  std::string others;
  for (const auto is_such : {is_table_name, is_telemetry_name, is_flight_log_name}) {
    if (!tables.empty()) break;
    std::copy_if(archive.names().begin(), archive.names().end(), std::back_inserter(tables),
                 [is_such](const std::string& name) { return is_of_archive(name, is_such); });
  }
  for (const std::string& name : archive.names()) {
    if (others.size() < 100) others.append(others.empty() ? "" : ", ").append(excerpt(name));
  }
  const auto foreign =
      std::find_if(archive.names().begin(), archive.names().end(),
                   [](const std::string& name) { return !foreign_show(name).empty(); });
  if (tables.empty() && foreign != archive.names().end()) {
    return Error{ErrorCode::kUnsupportedFormat, std::string(foreign_show(*foreign)), {source}};
  }
  if (tables.empty()) {
    const bool of_json =
        std::any_of(archive.names().begin(), archive.names().end(), [](const std::string& name) {
          return name.ends_with(".json") || name.ends_with(".json.gz");
        });
    return Error{
        ErrorCode::kUnsupportedFormat,
        "this zip archive holds neither a show.json nor any .csv, .tlog, .ulg or .bin file, but " +
            (others.empty() ? "nothing" : others) +
            (of_json ? "; unpack it and name the folder that holds these"
                     : "; name a Skybrush show (.skyc) or an archive of tables or logs"),
        {source}};
  }
  std::sort(tables.begin(), tables.end());
  const auto twice = std::adjacent_find(tables.begin(), tables.end());
  if (twice != tables.end()) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "this zip archive holds several files named " + excerpt(*twice) +
                     ", of which only one can be read; pack them under different names",
                 {source}};
  }
  return tables;
}

// A table in text, as whichever tool writes it; `bare_skybrush` says that four columns without
// names are a drone of a show.
std::optional<Error> read_text_table(Bytes content, const std::string& path, bool bare_skybrush,
                                     RecordingAssembly& assembly) {
  if (auto utf8 = text_problem(content.view) ? std::nullopt : from_windows_1252(content.view)) {
    content = *std::move(utf8);
    assembly.note(std::string(kTakenForWindows1252));
  }
  const std::string_view whole = without_byte_order_mark(content.view);
  if (assembly.options().format == RecordingFormat::kAuto) {
    if (is_igc_log(whole)) return read_igc_log(whole, stem_of(path), assembly);
    if (assembly.options().columns.empty() && is_so6(whole)) return read_so6(whole, assembly);
  }
  if (auto points = with_decimal_points(without_byte_order_mark(content.view))) {
    content = *std::move(points);
    assembly.note("numbers have decimal commas");
  }
  if (auto split = with_split_points(without_byte_order_mark(content.view))) {
    content = *std::move(split);
    assembly.note(std::string(kTakenFromPoints));
  }
  if (assembly.options().format == RecordingFormat::kAuto) {
    const std::string_view text = without_byte_order_mark(content.view);
    const bool columns_are_named = !assembly.options().columns.empty();
    if (!columns_are_named && is_trackmate_table(text)) return read_trackmate_table(text, assembly);
    if (!columns_are_named && is_motive_table(text)) return read_motive_table(text, assembly);
    if (!columns_are_named && is_vicon_table(text)) return read_vicon_table(text, assembly);
    if (!columns_are_named && is_qtm_table(text)) return read_qtm_table(text, assembly);
    if (!columns_are_named && is_ethovision_table(text)) {
      return read_ethovision_table(text, stem_of(path), assembly);
    }
    if (is_pose_table(text)) return read_pose_table(text, stem_of(path), assembly);
    if (!columns_are_named && is_wide_table(text)) return read_wide_table(text, assembly);
  }
  return read_table(content, path, bare_skybrush, assembly);
}

Error stream_without_times() {
  return {ErrorCode::kUnsupportedFormat, "this is " + std::string(kStreamWithoutTimes), {}};
}

// What is UTF-16, as its mark says, in UTF-8.
void take_utf16(Bytes& bytes, RecordingAssembly& assembly) {
  auto utf8 = from_utf16(bytes.view);
  if (!utf8) return;
  bytes = *std::move(utf8);
  assembly.note(std::string(kTakenForUtf16));
}

std::optional<Error> read_member(Bytes bytes, const std::string& name, bool bare_skybrush,
                                 RecordingAssembly& assembly) {
  take_utf16(bytes, assembly);
  if (is_ulog(bytes.view)) return read_flight(bytes.view, name, assembly);
  if (is_dataflash_log(bytes.view)) return read_dataflash(bytes.view, name, assembly);
  if (is_stream_without_times(bytes.view)) return stream_without_times();
  if (is_telemetry_log(bytes.view)) return read_telemetry(bytes.view, name, assembly);
  return read_text_table(std::move(bytes), name, bare_skybrush, assembly);
}

std::optional<Error> read_archive(Bytes bytes, const std::string& source,
                                  RecordingAssembly& assembly) {
  const RecordingFormat format = assembly.options().format;
  auto archive = ZipArchive::open(std::move(bytes), source);
  if (!archive) return archive.error();
  const auto& names = archive->names();
  const bool show = std::find(names.begin(), names.end(), ShowDocuments::kRoot) != names.end();
  if (format == RecordingFormat::kSkybrushShow || (format == RecordingFormat::kAuto && show)) {
    auto documents = ShowDocuments::from_archive(std::move(archive).value());
    if (!documents) return documents.error();
    if (auto error = read_show(*documents, assembly)) return error;
    count_left_out(documents->unread(), "what its show.json leads to is", assembly);
    return std::nullopt;
  }
  const auto tables = tables_of(*archive, source);
  if (!tables) return tables.error();
  std::vector<std::string> others = names;
  std::erase_if(others, [&tables](const std::string& name) {
    return std::binary_search(tables->begin(), tables->end(), name);
  });
  const bool are_tables = is_table_name(tables->front());
  count_left_out(std::move(others), are_tables ? "the tables are" : "the logs are", assembly);
  if (tables->size() > 1) assembly.expect_several();
  std::vector<std::string> places;
  for (const std::string& table : *tables) places.push_back(archive->place_of(table));
  assembly.expect_sources(places);
  for (const std::string& table : *tables) {
    const std::string place = archive->place_of(table);
    assembly.begin_source(place);
    auto content = archive->read(table);
    if (!content) return content.error();
    content = unpacked(std::move(content).value(), place);
    if (!content) return content.error();
    auto error =
        read_member(*std::move(content), table, format != RecordingFormat::kTable, assembly);
    if (error) {
      if (error->location.source.empty()) error->location.source = place;
      return error;
    }
  }
  return std::nullopt;
}

// A list, which only tables are.
std::optional<Error> read_json_list(const Bytes& bytes, const std::string& source,
                                    const std::string& path, RecordingAssembly& assembly) {
  const auto document = JsonDocument::parse(without_byte_order_mark(bytes.view), source);
  if (!document) return document.error();
  if (is_json_table(document->root())) {
    return read_json_table(document->root(), stem_of(path), assembly);
  }
  const std::string words = json_words(without_byte_order_mark(bytes.view));
  if (words.starts_with("JSON of a kind")) {
    return Error{ErrorCode::kUnsupportedFormat, "this is " + words, {}};
  }
  return Error{ErrorCode::kUnsupportedFormat,
               "this is JSON, a list, but no table of records: each must be an object that names "
               "a position, as in {\"time_s\": 0, \"id\": \"a\", \"lon\": 8, \"lat\": 47, "
               "\"height_m\": 500}",
               {}};
}

std::optional<Error> read_json_file(const Bytes& bytes, const std::string& source,
                                    const std::string& path, RecordingAssembly& assembly) {
  auto documents = ShowDocuments::from_text(without_byte_order_mark(bytes.view), source);
  if (!documents) return documents.error();
  if (is_show(*documents)) return read_show(*documents, assembly);
  const bool any = assembly.options().format == RecordingFormat::kAuto;
  const JsonElement root = documents->root().element;
  if (any && is_vviz(root)) return read_vviz(root, assembly);
  if (any && is_aircraft_document(root)) return read_aircraft_document(root, assembly);
  if (any && is_flightradar24_feed(root)) return read_flightradar24_feed(root, assembly);
  if (any && is_json_table(root)) return read_json_table(root, stem_of(path), assembly);
  const std::string what = json_words(without_byte_order_mark(bytes.view));
  // What it is to be for this reader, but is not.
  const bool meant = what.find("'beespace replay'") != std::string::npos;
  if (any && (meant || what.starts_with("JSON of a kind"))) {
    return Error{
        ErrorCode::kUnsupportedFormat,
        "this is JSON of a kind that is not known: it does not list 'aircraft' (readsb) or "
        "'states' (OpenSky), nor is it a table with names of a position in it, nor a "
        "Skybrush show, as it has no 'swarm'; name another file, or export the recording "
        "as CSV",
        {}};
  }
  return Error{ErrorCode::kUnsupportedFormat,
               (any ? "this is " : "this is no Skybrush show, as it has no 'swarm', but ") + what,
               {}};
}

// The first character that is no blank; 0 where there is none.
char front_of(std::string_view bytes) {
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos ? text[first] : '\0';
}

// One input, whatever it holds.
std::optional<Error> read_source(Bytes bytes, const std::string& path,
                                 RecordingAssembly& assembly) {
  const RecordingFormat format = assembly.options().format;
  const std::string source = source_name(path);
  assembly.begin_source(source);
  assembly.add_bytes(bytes.view.size());
  auto content = unpacked(std::move(bytes), source);
  if (!content) return content.error();
  take_utf16(*content, assembly);
  if (is_zip(content->view)) {
    if (std::string words = words_of_zip(content->view); !words.empty()) {
      return Error{ErrorCode::kUnsupportedFormat, "this is " + words, {}};
    }
    return read_archive(*std::move(content), source, assembly);
  }
  const bool tables = format == RecordingFormat::kTable || format == RecordingFormat::kSkybrushCsv;
  const bool object = front_of(content->view) == '{';
  if (format == RecordingFormat::kAuto) {
    const std::string_view text = without_byte_order_mark(content->view);
    if (object && is_json_lines(text)) {
      if (is_aircraft_lines(text)) return read_aircraft_lines(text, assembly);
      return read_json_lines(text, stem_of(path), assembly);
    }
    if (front_of(text) == '[') return read_json_list(*content, source, path, assembly);
  }
  if (!tables && object) return read_json_file(*content, source, path, assembly);
  if (format == RecordingFormat::kAuto) {
    if (is_ulog(content->view)) return read_flight(content->view, path, assembly);
    if (is_dataflash_log(content->view)) return read_dataflash(content->view, path, assembly);
    if (is_stream_without_times(content->view)) return stream_without_times();
    if (is_telemetry_log(content->view)) return read_telemetry(content->view, path, assembly);
    if (is_base_station(content->view)) return read_base_station(content->view, assembly);
    const std::string_view text = without_byte_order_mark(content->view);
    if (is_daidalus_encounter(text)) return read_daidalus_encounter(text, assembly);
    if (auto problem = missing_units_of_encounter(text)) return *std::move(problem);
    if (is_bluesky_scenario(text)) return read_bluesky_scenario(text, assembly);
  }
  if (format == RecordingFormat::kSkybrushShow) {
    return Error{
        ErrorCode::kUnsupportedFormat,
        "this is no Skybrush show: neither a zip archive nor a JSON object; name the .skyc "
        "file",
        {}};
  }
  return read_text_table(*std::move(content), path, format == RecordingFormat::kSkybrushCsv,
                         assembly);
}

std::optional<Error> placed(std::optional<Error> error, const std::string& path) {
  if (error && error->location.source.empty()) error->location.source = source_name(path);
  return error;
}

// A file that is cut off, or damaged as a whole: nothing of it was read. What is wrong in a table
// of an archive has a place of its own.
bool is_nothing_read(const Error& error, const std::string& path) {
  const bool broken = error.code == ErrorCode::kTruncated || error.code == ErrorCode::kCorrupt;
  return broken && error.location.source == source_name(path);
}

// Of several files one that nothing was read of, as one that is being written, is left out where
// the caller leaves out what is bad.
std::optional<Error> or_left_out(std::optional<Error> error, const std::string& path,
                                 RecordingAssembly& assembly) {
  if (!error || !assembly.has_several() || !is_nothing_read(*error, path)) return error;
  if (assembly.options().skip_bad) {
    assembly.leave_broken_file_out(*std::move(error));
    return std::nullopt;
  }
  error->message += ", or leave such files out with --skip-bad";
  return error;
}

std::optional<Error> read_path(const std::string& path, RecordingAssembly& assembly) {
  if (is_folder(path)) {
    const auto files = recordings_in(path);
    if (!files) return files.error();
    if (files->size() > 1) assembly.expect_several();
    for (const std::string& file : *files) {
      if (auto error = read_path(file, assembly)) return error;
    }
    return std::nullopt;
  }
  auto bytes = open_bytes(path, nullptr);
  if (!bytes) return bytes.error();
  auto error = placed(read_source(std::move(bytes).value(), path, assembly), path);
  return or_left_out(std::move(error), path, assembly);
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
  std::vector<std::string> inputs = paths;
  for (const std::string& no_log : last_logs_in(paths)) std::erase(inputs, no_log);
  if (inputs.size() > 1) assembly.expect_several();
  std::vector<std::string> sources;
  for (const std::string& path : inputs) {
    const auto inside = is_folder(path) ? recordings_in(path) : std::vector<std::string>{path};
    if (!inside) return inside.error();
    for (const std::string& file : *inside) sources.push_back(source_name(file));
  }
  assembly.expect_sources(sources);
  for (const std::string& path : inputs) {
    if (auto error = read_path(path, assembly)) return *std::move(error);
  }
  count_left_out(paths, assembly);
  return assembly.finish();
}

Result<Recording> load_recording_from_memory(std::string_view content, const std::string& name,
                                             const RecordingOptions& options) {
  RecordingAssembly assembly(options);
  if (auto error = placed(read_source(copy_of(content), name, assembly), name)) {
    return *std::move(error);
  }
  return assembly.finish();
}

}  // namespace beespace::io
