#include "cli/command_line/completions.hpp"

#include <cstddef>
#include <functional>
#include <initializer_list>

namespace beespace::cli {
namespace {

using Commands = std::vector<Command>;

constexpr const char* kGenerated =
    "# Written by scripts/write-completions from what --help says.\n";

std::string cat(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

std::string replaced(std::string text, std::string_view old, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size()) {
    text.replace(at, old.size(), by);
  }
  return text;
}

std::string names_of(const Commands& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const Command& command : commands) names.push_back(command.name());
  return joined(names, " ");
}

// The short name, as "-o"; empty where there is none.
std::string short_name(const Option& option) {
  const std::size_t comma = option.names.find(',');
  return comma == std::string::npos ? std::string() : option.names.substr(0, comma);
}

// "-o | --output": the patterns of those options of the command that are so.
std::string patterns(const Command& command, const std::function<bool(const Option&)>& is_so) {
  std::vector<std::string> names;
  for (const Option& option : command.options()) {
    if (option.is_argument() || !is_so(option)) continue;
    if (const std::string letter = short_name(option); !letter.empty()) names.push_back(letter);
    names.push_back(option.name());
  }
  return joined(names, " | ");
}

// One subcommand: what may follow an option, and the options and arguments themselves.
std::string bash_case(const Command& command) {
  std::string text = "    " + command.name() + ")\n      case $previous in\n";
  std::vector<std::string> options;
  std::string argument;
  for (const Option& option : command.options()) {
    if (option.is_argument()) {
      if (!option.words.empty()) argument += " values='" + joined(option.words, " ") + "'";
      if (option.files) argument += " files=yes";
      continue;
    }
    options.push_back(option.name());
    if (option.words.empty()) continue;
    text += "        " + option.name() + ") values='" + joined(option.words, " ") + "' ;;\n";
  }
  options.insert(options.end(), {"--help", "--version"});
  const std::string files = patterns(command, [](const Option& option) { return option.files; });
  if (!files.empty()) text += "        " + files + ") files=yes ;;\n";
  const std::string others = patterns(command, [](const Option& option) {
    return option.takes != Option::Takes::kNone && option.words.empty() && !option.files;
  });
  if (!others.empty()) text += "        " + others + ") return ;;\n";
  return text + "        *) options='" + joined(options, " ") + "'" + argument +
         " ;;\n      esac\n      ;;\n";
}

std::string bash_completions(const Commands& commands) {
  std::string text = std::string(
                         "# shellcheck shell=bash\n# Completion of the beespace command for "
                         "bash.\n") +
                     kGenerated + R"(
# Offers what compgen finds for the arguments.
_beespace_offer() {
  local found
  found=$(compgen "$@") || true
  COMPREPLY=()
  [ -z "$found" ] || mapfile -t COMPREPLY <<< "$found"
}

_beespace() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local subcommand=${COMP_WORDS[1]:-} options='' values='' files=''
  COMPREPLY=()

  # bash splits --crs=wgs84 at the "=" into three words.
  if [ "$current" = = ]; then
    current=''
  elif [ "$previous" = = ] && [ "$COMP_CWORD" -ge 2 ]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi

  if [ "$COMP_CWORD" -eq 1 ]; then
    _beespace_offer -W ')" +
                     names_of(commands) + R"( help --help --version' -- "$current"
    return
  fi

  case $subcommand in
)";
  for (const Command& command : commands) text += bash_case(command);
  return text + "    help) values='" + names_of(commands) + R"(' ;;
  esac

  case $current in
    -*) [ -z "$options" ] || values=$options files='' ;;
  esac
  [ -n "$values$files" ] || values=$options
  # Words before files, where both may stand.
  if [ -z "$files" ] || { [ -n "$values" ] && compgen -W "$values" -- "$current" > /dev/null; }; then
    _beespace_offer -W "$values" -- "$current"
  else
    compopt -o filenames
    _beespace_offer -f -- "$current"
  fi
}
complete -F _beespace beespace
)";
}

// Help in one line, without what quotes and brackets mean to a shell.
std::string one_line(const std::string& help) {
  return replaced(help, "\n", " ");
}

std::string in_zsh(const std::string& help) {
  std::string text = replaced(one_line(help), "'", "'\\''");
  text = replaced(text, "[", "\\[");
  return replaced(replaced(text, "]", "\\]"), ":", "\\:");
}

// Behind the explanation: what the value is called, and how it is completed.
std::string zsh_value(const Option& option) {
  const std::string words = joined(option.words, " ");
  std::string action = option.files ? "_files" : "";
  if (!words.empty()) {
    action = option.files ? cat({"{ compadd ", words, "; _files }"}) : cat({"(", words, ")"});
  }
  return cat({":", option.value.empty() ? option.names : option.value, ":", action});
}

std::string zsh_line(const Option& option) {
  const bool flag = option.takes == Option::Takes::kNone;
  const std::string value = flag ? std::string() : zsh_value(option);
  if (option.is_argument()) {
    return cat({option.takes == Option::Takes::kAny ? "'*" : "'1", value, "'"});
  }
  const std::string name = option.name();
  const std::string letter = short_name(option);
  const std::string names = letter.empty()
                                ? cat({"'", name})
                                : cat({"'(", letter, " ", name, ")'{", letter, ",", name, "}'"});
  return cat({names, "[", in_zsh(option.help), "]", value, "'"});
}

std::string zsh_completions(const Commands& commands) {
  const std::string help = " \\\n        '(- *)'{-h,--help}'[Print this help and exit]'";
  std::string text =
      std::string("#compdef beespace\n# Completion of the beespace command for zsh.\n") +
      kGenerated + R"(
_beespace() {
  local context state state_descr line
  typeset -A opt_args

  _arguments -C \
    '(- *)'{-h,--help}'[Print this help and exit]' \
    '(- *)--version[Print the version and exit]' \
    '1:subcommand:(()";
  for (const Command& command : commands) {
    text += command.name() + "\\:\"" + in_zsh(command.summary()) + "\" ";
  }
  text += R"(help\:"Print this help, or that of a subcommand"))' \
    '*::option:->rest'

  [[ $state == rest ]] || return
  case $words[1] in
)";
  for (const Command& command : commands) {
    text += "    " + command.name() + ")\n      _arguments";
    for (const Option& option : command.options()) text += " \\\n        " + zsh_line(option);
    text += help + " \\\n        '(- *)--version[Print the version and exit]'\n      ;;\n";
  }
  return text + "    help)\n      _arguments" + help + " \\\n        '1:subcommand:(" +
         names_of(commands) + ")'\n      ;;\n  esac\n}\n\n_beespace \"$@\"\n";
}

std::string in_fish(const std::string& help) {
  return cat({"'", replaced(replaced(one_line(help), "\\", "\\\\"), "'", "\\'"), "'"});
}

std::string fish_line(const std::string& name, const Option& option) {
  std::string text = "complete -c beespace -n '__fish_seen_subcommand_from " + name + "'";
  const bool flag = option.takes == Option::Takes::kNone;
  if (option.is_argument()) {
    if (option.words.empty()) return {};  // files are offered anyway
    return text + " -F -a '" + joined(option.words, " ") + "'\n";
  }
  text += flag ? " -f" : (option.files ? " -r" : " -x");
  if (const std::string letter = short_name(option); !letter.empty())
    text += " -s " + letter.substr(1);
  text += " -l " + option.name().substr(2);
  if (!option.words.empty()) text += " -a '" + joined(option.words, " ") + "'";
  return text + " -d " + in_fish(option.help) + "\n";
}

std::string fish_completions(const Commands& commands) {
  std::string text = std::string("# Completion of the beespace command for fish.\n") + kGenerated;
  const std::string first = "complete -c beespace -n __fish_use_subcommand -f -a ";
  for (const Command& command : commands) {
    text += first + command.name() + " -d " + in_fish(command.summary()) + "\n";
  }
  text += first + "help -d 'Print this help, or that of a subcommand'\n";
  text += "complete -c beespace -f -l version -d 'Print the version and exit'\n";
  text += "complete -c beespace -f -s h -l help -d 'Print this help and exit'\n";
  for (const Command& command : commands) {
    text += "\n";
    for (const Option& option : command.options()) text += fish_line(command.name(), option);
  }
  return text + "\ncomplete -c beespace -n '__fish_seen_subcommand_from help' -f -a '" +
         names_of(commands) + "'\n";
}

// "detect --crs", a tab, and how the manual's entry begins: .BI \-\-crs " auto" | wgs84 | metres.
std::string manual_heads(const Commands& commands) {
  std::string text;
  for (const Command& command : commands) {
    for (const Option& option : command.options()) {
      if (option.is_argument()) continue;
      const std::string name = option.name();
      const std::string shown = replaced(name, "-", "\\-");
      const std::string letter = replaced(short_name(option), "-", "\\-");
      const std::string value = replaced(replaced(option.value, "-", "\\-"), "|", " | ");
      const std::size_t end = value.find(' ');
      text += cat({command.name(), " ", name, "\t"});
      if (option.takes == Option::Takes::kNone) {
        text += cat({".B ", shown, "\n"});
      } else if (!letter.empty()) {
        text += cat({".BR ", letter, " \", \" ", shown, " \" \\fI", value, "\\fR\"\n"});
      } else {
        const std::string rest = end == std::string::npos ? "" : value.substr(end);
        text += cat({".BI ", shown, " \" ", value.substr(0, end), "\"", rest, "\n"});
      }
    }
  }
  return text;
}

}  // namespace

std::optional<std::string> completions_for(std::string_view shell, const Commands& commands) {
  if (shell == "bash") return bash_completions(commands);
  if (shell == "zsh") return zsh_completions(commands);
  if (shell == "fish") return fish_completions(commands);
  if (shell == "man") return manual_heads(commands);
  return std::nullopt;
}

}  // namespace beespace::cli
