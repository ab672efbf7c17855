#include "cli/command_line/option_checks.hpp"

#include "cli/command_line/similar_word.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace beespace::cli {
namespace {

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) (text += text.empty() ? "" : ", ") += word;
  return text;
}

}  // namespace

void allow_only(CLI::Option& option, const std::vector<std::string>& words) {
  allow_only_or(
      option, words, [](const std::string&) { return false; }, "");
}

void allow_only_or(CLI::Option& option, const std::vector<std::string>& words,
                   const std::function<bool(const std::string&)>& otherwise,
                   const std::string& hint) {
  const auto problem = [words, otherwise, hint](const std::string& given) -> std::string {
    if (otherwise(given) || std::find(words.begin(), words.end(), given) != words.end()) return {};
    const auto meant = most_similar(given, words);
    return "'" + given + "' is none of " + listed(words) + hint +
           (meant ? "; did you mean '" + *meant + "'?" : std::string());
  };
  option.check(problem);
}

void refuse_pointless_values(CLI::App& command) {
  for (CLI::Option* option : command.get_options({})) {
    if (option->get_items_expected_max() == 0) {
      option->disable_flag_override();
      continue;
    }
    option->check([](const std::string& given) -> std::string {
      return given.empty() ? "the value is empty; give one, or leave it out" : "";
    });
  }
}

}  // namespace beespace::cli
