// Files that lie beside those that are read, in a folder or an archive. What may be in them is not
// known, unless their names say that no places are.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// Whether a file of that path, by its name, holds no places: texts and pictures for people, sound,
// models, programs and their settings, hidden files and what systems put beside.
bool holds_no_places(std::string_view path);

// Whether a file is what is read of another one, in a form for other programs: "a.h5" beside
// "a.csv", of which `stem` is "a".
bool is_other_form_of(std::string_view name, std::string_view stem);

// Counts what of the folders among `paths` is neither read nor harmless nor named, and notes it.
void count_left_out(const std::vector<std::string>& paths, RecordingAssembly& assembly);

// The same of an archive, of a show but for what has no places there, as lights: `names` are those
// of its files that are not read, `read` says what is.
void count_left_out(std::vector<std::string> names, std::string_view read,
                    RecordingAssembly& assembly);

}  // namespace beespace::io
