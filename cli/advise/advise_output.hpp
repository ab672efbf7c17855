// The answer of `beespace advise` for programs, with all digits: a line for each bee, or one JSON
// document with everything in it.
#pragma once

#include "cli/advise/advise_input.hpp"
#include "cli/advise/advise_request.hpp"
#include "io/bytes/atomic_output.hpp"

#include <beespace/advise.hpp>

#include <cstdint>

namespace beespace::cli {

// What was asked, and what came of it.
struct AdviceAnswer {
  const AdviseRequest& request;
  const AdviceInput& given;
  const Advised& advised;
};

// How many are advised so, and how many are not certified.
std::uint64_t count(const Advised& advised, AdviceKind kind);
std::uint64_t count_uncertified(const Advised& advised);

// id, vx, vy, vz, advice, certified.
void write_as_csv(const AdviceAnswer& answer, io::AtomicOutput& output);

void write_as_json(const AdviceAnswer& answer, io::AtomicOutput& output);

}  // namespace beespace::cli
