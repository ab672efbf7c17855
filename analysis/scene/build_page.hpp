// The page of one scene, or of two that are compared.
#pragma once

#include "analysis/scene/scene.hpp"
#include "report/columns.hpp"
#include "report/page.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::analysis {

struct Page {
  std::string json;
  report::Columns columns;
  report::Ground ground = report::Ground::kWithout;
};

// Error: kInvalidArgument where this build has no page.
Status check_has_page();

// Errors: kInvalidArgument where there are neither one nor two scenes, where two are not of a kind,
// or this build has no page.
Result<Page> build_page(const std::vector<Scene>& scenes);

void write_page(const Page& page, const report::PageSink& sink);

}  // namespace beespace::analysis
