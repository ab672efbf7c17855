// `beespace watch`.
#pragma once

#include "cli/command_line/command.hpp"

namespace beespace::cli {

Command watch_command();

}  // namespace beespace::cli
