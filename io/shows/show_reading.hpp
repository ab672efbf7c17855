// A Skybrush show -> one path a drone, and the least distance that the show promises.
#pragma once

#include "io/recording/recording_assembly.hpp"
#include "io/shows/show_documents.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

// Whether a JSON text is one: it has a swarm.
bool is_show(const ShowDocuments& documents);

// Into the source that `assembly` has begun. Errors have the document and, of a drone, the record.
std::optional<Error> read_show(ShowDocuments& documents, RecordingAssembly& assembly);

}  // namespace beespace::io
