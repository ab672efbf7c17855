// Ctrl-C, termination and closed pipes: leave quietly, with the right exit code, and leave no
// temporary files behind.
#pragma once

#include "cli/console/exit_code.hpp"

namespace beespace::cli {

// SIGINT ends the program with 130, SIGTERM with 143, SIGHUP with 129, unless the one who started
// it had them ignored (nohup). SIGPIPE is ignored: a closed pipe is seen as a failed write. SIGBUS,
// which comes when a mapped input becomes shorter, ends it with 4 and says so.
void handle_signals();

// From now on the first SIGINT, SIGTERM or SIGHUP only asks for an end, which interrupted() tells;
// the second ends the program as before. For commands that have something to say at their end, and
// then exit as they would have.
void let_interruption_wait();
bool interrupted();
ExitCode exit_code_of_interruption();

}  // namespace beespace::cli
