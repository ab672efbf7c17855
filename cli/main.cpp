// The beespace command: reads the command line and hands over to the subcommand.

#include "cli/advise/advise_command.hpp"
#include "cli/bench/bench_command.hpp"
#include "cli/command_line/option_checks.hpp"
#include "cli/command_line/usage_sentence.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/console/signals.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/terminal.hpp"
#include "cli/detect/detect_command.hpp"
#include "cli/generate/generate_command.hpp"
#include "cli/recorded/predict_command.hpp"
#include "cli/recorded/replay_command.hpp"
#include "cli/recorded/verify_command.hpp"
#include "cli/show/export_command.hpp"
#include "cli/show/plot_command.hpp"
#include "cli/show/report_command.hpp"
#include "cli/show/view_command.hpp"
#include "cli/simulate/simulate_command.hpp"
#include "cli/watch/watch_command.hpp"

#include <beespace/version.hpp>

#include <CLI/CLI.hpp>

#include <exception>
#include <new>
#include <string>

namespace beespace::cli {
namespace {

constexpr const char* kDescription =
    "Who is too close to whom, exactly and fast: separation checks for swarms.";

constexpr const char* kExamples =
    "Examples:\n"
    "  beespace detect bees.csv                      who is closer than 100 m to another bee\n"
    "  beespace detect bees.csv --report pairs       who is too close to whom, and how close\n"
    "  beespace predict swarm.csv --threshold 5      who is about to come too close to whom\n"
    "  beespace replay show.skyc                     whether a drone show keeps its distance\n"
    "  tail -f swarm.csv | beespace watch            the same live\n"
    "  beespace advise swarm.csv                     how everybody should fly to keep apart\n"
    "  beespace simulate random-swap                 a swarm that is kept apart, step by step\n"
    "  beespace verify flight.csv --threshold 5      whether a flight kept its distance\n"
    "  beespace report bees.csv -o report.html       a page that shows it\n"
    "  beespace view show.skyc                       the same, in the browser at once\n"
    "  beespace plot bees.csv -o bees.svg            a picture of it\n"
    "  beespace export bees.csv -o bees.kml          for globes, maps and spreadsheets\n"
    "  beespace generate --points 1000 --area medellin --output bees.csv\n"
    "  beespace bench                                how fast it is on this machine\n"
    "\n"
    "'beespace help detect' says more about detect, and so on.";

// The subcommand in use, or the command itself: whose help is meant.
const CLI::App& used_command(const CLI::App& command) {
  const auto used = command.get_subcommands();
  return used.empty() ? command : *used.front();
}

ExitCode explain(const CLI::App& command, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr) {
    return print("beespace " + std::string(version()) + "\n");
  }
  if (dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr) return print(command.help());
  const std::string name = &used_command(command) == &command
                               ? "beespace"
                               : "beespace " + used_command(command).get_name();
  say_error(printable(usage_sentence(command, error)) + " (see '" + name + " --help')");
  return ExitCode::kUsage;
}

// "beespace help detect", for those who do not try --help first.
CLI::App* add_help_command(CLI::App& command, std::string& topic) {
  CLI::App* help = command.add_subcommand("help", "Print this help, or that of a subcommand");
  CLI::Option* option = help->add_option("COMMAND", topic, "Whose help to print")->type_name(" ");
  allow_only(*option, {"detect", "predict", "replay", "watch", "advise", "simulate", "verify",
                       "report", "view", "plot", "export", "generate", "bench"});
  return help;
}

ExitCode run(int argc, char** argv) {
  handle_signals();
  CLI::App command(kDescription, "beespace");
  command.set_version_flag("--version", std::string(version()), "Print the version and exit");
  command.set_help_flag("-h,--help", "Print this help and exit");
  command.footer(kExamples);
  command.get_formatter()->column_width(34);
  DetectOptions detect_options;
  PredictCommandOptions predict_options;
  ReplayOptions replay_options;
  WatchOptions watch_options;
  AdviseCommandOptions advise_options;
  SimulateOptions simulate_options;
  VerifyCommandOptions verify_options;
  ReportOptions report_options;
  ViewOptions view_options;
  PlotOptions plot_options;
  ExportOptions export_options;
  GenerateOptions generate_options;
  BenchOptions bench_options;
  std::string help_topic;
  const CLI::App* detect = add_detect_command(command, detect_options);
  const CLI::App* predict = add_predict_command(command, predict_options);
  const CLI::App* replay = add_replay_command(command, replay_options);
  const CLI::App* watch = add_watch_command(command, watch_options);
  const CLI::App* advise = add_advise_command(command, advise_options);
  const CLI::App* simulate = add_simulate_command(command, simulate_options);
  const CLI::App* verify = add_verify_command(command, verify_options);
  const CLI::App* report = add_report_command(command, report_options);
  const CLI::App* view = add_view_command(command, view_options);
  const CLI::App* plot = add_plot_command(command, plot_options);
  const CLI::App* exported = add_export_command(command, export_options);
  const CLI::App* generate = add_generate_command(command, generate_options);
  add_bench_command(command, bench_options);
  const CLI::App* help = add_help_command(command, help_topic);
  // At most one, so that a file may be called as the other.
  command.require_subcommand(0, 1);
  try {
    command.parse(argc, argv);
    if (help->parsed()) command.parse(help_topic.empty() ? "--help" : help_topic + " --help");
  } catch (const CLI::ParseError& error) {
    return explain(command, error);
  }
  if (command.get_subcommands().empty()) {
    say_error("say what to do: " + names_of_subcommands(command) + " (see 'beespace --help')");
    return ExitCode::kUsage;
  }
  if (detect->parsed()) return run_detect(detect_options);
  if (predict->parsed()) return run_predict(predict_options);
  if (replay->parsed()) return run_replay(replay_options);
  if (watch->parsed()) return run_watch(watch_options);
  if (advise->parsed()) return run_advise(advise_options);
  if (simulate->parsed()) return run_simulate(simulate_options);
  if (verify->parsed()) return run_verify(verify_options);
  if (report->parsed()) return run_report(report_options);
  if (view->parsed()) return run_view(view_options);
  if (plot->parsed()) return run_plot(plot_options);
  if (exported->parsed()) return run_export(export_options);
  return generate->parsed() ? run_generate(generate_options) : run_bench(bench_options);
}

}  // namespace
}  // namespace beespace::cli

int main(int argc, char** argv) {
  using beespace::cli::ExitCode;
  try {
    return static_cast<int>(beespace::cli::run(argc, argv));
  } catch (const std::bad_alloc&) {
    // Said without a string, for which there may be no memory either.
    beespace::cli::say("beespace: error: out of memory; close other programs or split the input\n");
  } catch (const std::exception& problem) {
    beespace::cli::say("beespace: error: this is a defect of beespace, please report it: ");
    beespace::cli::say(problem.what());
    beespace::cli::say("\n");
  }
  return static_cast<int>(ExitCode::kSystem);
}
