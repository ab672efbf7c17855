#include "cli/console/failure.hpp"

#include "cli/console/error_json.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/atomic_output.hpp"

namespace beespace::cli {

ExitCode fail(const Error& error, bool json) {
  say_error(printable(to_string(error)));
  if (json) {
    auto output = io::AtomicOutput::open("-");
    if (output) {
      output->write(error_as_json(error));
      // That it is not read is not worse than what went wrong already.
      static_cast<void>(output->commit());
    }
  }
  return exit_code_for(error.code);
}

}  // namespace beespace::cli
