// A subcommand, described once: its options, what their values are read into, and what --help says
// of it. The parser, the completions and the manual go by this description.
#pragma once

#include "cli/console/exit_code.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace beespace::cli {

// A value as typed, and for which option of which subcommand.
struct Typed {
  std::string_view command;
  std::string_view option;  // "--threshold"
  const std::string& text;
};

struct Option {
  // How many values it may have.
  enum class Takes : std::uint8_t { kNone, kOne, kAny };

  std::string names;  // "--crs" or "-o,--output"; of an argument "FILE"
  std::string value;  // as help calls it: "SECONDS", "auto|wgs84|metres"; of arguments empty
  std::string help;
  std::string group;  // the heading of its lines in help; of arguments empty
  Takes takes = Takes::kOne;
  bool required = false;
  // What is wrong with a value while the line is parsed; empty: nothing.
  std::function<std::string(const std::string&)> problem = {};
  std::function<Status(const Typed&)> store = {};  // reads a value; of flags: is called once
  std::vector<std::string> words = {};             // that it takes, perhaps beside others
  bool files = false;                              // names of files may be given
  bool given = false;                              // set by the parser, as is this:
  std::vector<std::string> typed = {};

  [[nodiscard]] bool is_argument() const { return !names.starts_with('-'); }
  // "--output" of "-o,--output".
  [[nodiscard]] std::string name() const { return names.substr(names.find(',') + 1); }
};

// A word of the command line, and what it means.
template <class T>
struct Word {
  const char* word;
  T meaning;
};

class Command {
 public:
  using Run = std::function<Result<ExitCode>(const Command&)>;

  // `run` is called once all values are read. What values are read into must live as long.
  Command(std::string name, std::string summary, std::string details, Run run);

  // The options that follow stand under this heading.
  void group(std::string heading) { group_ = std::move(heading); }

  // Values that are taken as they stand: names of files, texts.
  Option& argument(std::string_view name, std::string& into, std::string_view help);
  Option& arguments(std::string_view name, std::vector<std::string>& into, std::string_view help);
  Option& option(std::string_view names, std::string_view value, std::string& into,
                 std::string_view help);

  // A value that `read`, called with a Typed, turns into a Result. In `value` a word in lower case
  // is one that may be typed: "SECONDS|never".
  template <class T, class Read>
  Option& option(std::string_view names, std::string_view value, T& into, Read read,
                 std::string_view help) {
    return add_value(names, value, help, [&into, read = std::move(read)](const Typed& typed) {
      return read(typed).transform(
          [&into](auto&& meant) { into = std::forward<decltype(meant)>(meant); });
    });
  }

  // One of a few words. Help lists them, unless `value` calls them otherwise.
  template <class T>
  Option& choice(std::string_view names, T& into,
                 const std::vector<Word<std::type_identity_t<T>>>& words, std::string_view help,
                 std::string_view value = {}) {
    std::vector<std::string> known;
    known.reserve(words.size());
    for (const auto& word : words) known.emplace_back(word.word);
    return add_choice(names, value, help, std::move(known),
                      [&into, words](const Typed& typed) -> Status {
                        for (const auto& word : words) {
                          if (typed.text == word.word) into = word.meaning;
                        }
                        return std::monostate{};
                      });
  }
  // The word itself.
  Option& choice(std::string_view names, std::string& into, std::vector<std::string> words,
                 std::string_view help, std::string_view value = {});

  Option& flag(std::string_view names, bool& into, std::string_view help);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& summary() const { return summary_; }
  [[nodiscard]] const std::string& details() const { return details_; }
  [[nodiscard]] std::vector<Option>& options() { return options_; }
  [[nodiscard]] const std::vector<Option>& options() const { return options_; }

  // Reads all that was typed, in the order of the options, then runs.
  [[nodiscard]] Result<ExitCode> run() const;

  // Whether the option of this long name stands on the command line.
  [[nodiscard]] bool is_given(std::string_view name) const;
  // Its value as typed; empty where it is not given.
  [[nodiscard]] std::string typed(std::string_view name) const;

 private:
  using Store = std::function<Status(const Typed&)>;
  Option& add_value(std::string_view names, std::string_view value, std::string_view help,
                    Store store);
  Option& add_choice(std::string_view names, std::string_view value, std::string_view help,
                     std::vector<std::string> words, Store store);

  std::string name_;
  std::string summary_;
  std::string details_;
  std::string group_;
  std::vector<Option> options_;
  Run run_;
};

// Refuses what is none of the words, nor what `otherwise` lets pass, and says which may have been
// meant; `hint` tells of the latter: ", and no file (which would have a '.' in its name)".
void allow_only(Option& option, std::vector<std::string> words,
                std::function<bool(const std::string&)> otherwise = {}, std::string hint = {});

// "a, b, c" with ", " between.
std::string joined(const std::vector<std::string>& words, const char* between);

}  // namespace beespace::cli
