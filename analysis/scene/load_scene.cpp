#include "analysis/scene/load_scene.hpp"

#include "analysis/recorded/default_threshold.hpp"
#include "analysis/scene/fleet_facts.hpp"
#include "analysis/scene/recording_facts.hpp"
#include "analysis/scene/snapshot_facts.hpp"
#include "analysis/snapshot/recording_check.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/load_points.hpp"
#include "io/load_recording.hpp"
#include "io/points/loaded_points.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

using Loaded = std::variant<io::LoadedPoints, io::Recording>;

constexpr std::size_t kLongestHeader = 10'000;

bool has_time_column(std::string_view header) {
  if (header.size() > kLongestHeader) return false;
  for (const char delimiter : {',', ';', '\t'}) {
    io::FieldCursor cursor(header, delimiter);
    io::Field name;
    while (cursor.next(name)) {
      if (io::read_column_name(io::track_columns(), io::unquoted(name)).role == io::Role::kTime)
        return true;
    }
  }
  return false;
}

// Whether it is standard input, a pipe, or the like.
bool can_be_read_once(const std::string& path) {
  std::error_code unknown;
  return path == "-" || std::filesystem::is_other(path, unknown);
}

// Where the bytes come from: files by their names; what can be read once, kept.
class Inputs {
 public:
  static Result<Inputs> open(const std::vector<std::string>& paths, io::Progress* progress) {
    Inputs inputs;
    inputs.paths_ = paths;
    if (paths.size() != 1 || !can_be_read_once(paths.front())) return inputs;
    auto bytes = io::open_bytes(paths.front(), progress);
    if (!bytes) return std::move(bytes).error();
    inputs.kept_ = *std::move(bytes);
    return inputs;
  }

  [[nodiscard]] bool may_be_a_snapshot() const {
    std::error_code unknown;
    return paths_.size() == 1 && !std::filesystem::is_directory(paths_.front(), unknown);
  }
  // Whether the first line of a table names a time: then it is most likely a recording, and need
  // not be read twice.
  [[nodiscard]] bool names_a_time() const {
    const auto bytes = kept_ ? Result<io::Bytes>(*kept_) : io::open_bytes(first(), nullptr);
    return bytes && has_time_column(bytes->view.substr(0, bytes->view.find('\n')));
  }
  [[nodiscard]] const std::string& first() const { return paths_.front(); }

  [[nodiscard]] Result<io::LoadedPoints> load_points(const io::LoadOptions& options) const {
    return kept_ ? io::load_points_from_memory(kept_->view, io::source_name(first()), options)
                 : io::load_points(paths_.front(), options);
  }
  [[nodiscard]] Result<io::Recording> load_recording(const io::RecordingOptions& options) const {
    return kept_ ? io::load_recording_from_memory(kept_->view, io::source_name(first()), options)
                 : io::load_recording(paths_, options);
  }

 private:
  std::vector<std::string> paths_;
  std::optional<io::Bytes> kept_;
};

io::LoadOptions options_for_points(const SceneRequest& request, io::Progress* progress) {
  io::LoadOptions options;
  options.frame = request.load.frame;
  options.columns = request.load.columns;
  options.units = request.load.units;
  options.heights = request.load.heights;
  options.skip_bad = request.load.skip_bad;
  options.threads = request.threads;
  options.progress = progress;
  return options;
}

// Of what can be read neither way: what is wrong with the way that fits better. Of what is no text
// the reader of snapshots knows more; what is asked about a recording, or which of its columns are
// which, a snapshot that cannot be read does not answer.
Error better_of(Error as_snapshot, Error as_recording, bool names_a_time) {
  const bool is_question = (as_recording.code == ErrorCode::kInvalidArgument ||
                            as_recording.code == ErrorCode::kMissingColumn) &&
                           as_snapshot.code != ErrorCode::kInvalidArgument;
  // Pictures of a video may be as many moments.
  const bool of_video = as_recording.message.find("the frames of a video") != std::string::npos;
  if ((names_a_time || of_video) && is_question) return as_recording;
  const bool is_other = as_snapshot.code == ErrorCode::kUnsupportedFormat &&
                        !as_recording.message.starts_with("this is no text");
  return is_other ? std::move(as_recording) : std::move(as_snapshot);
}

// Of several files of which one is a snapshot: that is no recording for the lack of a column, but
// meant as something else.
Error or_snapshots(Error error, const SceneRequest& request, io::Progress* progress) {
  const std::string path = error.location.source;
  if (error.code != ErrorCode::kMissingColumn) return error;
  const auto points = io::load_points(path, options_for_points(request, progress));
  if (!points || has_time_column(io::header_line(*points))) return error;
  Error explained{ErrorCode::kMissingColumn,
                  "there are no times in this snapshot, and several files are read as one "
                  "recording; name one file, or set two beside each other: beespace report BEFORE "
                  "--compare AFTER",
                  {}};
  explained.location.source = path;
  return explained;
}

bool is_at_one_time(const io::Recording& recording) {
  std::optional<double> time_s;
  return std::all_of(recording.bees.begin(), recording.bees.end(), [&](const io::RecordedBee& bee) {
    return !bee.path && std::all_of(bee.fixes.begin(), bee.fixes.end(), [&](const Fix& fix) {
      if (!time_s) time_s = fix.time_s;
      return fix.time_s == *time_s;
    });
  });
}

// Whether all bees are at one time, or it is a look at aircraft, each last heard of at a time of
// its own. A table with several times is no such look: it says where all were when.
bool is_a_snapshot(const io::Recording& recording) {
  const std::string& format = recording.format_description;
  const bool table = format.starts_with("text") || format.starts_with("JSON");
  if (table && !is_at_one_time(recording)) return false;
  return std::all_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return !bee.path && bee.fixes.size() <= 1; });
}

Result<Loaded> load(const Inputs& inputs, const SceneRequest& request, io::Progress* progress) {
  io::RecordingOptions options = request.load;
  options.progress = progress;
  if (inputs.may_be_a_snapshot() && inputs.names_a_time()) {
    auto recording = inputs.load_recording(options);
    // Of aircraft at one time it tells how they fly on.
    if (recording && (recording->of_aircraft || !is_at_one_time(*recording))) {
      return Loaded(*std::move(recording));
    }
  }
  std::optional<Error> no_snapshot;
  if (inputs.may_be_a_snapshot()) {
    auto points = inputs.load_points(options_for_points(request, progress));
    if (points && !has_several_times(*points)) return Loaded(*std::move(points));
    if (!points && !is_about_data(points.error().code)) {
      return std::move(points).error();
    }
    if (!points) no_snapshot = std::move(points).error();
  }
  auto recording = inputs.load_recording(options);
  if (recording) return Loaded(*std::move(recording));
  if (!inputs.may_be_a_snapshot()) {
    return or_snapshots(std::move(recording).error(), request, progress);
  }
  if (!no_snapshot) return std::move(recording).error();
  return better_of(*std::move(no_snapshot), std::move(recording).error(), inputs.names_a_time());
}

std::string title_of(const std::vector<std::string>& inputs) {
  if (inputs.size() == 1 && inputs.front() == "-") return "standard input";
  std::filesystem::path path(inputs.front());
  if (!path.has_filename()) path = path.parent_path();  // of a folder, "flight/"
  std::string title = path.filename().string();
  if (inputs.size() > 1) title += " and " + std::to_string(inputs.size() - 1) + " more";
  return title;
}

// A recording, and what was said of its fleet, where that is asked for.
Result<report::RecordingFacts> facts_of(const io::Recording& recording, const std::string& title,
                                        const SceneRequest& request) {
  auto facts = recording_facts(recording, title, request);
  if (!facts || request.fleet_log.empty()) return facts;
  const bool skip_bad = request.load.skip_bad;
  const auto log = io::load_fleet_log(request.fleet_log, skip_bad, nullptr);
  if (!log) return log.error();
  auto fleet = fleet_facts(*log, recording, facts->tracks, skip_bad, facts->swarm.notes);
  if (!fleet) return std::move(fleet).error();
  facts->fleet = *std::move(fleet);
  return facts;
}

Status check_moves(const SceneRequest& request, const std::string& title) {
  if (request.ignore_below_m) {
    return Error{ErrorCode::kInvalidArgument,
                 "'" + title +
                     "' is a snapshot, which does not say where bees took off; leave "
                     "--ignore-below out",
                 {}};
  }
  if (request.load.sector) {
    return Error{
        ErrorCode::kInvalidArgument,
        "'" + title + "' is a snapshot, which no aircraft enters or leaves; leave --sector out",
        {}};
  }
  if (request.fleet_log.empty()) return std::monostate{};
  return Error{ErrorCode::kInvalidArgument,
               "'" + title +
                   "' is a snapshot, and the log of a fleet tells of a flight; give the recording "
                   "of that flight, or leave the log out",
               {}};
}

Status check_ahead(const SceneRequest& request, const std::string& title) {
  if (!request.horizon_s) return std::monostate{};
  return Error{ErrorCode::kInvalidArgument,
               "'" + title +
                   "' is not one moment with velocities, from which --horizon looks ahead; leave "
                   "it out",
               {}};
}

template <class Facts>
Result<Scene> scene_from(Result<Facts> facts) {
  if (!facts) return std::move(facts).error();
  return Scene(*std::move(facts));
}

Result<Scene> scene_of(const Loaded& loaded, const std::string& title,
                       const SceneRequest& request) {
  if (const auto* points = std::get_if<io::LoadedPoints>(&loaded)) {
    if (auto needed = threshold_needed(*points, typed_threshold(request), request.vertical)) {
      return *std::move(needed);
    }
    if (Status moves = check_moves(request, title); !moves) return std::move(moves).error();
    if (Status ahead = check_ahead(request, title); !ahead) return std::move(ahead).error();
    return scene_from(snapshot_facts(*points, title, request));
  }
  const auto& recording = std::get<io::Recording>(loaded);
  if (auto needed = threshold_needed(recording, typed_threshold(request), request.vertical)) {
    return *std::move(needed);
  }
  if (!is_a_snapshot(recording)) {
    if (Status ahead = check_ahead(request, title); !ahead) return std::move(ahead).error();
    return scene_from(facts_of(recording, title, request));
  }
  if (Status moves = check_moves(request, title); !moves) return std::move(moves).error();
  return scene_from(snapshot_facts(recording, title, request));
}

// Whether it declares how close is too close, or is of a kind of which something is usual.
bool has_threshold_of_its_own(const report::SwarmFacts& swarm) {
  return !swarm.threshold_words.empty();
}

}  // namespace

Result<Scene> load_scene(const std::vector<std::string>& inputs, const SceneRequest& request,
                         const SceneProgress& progress) {
  const auto enter = [&progress](SceneStage stage) {
    if (progress.entered) progress.entered(stage);
  };
  enter(SceneStage::kReading);
  const auto opened = Inputs::open(inputs, progress.reading);
  if (!opened) return opened.error();
  const auto loaded = load(*opened, request, progress.reading);
  if (!loaded) return loaded.error();
  enter(SceneStage::kSearching);
  return scene_of(*loaded, title_of(inputs), request);
}

Result<std::vector<Scene>> load_scenes(const std::vector<std::vector<std::string>>& inputs,
                                       const SceneRequest& request, const SceneProgress& progress) {
  std::vector<Scene> scenes;
  SceneRequest like_the_first = request;
  like_the_first.load.one_of_several = inputs.size() > 1;
  for (const auto& files : inputs) {
    auto scene = load_scene(files, like_the_first, progress);
    if (!scene) return std::move(scene).error();
    const report::SwarmFacts& swarm = swarm_of(*scene);
    like_the_first.origin = swarm.origin;
    like_the_first.fleet_log.clear();
    if (has_threshold_of_its_own(swarm)) like_the_first.threshold_m = swarm.threshold_m;
    scenes.push_back(*std::move(scene));
  }
  // What is compared is judged alike, though the second one may be the first that says how.
  // Standard input is read once.
  const auto is_kept = [](const std::string& name) { return name != "-"; };
  if (scenes.size() == 2 && std::all_of(inputs[0].begin(), inputs[0].end(), is_kept) &&
      like_the_first.threshold_m &&
      swarm_of(scenes[0]).threshold_m != swarm_of(scenes[1]).threshold_m) {
    SceneRequest like_the_second = request;
    like_the_second.load.one_of_several = true;
    like_the_second.threshold_m = like_the_first.threshold_m;
    auto again = load_scene(inputs.front(), like_the_second, progress);
    if (!again) return std::move(again).error();
    scenes.front() = *std::move(again);
  }
  return scenes;
}

}  // namespace beespace::analysis
