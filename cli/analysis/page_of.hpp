// The page of one swarm, or of two that are compared.
#pragma once

#include "cli/analysis/see.hpp"
#include "cli/console/progress_bar.hpp"
#include "report/columns.hpp"
#include "report/page.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

struct MadePage {
  std::vector<Seen> seen;  // one, or before and after
  std::vector<std::string> swarms;
  report::Columns columns;
  SeenTimings timings;  // until here
};

// `compare` is the file to show beside, or nothing. Errors: kInvalidArgument where the two are not
// of a kind, or this build has no page; those of see().
Result<MadePage> page_of(const char* command, const SeenRequest& request,
                         const std::string& compare, ProgressBar& progress);

inline void write_page(const MadePage& page, const report::PageSink& sink) {
  report::write_page(report::page_template(), page.swarms, page.columns, sink);
}

}  // namespace beespace::cli
