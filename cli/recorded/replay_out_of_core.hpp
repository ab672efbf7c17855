// `beespace replay --memory`: recordings that memory does not hold, cut in time.
#pragma once

#include "cli/recorded/replay_command.hpp"

namespace beespace::cli {

Result<ExitCode> run_replay_out_of_core(const ReplayRequest& request);

}  // namespace beespace::cli
