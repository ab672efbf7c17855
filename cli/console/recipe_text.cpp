#include "cli/console/recipe_text.hpp"

#include "io/problems/your_threshold.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace beespace::cli {
namespace {

constexpr std::string_view kFile = "FILE";

bool is_of_a_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Whether a shell takes it for one word that means itself.
bool is_plain(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return is_of_a_word(c) || std::string_view("-./:,+@%").find(c) != std::string_view::npos;
  });
}

std::string as_one_word(std::string_view text) {
  std::string word(text);
  if (is_plain(text)) return word;
  word.insert(word.begin(), '\'');
  word.push_back('\'');
  return word;
}

bool can_be_quoted(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](unsigned char c) {
    return c == '\'' || c == '"' || c == '\\' || c == '`' || c == '$' || std::iscntrl(c) != 0;
  });
}

std::string with_file(std::string_view message, const std::string& file) {
  std::string text;
  std::size_t taken = 0;
  for (std::size_t at = message.find(kFile); at != std::string_view::npos;
       at = message.find(kFile, at + 1)) {
    const std::size_t end = at + kFile.size();
    const char before = at > 0 ? message[at - 1] : ' ';
    const char behind = end < message.size() ? message[end] : ' ';
    if (is_of_a_word(before) || is_of_a_word(behind)) continue;
    text += message.substr(taken, at - taken);
    taken = end;
    // Within quotes, of a folder that is named, or by itself.
    if (before == '\'' || before == '"') {
      text += file;
    } else if (before == '/') {
      text += as_one_word(std::filesystem::path(file).filename().string());
    } else {
      text += as_one_word(file);
    }
  }
  return text.append(message.substr(taken));
}

}  // namespace

std::string typed_name(const std::string& file) {
  if (is_plain(file) || !can_be_quoted(file)) return file;
  return '"' + file + '"';
}

std::string with_what_was_typed(std::string message, const std::string& file,
                                const TypedSeparation& typed) {
  std::error_code none;
  if (can_be_quoted(file) && std::filesystem::exists(file, none)) {
    message = with_file(message, file);
  }
  std::string said;
  const auto add = [&said](std::string_view option, std::string_view value) {
    if (value.empty() || !can_be_quoted(value)) return false;
    said.append(said.empty() ? "" : " ").append(option).append(" ").append(as_one_word(value));
    return true;
  };
  if (!add("--threshold", typed.threshold)) add("--separation", typed.separation);
  if (!said.empty()) add("--vertical", typed.vertical);
  const std::string_view yours = io::kYourThreshold;
  const std::size_t at = message.find(yours);
  if (said.empty() || at == std::string::npos) return message;
  said.append(message, at + yours.size());
  message.resize(at);
  return message.append(said);
}

}  // namespace beespace::cli
