// What a person wants to know after a run, on a few aligned lines.
#pragma once

#include "cli/detect/detection.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::cli {

// The lines of one input, and of what was asked; `height_unit` is that of all heights.
void append_input(std::string& out, std::string_view label, const InputFacts& facts);
void append_repeated(std::string& out, const io::RepeatedIds& repeated);
// "5 (0.1 %)"; beyond so many records that were left out.
std::string at_risk_text(std::uint64_t at_risk, std::uint64_t points, std::uint64_t skipped);
void append_search(std::string& out, const DetectRequest& request, io::Unit height_unit);

std::string summary(const Inputs& inputs, const Detection& detection, const DetectRequest& request);

}  // namespace beespace::cli
