// What map files say in words, in HTML where globes read it as such.
#pragma once

#include "report/facts.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::report {

// "maya – willi": plain text.
std::string pair_name(const Names& names, PointId first, PointId second);
// As the two are called when they are closest.
std::string pair_name(const Names& names, const Conflict& conflict);

// "57.3 m from maya": HTML; nothing where there is no other.
std::string nearest_words(const Nearest& nearest, const SwarmFacts& swarm);

// "57.3 m apart"; with a vertical threshold "3.19 NM across, 800 ft in height". Of the pair, or
// conflict, of that index.
std::string pair_words(const SnapshotFacts& facts, std::size_t pair);
// "57.3 m apart at 2024-05-01T12:00:30Z; possible, not certain".
std::string conflict_words(const RecordingFacts& facts, std::size_t conflict);

// "of 204,480 pairs, the closest 10,000 are in the file"; nothing where the facts have all.
std::string kept_words(const SnapshotFacts& facts);
std::string kept_words(const RecordingFacts& facts);

// Whether heights count from a place of take-off of which it is not known how high it is.
bool counts_from_unknown_ground(const SwarmFacts& swarm);

// What heights are counted from, and the notes, one a line, none for those that are empty: HTML.
std::string document_words(const SwarmFacts& swarm, const std::string& kept,
                           const std::vector<std::string>& notes);

}  // namespace beespace::report
