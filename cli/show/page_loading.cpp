#include "cli/show/page_loading.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/stopwatch.hpp"

#include <algorithm>
#include <utility>

namespace beespace::cli {

Result<LoadedPage> load_page(const char* command, const ShowRequest& request,
                             const std::string& compare, ProgressBar& progress) {
  if (const Status has = analysis::check_has_page(); !has) {
    return usage_error(command, has.error().message);
  }
  const auto& inputs = request.moving.inputs;
  if (compare == "-" && std::count(inputs.begin(), inputs.end(), "-") > 0) {
    return usage_error(command, "standard input can be read once");
  }
  std::vector<std::vector<std::string>> all{inputs};
  if (!compare.empty()) all.push_back({compare});
  LoadedPage loaded;
  auto scenes = load_scenes(all, scene_request(request), progress, loaded.timings);
  if (!scenes) return std::move(scenes).error();
  loaded.scenes = *std::move(scenes);
  progress.enter_stage("writing");
  Stopwatch watch;
  auto page = analysis::build_page(loaded.scenes);
  if (!page) return usage_error(command, page.error().message);
  loaded.page = *std::move(page);
  loaded.timings.write_s = watch.lap();
  return loaded;
}

}  // namespace beespace::cli
