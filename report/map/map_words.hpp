// What map files say in words, in HTML where globes read it as such.
#pragma once

#include "report/facts.hpp"

#include <string>
#include <vector>

namespace beespace::report {

// "maya – willi": plain text.
std::string pair_name(const Names& names, PointId first, PointId second);

// "57.3 m from maya": HTML; nothing where there is nobody else.
std::string nearest_words(const Nearest& nearest, const Names& names);

// What heights mean, and the notes, one a line: HTML.
std::string document_words(const std::vector<std::string>& notes);

}  // namespace beespace::report
