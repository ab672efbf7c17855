#include "cli/show/view_command.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/terminal.hpp"
#include "cli/show/browser.hpp"
#include "cli/show/page_loading.hpp"
#include "cli/show/page_server.hpp"
#include "cli/show/report_command.hpp"
#include "cli/show/scene_summary.hpp"
#include "io/bytes/number_text.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kView = "view";

constexpr const char* kViewDescription = "Look at a swarm in the browser";

constexpr const char* kViewDetails =
    "Reads what 'beespace report' reads and makes the same page, but serves it to the browsers of\n"
    "this machine instead of writing a file: on a free port of 127.0.0.1, until Ctrl-C. Opens the\n"
    "browser where there is a desktop, and prints the address to standard output. Other users of\n"
    "this machine who find the port can read the page too.\n"
    "\n"
    "Examples:\n"
    "  beespace view bees.csv\n"
    "  beespace view show.skyc --no-open\n"
    "  beespace view before.csv --compare after.csv --threshold 5\n"
    "  beespace view flown.csv --fleet-log fleet.ndjson --threshold 5\n"
    "\n"
    "Exit status: 2 wrong usage, 3 bad input, 4 cannot open, read or serve, 130 ended by Ctrl-C, "
    "143\n"
    "terminated, 141 closed pipe.";

Result<std::uint16_t> read_port(const Typed& typed) {
  const auto port = io::parse_whole(typed.text);
  if (port && *port <= std::numeric_limits<std::uint16_t>::max()) {
    return static_cast<std::uint16_t>(*port);
  }
  return usage_error(typed.command,
                     "--port is '" + typed.text + "'; give a number up to 65535, or 0 for any");
}

struct ViewRequest {
  ReportRequest page;
  std::uint16_t port = 0;  // a free one
  bool no_open = false;
};

// The whole page, and nothing of what it was made from: that is as large again, and the page is
// served for long.
Result<std::string> page_for(const ReportRequest& request, const std::string& address) {
  ProgressBar progress(!request.show.moving.quiet);
  const auto loaded = load_page(kView, request, progress);
  if (!loaded) return loaded.error();
  std::string page;
  analysis::write_page(loaded->page, [&](std::string_view text) { page += text; });
  progress.finish();
  if (!request.show.moving.quiet) {
    std::string text;
    for (const analysis::Scene& scene : loaded->scenes)
      append_scene(text, scene, request.show.moving);
    append_worst_link(text, address, loaded->scenes);
    say(text);
  }
  return page;
}

Result<ExitCode> run_view(const ViewRequest& request) {
  auto server = PageServer::open(request.port);
  if (!server) return std::move(server).error();
  const std::string address = server->address();
  const auto page = page_for(request.page, address);
  if (!page) return page.error();
  if (const ExitCode printed = print(address + "\n"); printed != ExitCode::kFine) return printed;
  const auto tell = [quiet = request.page.show.moving.quiet](bool opened) {
    if (quiet) return;
    say(opened ? "Opened in the browser; Ctrl-C ends it.\n"
               : "Open this address in a browser on this machine; Ctrl-C ends it.\n");
  };
  if (request.no_open) {
    tell(false);
  } else {
    open_in_browser(address, tell);
  }
  server->serve(*page);
  return ExitCode::kFine;
}

}  // namespace

Command view_command() {
  const auto request = std::make_shared<ViewRequest>();
  MovingRequest& moving = request->page.show.moving;
  Command view(kView, kViewDescription, kViewDetails, [request](const Command&) {
    return settle(request->page.show.moving, kView).and_then([&] { return run_view(*request); });
  });
  add_page_input_options(view, request->page);
  view.group("Output");
  view.flag("--no-open", request->no_open, "Do not open a browser, only print the address");
  view.option("--port", "N", request->port, read_port,
              "Of 127.0.0.1, to serve at (default: 0, a free one)");
  add_error_json_option(view, moving);
  view.flag("--quiet", moving.quiet, "No summary and no progress, only the address and errors");
  return view;
}

}  // namespace beespace::cli
