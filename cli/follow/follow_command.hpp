// `beespace follow`.
#pragma once

#include "cli/command_line/command.hpp"

namespace beespace::cli {

Command follow_command();

}  // namespace beespace::cli
