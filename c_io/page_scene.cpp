#include "c_io/page_scene.hpp"

#include "analysis/recorded/coverage.hpp"
#include "analysis/scene/load_scene.hpp"
#include "analysis/scene/snapshot_facts.hpp"
#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c_io/read_options.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace beespace::c_io {

namespace {

// Of more points only those have their own ids whose pairs are shown: as the command has it.
constexpr std::size_t kMostNames = 200'000;

// Of programs that were built before there was `ignore_below_m`.
constexpr std::size_t kFirstPageOptions = offsetof(beespace_io_page_options, ignore_below_m);

// The ids of all points, or of those in pairs.
template <class IdOf>
void name(const IdOf& id_of, report::SnapshotFacts& facts) {
  const std::size_t count = facts.positions.size();
  report::Names& names = facts.swarm.names;
  if (count <= kMostNames) {
    for (std::size_t i = 0; i < count; ++i) names.texts.push_back(id_of(i));
    return;
  }
  for (const Pair& pair : facts.pairs)
    names.bees.insert(names.bees.end(), {pair.first, pair.second});
  std::sort(names.bees.begin(), names.bees.end());
  names.bees.erase(std::unique(names.bees.begin(), names.bees.end()), names.bees.end());
  if (names.bees.empty()) return;  // none, and so no names: empty would mean all
  for (const PointId bee : names.bees) names.texts.push_back(id_of(bee));
  facts.swarm.notes.emplace_back(
      "only bees whose pairs are shown have their own ids; of the others, their number is shown");
}

// Points take off nowhere.
Status check_moves(const PageRequest& request) {
  if (!request.scene.ignore_below_m) return std::monostate{};
  return c::invalid("ignore_below_m is for recordings, and these are points; leave it out",
                    "page_options");
}

// What the reader has said, before what the search has to say.
void add_what_was_read(const beespace_io_facts& read, report::SnapshotFacts& facts) {
  std::vector<std::string> notes = read.notes;
  if (read.skipped_count > 0) {
    io::MissingRecords missing;
    missing.count = static_cast<std::uint64_t>(read.skipped_count);
    facts.unknown = analysis::missing_text(missing);
    notes.push_back("bad records left out: " + io::grouped(missing.count));
    notes.push_back("what is said is of those that are known: " + facts.unknown);
  }
  std::vector<std::string>& all = facts.swarm.notes;
  all.insert(all.begin(), notes.begin(), notes.end());
}

}  // namespace

Result<PageRequest> page_request(const beespace_io_page_options* options) {
  const auto given = c::read_struct(options, "page_options", kFirstPageOptions);
  if (!given) return given.error();
  if ((given->flags & ~static_cast<std::uint32_t>(BEESPACE_INCLUSIVE)) != 0) {
    return c::invalid("flags ask for what this function cannot do", "page_options");
  }
  PageRequest request;
  request.scene.threshold_m = given->threshold_m;
  request.scene.inclusive = (given->flags & BEESPACE_INCLUSIVE) != 0;
  request.scene.threads = threads_of(given->threads);
  if (given->max_gap_s < 0.0 || std::isnan(given->max_gap_s)) {
    return c::invalid("max_gap_s is below zero; 0 lets the recording say what a gap is",
                      "page_options");
  }
  if (given->max_gap_s > 0.0) request.scene.max_gap_s = given->max_gap_s;
  if (Status good = check_ignore_below(given->ignore_below_m, "page_options"); !good) {
    return good.error();
  }
  if (given->ignore_below_m > 0.0) request.scene.ignore_below_m = given->ignore_below_m;
  const auto vertical = vertical_of(given->vertical, "page_options");
  if (!vertical) return vertical.error();
  request.scene.vertical = *vertical;
  if (given->title != nullptr) request.title = given->title;
  request.run = given->run;
  return request;
}

Result<analysis::Scene> scene_of_files(const std::vector<std::string>& paths,
                                       const PageRequest& request) {
  auto scene = analysis::load_scene(paths, request.scene);
  if (!scene) return std::move(scene).error();
  if (!request.title.empty()) analysis::set_title(*scene, request.title);
  return scene;
}

Result<analysis::Scene> scene_of_read(const beespace_io_points& points,
                                      const PageRequest& request) {
  if (Status moves = check_moves(request); !moves) return moves.error();
  if (request.scene.vertical && points.loaded.frame == io::Frame::kWgs84) {
    return c::invalid(
        "these points were longitudes and latitudes, and z of their positions is not a height: "
        "make the page of the file itself, or leave vertical out",
        "page_options");
  }
  io::LoadedPoints searched;  // without records: what they say is in `points`
  searched.points = points.loaded.points;
  searched.frame = points.loaded.frame;
  searched.format_description = points.loaded.format_description;
  const std::string title = request.title.empty()
                                ? std::filesystem::path(points.path).filename().string()
                                : request.title;
  auto facts = analysis::snapshot_facts(searched, title, request.scene);
  if (!facts) return std::move(facts).error();
  add_what_was_read(points.facts, *facts);
  const auto id_of = [&points](std::size_t i) {
    const char* const id = points.ids ? points.ids->find(static_cast<std::int64_t>(i)) : "";
    return *id == '\0' ? std::to_string(points.rows[i]) : std::string(id);
  };
  if (points.ids || points.facts.skipped_count > 0) name(id_of, *facts);
  return analysis::Scene(*std::move(facts));
}

Result<analysis::Scene> scene_of_points(const PointsView& points,
                                        const std::vector<std::string>& ids,
                                        const PageRequest& request) {
  if (Status moves = check_moves(request); !moves) return moves.error();
  io::LoadedPoints searched;
  searched.points.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) searched.points.push_back(points[i]);
  searched.format_description = "points in memory";
  auto facts = analysis::snapshot_facts(searched, request.title.empty() ? "points" : request.title,
                                        request.scene);
  if (!facts) return std::move(facts).error();
  if (!ids.empty()) name([&ids](std::size_t i) { return ids[i]; }, *facts);
  return analysis::Scene(*std::move(facts));
}

}  // namespace beespace::c_io
