// `beespace view`.
#pragma once

#include "cli/command_line/command.hpp"

namespace beespace::cli {

Command view_command();

}  // namespace beespace::cli
