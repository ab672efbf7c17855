// `beespace simulate`.
#pragma once

#include "cli/command_line/command.hpp"

namespace beespace::cli {

Command simulate_command();

}  // namespace beespace::cli
