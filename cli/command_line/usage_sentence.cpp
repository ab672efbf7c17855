#include "cli/command_line/usage_sentence.hpp"

#include "cli/command_line/similar_word.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace beespace::cli {
namespace {

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : parent->get_name() + " " + command.get_name();
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const auto meant = most_similar(word, known);
  return meant ? "; did you mean '" + *meant + "'?" : std::string();
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
    text += ", whose options follow " + names_of_subcommands(command);
  }
  return text + did_you_mean("--" + name.substr(letters), known);
}

std::string unknown_argument(const CLI::App& command, const std::string& word) {
  if (command.get_parent() != nullptr) {
    return "'" + word + "' is one argument too many for '" + full_name(command) + "'";
  }
  std::vector<std::string> known;
  for (const CLI::App* sub : command.get_subcommands({})) known.push_back(sub->get_name());
  return "'" + word + "' is nothing that beespace does; say " + names_of_subcommands(command) +
         did_you_mean(word, known);
}

// About the words that nobody took. After an unknown option its value is left over too, so that
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

}  // namespace

std::string names_of_subcommands(const CLI::App& command) {
  const auto subcommands = command.get_subcommands({});
  std::string names;
  for (std::size_t i = 0; i < subcommands.size(); ++i) {
    if (i > 0) names += i + 1 < subcommands.size() ? ", " : " or ";
    names += subcommands[i]->get_name();
  }
  return names;
}

std::string usage_sentence(const CLI::App& command, const CLI::ParseError& error) {
  if (const auto words = command.remaining(); !words.empty()) return unexpected(command, words);
  const auto subcommands = command.get_subcommands();
  const CLI::App& used = subcommands.empty() ? command : *subcommands.front();
  const bool mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
  if (mismatch) return wrong_count(used, error.what());
  if (const auto words = used.remaining(); !words.empty()) return unexpected(used, words);
  return error.what();
}

}  // namespace beespace::cli
