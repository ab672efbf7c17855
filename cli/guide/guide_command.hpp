// `beespace guide`.
#pragma once

#include "cli/command_line/command.hpp"

namespace beespace::cli {

Command guide_command();

}  // namespace beespace::cli
