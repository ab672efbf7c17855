/// @file
/// @brief The caller's own number of an agent.
#pragma once

#include <cstdint>

namespace beespace {

/// @brief The caller's number of an agent: any value, such as an address or a hash of a name.
using AgentId = std::uint64_t;

}  // namespace beespace
