// The one file that knows CLI11, whose headers take long to compile.

#include "cli/command_line/parser.hpp"

#include "cli/command_line/similar_word.hpp"
#include "cli/console/failure.hpp"
#include "cli/console/recipe_text.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/terminal.hpp"

#include <beespace/version.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace beespace::cli {
namespace {

constexpr const char* kVersionHelp = "Print the version and exit";
constexpr std::size_t kColumnOfHelp = 34;

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : parent->get_name() + " " + command.get_name();
}

// The subcommand in use, or the command itself: whose help is meant.
const CLI::App& used_command(const CLI::App& command) {
  const auto used = command.get_subcommands();
  return used.empty() ? command : *used.front();
}

std::vector<std::string> subcommands_of(const CLI::App& command) {
  const auto subcommands = command.get_subcommands({});
  std::vector<std::string> names;
  names.reserve(subcommands.size());
  for (const CLI::App* sub : subcommands) names.push_back(sub->get_name());
  return names;
}

// "detect, predict or help": what it can be told to do.
std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : " or ";
    text += words[i];
  }
  return text;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const auto meant = most_similar(word, known);
  return meant ? "; did you mean '" + *meant + "'?" : std::string();
}

// What people call an option of another name.
std::string other_name(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::array<std::string_view, 9> kThreshold = {
      "--min-distance",     "--mindist",         "--min-dist",
      "--minimum-distance", "--distance",        "--separation-distance",
      "--min-separation",   "--safety-distance", "--t"};
  constexpr const char* kMeant = "--threshold";
  const bool meant = std::find(kThreshold.begin(), kThreshold.end(), word) != kThreshold.end() &&
                     std::find(known.begin(), known.end(), kMeant) != known.end();
  return meant ? std::string("; did you mean '") + kMeant + "'?" : std::string();
}

std::string unknown_option(const CLI::App& command, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) known.push_back(option->get_name());
  }
  // "-q" and "-threshold" are looked for as "--q" and "--threshold".
  const std::string name = word.substr(0, word.find('='));
  const std::size_t letters = std::min(name.find_first_not_of('-'), name.size());
  std::string text = "'" + word + "' is no option of '" + full_name(command) + "'";
  if (command.get_parent() == nullptr) {
    text += ", whose options follow " + alternatives(subcommands_of(command));
  }
  const std::string typed = "--" + name.substr(letters);
  const std::string other = other_name(typed, known);
  return text + (other.empty() ? did_you_mean(typed, known) : other);
}

std::string unknown_argument(const CLI::App& command, const std::string& word) {
  if (command.get_parent() != nullptr) {
    return "'" + word + "' is one argument too many for '" + full_name(command) + "'";
  }
  const std::vector<std::string> known = subcommands_of(command);
  return "'" + word + "' is nothing that beespace does; say " + alternatives(known) +
         did_you_mean(word, known);
}

// About the words that are left over. After an unknown option its value is left over too, so that
// the first option among them says most.
std::string unexpected(const CLI::App& command, const std::vector<std::string>& words) {
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  return option != words.end() ? unknown_option(command, *option)
                               : unknown_argument(command, words.front());
}

std::string wrong_count(const CLI::App& command, const std::string& message) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() > 0 && option->count() > 1) {
      return option->get_name() + " is given " + std::to_string(option->count()) +
             " times; give it once";
    }
  }
  const std::string name = message.substr(0, message.find_first_of(": "));
  // Of a flag CLI11 says the name without its dashes.
  const bool is_flag = message.find("flag override") != std::string::npos;
  return is_flag ? "--" + name + " takes no value" : name + " needs a value";
}

std::string usage_sentence(const CLI::App& command, const CLI::ParseError& error) {
  if (const auto words = command.remaining(); !words.empty()) return unexpected(command, words);
  const CLI::App& used = used_command(command);
  const bool mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
  if (mismatch) return wrong_count(used, error.what());
  if (const auto words = used.remaining(); !words.empty()) return unexpected(used, words);
  return error.what();
}

ExitCode explain(const CLI::App& command, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr) {
    return print("beespace " + std::string(version()) + "\n");
  }
  if (dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr) return print(command.help());
  const std::string name = full_name(used_command(command));
  say_error(printable(usage_sentence(command, error)) + " (see '" + name + " --help')");
  return ExitCode::kUsage;
}

// An empty text is what an unset variable of a script leaves.
std::string problem_of_empty(const std::string& given) {
  return given.empty() ? "the value is empty; give one, or leave it out" : "";
}

void add_option(CLI::App& app, Option& option) {
  CLI::Option* added = nullptr;
  if (option.takes == Option::Takes::kNone) {
    added = app.add_flag(option.names, option.given, option.help)->disable_flag_override();
  } else if (option.takes == Option::Takes::kAny) {
    added = app.add_option(option.names, option.typed, option.help);
  } else {
    option.typed.resize(1);
    added = app.add_option(option.names, option.typed.front(), option.help);
  }
  if (!option.group.empty()) added->group(option.group);
  if (option.takes == Option::Takes::kNone) return;
  added->type_name(option.is_argument() ? " " : option.value)->required(option.required);
  if (option.problem) added->check(option.problem);
  added->check(problem_of_empty);
}

// Those that the parser answers itself; they take no value either.
void set_own_flags(CLI::App& app) {
  app.set_help_flag("-h,--help", "Print this help and exit")->disable_flag_override();
  app.set_version_flag("--version", std::string(version()), kVersionHelp)->disable_flag_override();
}

CLI::App* add_command(CLI::App& app, Command& command) {
  CLI::App* added = app.add_subcommand(command.name(), command.summary());
  added->footer(command.details());
  set_own_flags(*added);
  for (Option& option : command.options()) add_option(*added, option);
  return added;
}

// "beespace help detect", for those who do not try --help first.
Command help_command(const std::vector<Command>& commands, std::string& topic) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const Command& command : commands) names.push_back(command.name());
  Command help("help", "Print this help, or that of a subcommand", "",
               [](const Command&) { return ExitCode::kFine; });
  allow_only(help.argument("COMMAND", topic, "Whose help to print"), std::move(names));
  return help;
}

}  // namespace

ExitCode run_command_line(Program& program, int argc, char** argv) {
  CLI::App app(program.summary, program.name);
  set_own_flags(app);
  app.footer(program.examples);
  app.get_formatter()->column_width(kColumnOfHelp);
  std::vector<CLI::App*> added;
  added.reserve(program.commands.size());
  for (Command& command : program.commands) added.push_back(add_command(app, command));
  std::string topic;
  Command help = help_command(program.commands, topic);
  CLI::App* const help_app = app.add_subcommand(help.name(), help.summary());
  add_option(*help_app, help.options().front());
  // At most one, so that a file may be called as the other.
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
    topic = help.options().front().typed.front();
    if (help_app->parsed()) app.parse(topic.empty() ? "--help" : topic + " --help");
  } catch (const CLI::ParseError& error) {
    return explain(app, error);
  }
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (!added[i]->parsed()) continue;
    Command& command = program.commands[i];
    for (Option& option : command.options()) {
      if (option.takes != Option::Takes::kNone) {
        option.given = added[i]->get_option(option.name())->count() > 0;
      }
    }
    const auto code = command.run();
    if (code) return *code;
    Error error = code.error();
    error.message = with_what_was_typed(std::move(error.message), error.location.source,
                                        {.threshold = command.typed("--threshold"),
                                         .separation = command.typed("--separation"),
                                         .vertical = command.typed("--vertical")});
    return fail(error, command.is_given("--json"));
  }
  say_error("say what to do: " + alternatives(subcommands_of(app)) + " (see 'beespace --help')");
  return ExitCode::kUsage;
}

}  // namespace beespace::cli
