// What a page of <beespace_io.h> shows, as the scene of it.
#pragma once

#include "analysis/scene/scene.hpp"
#include "analysis/scene/scene_request.hpp"
#include "c_io/points.hpp"

#include <beespace_io.h>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::c_io {

struct PageRequest {
  analysis::SceneRequest scene;
  std::string title;                  // empty: that of the input
  const beespace_run* run = nullptr;  // who may end the search
};

// Errors: kInvalidArgument.
Result<PageRequest> page_request(const beespace_io_page_options* options);

// Errors: those of reading and searching.
Result<analysis::Scene> scene_of_files(const std::vector<std::string>& paths,
                                       const PageRequest& request);
Result<analysis::Scene> scene_of_read(const beespace_io_points& points, const PageRequest& request);
// `ids` are of all points, or none.
Result<analysis::Scene> scene_of_points(const PointsView& points,
                                        const std::vector<std::string>& ids,
                                        const PageRequest& request);

}  // namespace beespace::c_io
