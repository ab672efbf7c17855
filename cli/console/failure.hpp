// How a run ends that went wrong.
#pragma once

#include "cli/console/exit_code.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

// Says what went wrong; with --json also where a program looks for it.
ExitCode fail(const Error& error, bool json);

}  // namespace beespace::cli
