#include "analysis/scene/build_page.hpp"
#include "c/door/door.hpp"
#include "c/door/points.hpp"
#include "c/door/watched_call.hpp"
#include "c_io/door.hpp"
#include "c_io/page_scene.hpp"
#include "c_io/read_options.hpp"
#include "c_io/wording.hpp"
#include "io/bytes/atomic_output.hpp"
#include "io/recording/recording_sources.hpp"

#include <beespace_io.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::PointsView;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;
using beespace::c::invalid;
namespace analysis = beespace::analysis;
namespace io = beespace::io;

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_io_page {
  std::string html;
  std::vector<std::string> notes;
  bool risky = false;
  std::vector<std::string> read_from;
};

namespace {

// The notes as they are on the page, too.
std::vector<std::string> reword_notes(analysis::Scene& scene) {
  return std::visit(
      [](auto& facts) {
        for (std::string& note : facts.swarm.notes) note = in_words_of_programs(std::move(note));
        return facts.swarm.notes;
      },
      scene);
}

// The scene of(request), which those may end who the request names.
template <class Of>
Result<analysis::Scene> watched_scene(PageRequest request, Of& of) {
  std::optional<Result<analysis::Scene>> scene;
  Status watched = beespace::c::call_watched(request.run, [&](const RunOptions& run) -> Status {
    request.scene.stop = run.stop;
    scene.emplace(of(request));
    return *scene ? Status(std::monostate{}) : Status(scene->error());
  });
  if (!watched) return std::move(watched).error();
  return *std::move(scene);
}

// Makes the scene by of(request), and the page of it.
template <class Of>
beespace_code make_page(const beespace_io_page_options* options, beespace_io_page** page,
                        beespace_io_error* error, std::vector<std::string>& read_from, Of&& of) {
  if (page != nullptr) *page = nullptr;
  return enter(error, [&]() -> Status {
    if (page == nullptr) return invalid("the pointer to the page is NULL", "page");
    if (Status has = analysis::check_has_page(); !has) return has;
    const auto request = page_request(options);
    if (!request) return request.error();
    Result<analysis::Scene> scene = watched_scene(*request, of);
    if (!scene) return std::move(scene).error();
    auto made = std::make_unique<beespace_io_page>();
    made->notes = reword_notes(*scene);
    made->risky = analysis::is_risky(*scene);
    made->read_from = std::move(read_from);
    const auto built = analysis::build_page({*std::move(scene)});
    if (!built) return built.error();
    analysis::write_page(*built, [&](std::string_view text) { made->html += text; });
    *page = made.release();
    return std::monostate{};
  });
}

// Through links, and of a folder what is read of it.
bool is_read(const std::string& output, const std::string& input) {
  std::error_code not_there;
  if (!io::is_folder(input)) return std::filesystem::equivalent(output, input, not_there);
  const auto files = io::recordings_in(input);
  return files && std::any_of(files->begin(), files->end(), [&](const std::string& file) {
           return std::filesystem::equivalent(output, file, not_there);
         });
}

Status write(const beespace_io_page& page, const char* path) {
  const auto name = path_of(path);
  if (!name) return name.error();
  std::error_code not_there;
  if (std::filesystem::is_regular_file(*name, not_there)) {
    for (const std::string& input : page.read_from) {
      if (!is_read(*name, input)) continue;
      auto error = invalid("the page was made of this file; name another one", "path");
      error.location.source = *name;
      return error;
    }
  }
  auto output = io::AtomicOutput::open(*name);
  if (!output) return std::move(output).error();
  output->write(page.html);
  return output->commit();
}

Result<std::vector<std::string>> ids_of(const char* const* ids, std::size_t count) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; ids != nullptr && i < count; ++i) {
    if (ids[i] == nullptr) return invalid("an id is NULL; an empty text is one, too", "ids");
    texts.emplace_back(ids[i]);
  }
  return texts;
}

}  // namespace

extern "C" {

beespace_code beespace_io_page_of_files(const char* const* paths, int64_t path_count,
                                        const beespace_io_options* options,
                                        const beespace_io_page_options* page_options,
                                        beespace_io_page** page, beespace_io_error* error) {
  std::vector<std::string> read_from;
  return make_page(page_options, page, error, read_from,
                   [&](PageRequest request) -> Result<analysis::Scene> {
                     auto names = paths_of(paths, path_count);
                     if (!names) return std::move(names).error();
                     auto load = recording_options(options);
                     if (!load) return std::move(load).error();
                     const auto tolerance_m = tolerance_of(options);
                     if (!tolerance_m) return tolerance_m.error();
                     request.scene.load = *std::move(load);
                     request.scene.tolerance_m = *tolerance_m;
                     read_from = *std::move(names);
                     return scene_of_files(read_from, request);
                   });
}

beespace_code beespace_io_page_of_read(const beespace_io_points* points,
                                       const beespace_io_page_options* page_options,
                                       beespace_io_page** page, beespace_io_error* error) {
  std::vector<std::string> read_from;
  return make_page(page_options, page, error, read_from,
                   [&](const PageRequest& request) -> Result<analysis::Scene> {
                     if (points == nullptr) {
                       return invalid("the pointer to the points is NULL", "points");
                     }
                     read_from = {points->path};
                     return scene_of_read(*points, request);
                   });
}

beespace_code beespace_io_page_of_points(const beespace_points* points, const char* const* ids,
                                         const beespace_io_page_options* page_options,
                                         beespace_io_page** page, beespace_io_error* error) {
  std::vector<std::string> read_from;
  return make_page(page_options, page, error, read_from,
                   [&](const PageRequest& request) -> Result<analysis::Scene> {
                     const Result<PointsView> view = beespace::c::view_of(points, "points");
                     if (!view) return view.error();
                     const auto names = ids_of(ids, view->size());
                     if (!names) return names.error();
                     return scene_of_points(*view, *names, request);
                   });
}

void beespace_io_page_free(beespace_io_page* page) {
  delete page;
}

const char* beespace_io_page_html(const beespace_io_page* page, size_t* size) {
  if (size != nullptr) *size = page == nullptr ? 0 : page->html.size();
  return page == nullptr ? "" : page->html.c_str();
}

beespace_code beespace_io_page_write(const beespace_io_page* page, const char* path,
                                     beespace_io_error* error) {
  return enter(error, [&]() -> Status {
    if (page == nullptr) return invalid("the pointer to the page is NULL", "page");
    return write(*page, path);
  });
}

int32_t beespace_io_page_risky(const beespace_io_page* page) {
  return page != nullptr && page->risky ? 1 : 0;
}

int64_t beespace_io_page_note_count(const beespace_io_page* page) {
  return page == nullptr ? 0 : static_cast<int64_t>(page->notes.size());
}

const char* beespace_io_page_note(const beespace_io_page* page, int64_t index) {
  if (index < 0 || index >= beespace_io_page_note_count(page)) return nullptr;
  return page->notes[static_cast<std::size_t>(index)].c_str();
}

}  // extern "C"
