// `beespace detect`.
#pragma once

#include "cli/command_line/command.hpp"

namespace beespace::cli {

Command detect_command();

}  // namespace beespace::cli
