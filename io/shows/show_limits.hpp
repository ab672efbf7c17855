// The limits that a Skybrush show declares, in settings.validation.
#pragma once

#include "io/recording/show_facts.hpp"
#include "io/shows/show_documents.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

struct DeclaredShowLimits {
  std::optional<double> least_distance_m = {};
  ShowLimits limits = {};
};

// Names may be written as "minDistance" or as "min_distance". Errors: of limits that are no numbers
// above zero, and of those that are declared in both ways and differ, with the document.
Result<DeclaredShowLimits> read_show_limits(ShowDocuments& documents);

}  // namespace beespace::io
