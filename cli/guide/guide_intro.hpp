// What `beespace guide` says when it begins: what follows from the figures of the fleet.
#pragma once

#include "cli/guide/guide_request.hpp"

#include <beespace/fleet.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::cli {

// Tube, thresholds, what is planned with, and the options that agents must have.
std::string guide_intro(const GuideRequest& request, const Tube& tube, std::uint32_t epoch,
                        std::size_t missing);

}  // namespace beespace::cli
