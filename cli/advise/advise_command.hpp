// `beespace advise`.
#pragma once

#include "cli/command_line/command.hpp"

namespace beespace::cli {

Command advise_command();

}  // namespace beespace::cli
