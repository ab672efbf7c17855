// What a Skybrush show says of itself: settings.validation, settings.cues, environment.location.
#pragma once

#include "io/recording/recording_assembly.hpp"
#include "io/shows/show_documents.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

// Tells `assembly` of it. A location that is not understood is said, and not taken. Errors: of
// limits that are no numbers above zero, with the document.
std::optional<Error> read_show_settings(ShowDocuments& documents, RecordingAssembly& assembly);

}  // namespace beespace::io
