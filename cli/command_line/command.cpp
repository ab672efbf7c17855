#include "cli/command_line/command.hpp"

#include "cli/command_line/similar_word.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::cli {
namespace {

// Those in lower case of "SECONDS|never".
std::vector<std::string> words_of(std::string_view value) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= value.size();) {
    const std::size_t end = std::min(value.find('|', at), value.size());
    const std::string_view word = value.substr(at, end - at);
    const bool lower = !word.empty() && std::all_of(word.begin(), word.end(),
                                                    [](char c) { return c >= 'a' && c <= 'z'; });
    if (lower) words.emplace_back(word);
    at = end + 1;
  }
  return words;
}

}  // namespace

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) (text += text.empty() ? "" : between) += word;
  return text;
}

Command::Command(std::string name, std::string summary, std::string details, Run run)
    : name_(std::move(name)),
      summary_(std::move(summary)),
      details_(std::move(details)),
      run_(std::move(run)) {
}

Option& Command::add_value(std::string_view names, std::string_view value, std::string_view help,
                           Store store) {
  std::vector<std::string> words = words_of(value);
  Option& option = options_.emplace_back(Option{.names = std::string(names),
                                                .value = std::string(value),
                                                .help = std::string(help),
                                                .group = group_,
                                                .store = std::move(store),
                                                .words = std::move(words)});
  if (option.is_argument()) option.group.clear();
  option.files = value == "FILE" || names.starts_with("FILE");
  return option;
}

Option& Command::argument(std::string_view name, std::string& into, std::string_view help) {
  return option(name, "", into, help);
}

Option& Command::arguments(std::string_view name, std::vector<std::string>& into,
                           std::string_view help) {
  Option& added = add_value(name, "", help, [&into](const Typed& typed) -> Status {
    into.push_back(typed.text);
    return std::monostate{};
  });
  added.takes = Option::Takes::kAny;
  return added;
}

Option& Command::option(std::string_view names, std::string_view value, std::string& into,
                        std::string_view help) {
  return add_value(names, value, help, [&into](const Typed& typed) -> Status {
    into = typed.text;
    return std::monostate{};
  });
}

Option& Command::choice(std::string_view names, std::string& into, std::vector<std::string> words,
                        std::string_view help, std::string_view value) {
  return add_choice(names, value, help, std::move(words), [&into](const Typed& typed) -> Status {
    into = typed.text;
    return std::monostate{};
  });
}

Option& Command::add_choice(std::string_view names, std::string_view value, std::string_view help,
                            std::vector<std::string> words, Store store) {
  const std::string shown = value.empty() ? joined(words, "|") : std::string(value);
  Option& added = add_value(names, shown, help, std::move(store));
  allow_only(added, std::move(words));
  return added;
}

Option& Command::flag(std::string_view names, bool& into, std::string_view help) {
  Option& added = add_value(names, "", help, [&into](const Typed&) -> Status {
    into = true;
    return std::monostate{};
  });
  added.takes = Option::Takes::kNone;
  return added;
}

Result<ExitCode> Command::run() const {
  for (const Option& option : options_) {
    if (!option.given) continue;
    const std::string name = option.name();
    // What a flag stores needs no text.
    const std::vector<std::string> flag = {""};
    for (const std::string& text : option.takes == Option::Takes::kNone ? flag : option.typed) {
      if (Status stored = option.store({name_, name, text}); !stored) return stored.error();
    }
  }
  return run_(*this);
}

bool Command::is_given(std::string_view name) const {
  return std::any_of(options_.begin(), options_.end(), [name](const Option& option) {
    return option.given && option.name() == name;
  });
}

std::string Command::typed(std::string_view name) const {
  for (const Option& option : options_) {
    if (option.given && option.name() == name && !option.typed.empty()) return option.typed.front();
  }
  return {};
}

void allow_only(Option& option, std::vector<std::string> words,
                std::function<bool(const std::string&)> otherwise, std::string hint) {
  option.words = words;
  option.problem = [words = std::move(words), otherwise = std::move(otherwise),
                    hint = std::move(hint)](const std::string& given) -> std::string {
    if (std::find(words.begin(), words.end(), given) != words.end()) return {};
    if (otherwise && otherwise(given)) return {};
    const auto meant = most_similar(given, words);
    return "'" + given + "' is none of " + joined(words, ", ") + hint +
           (meant ? "; did you mean '" + *meant + "'?" : std::string());
  };
}

}  // namespace beespace::cli
