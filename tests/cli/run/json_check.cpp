#include "tests/cli/run/json_check.hpp"

#include <cctype>
#include <cstddef>
#include <regex>
#include <string>

namespace beespace::cli_test {
namespace {

// Recursive descent; every function consumes its part from the front, or returns false.
class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  bool document() {
    const bool good = value();
    blanks();
    return good && rest_.empty();
  }

 private:
  void blanks() {
    while (!rest_.empty() && std::string_view(" \t\r\n").find(rest_[0]) != std::string_view::npos) {
      rest_.remove_prefix(1);
    }
  }

  bool take(std::string_view token) {
    blanks();
    if (rest_.substr(0, token.size()) != token) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  bool value() {
    if (take("{")) return members("}", true);
    if (take("[")) return members("]", false);
    blanks();
    if (!rest_.empty() && rest_[0] == '"') return string();
    return take("true") || take("false") || take("null") || number();
  }

  bool members(std::string_view end, bool keyed) {
    if (take(end)) return true;
    do {
      if (keyed && !(string() && take(":"))) return false;
      if (!value()) return false;
    } while (take(","));
    return take(end);
  }

  bool string() {
    if (!take("\"")) return false;
    while (!rest_.empty() && rest_[0] != '"') {
      if (static_cast<unsigned char>(rest_[0]) < 0x20) return false;
      if (rest_[0] == '\\' && !escape()) return false;
      if (!rest_.empty()) rest_.remove_prefix(1);
    }
    return take("\"");
  }

  // Leaves the last character of the escape at the front.
  bool escape() {
    rest_.remove_prefix(1);
    if (rest_.empty()) return false;
    if (rest_[0] != 'u') return std::string_view("\"\\/bfnrt").find(rest_[0]) != std::string::npos;
    if (rest_.size() < 5) return false;
    for (std::size_t i = 1; i < 5; ++i) {
      if (std::isxdigit(static_cast<unsigned char>(rest_[i])) == 0) return false;
    }
    rest_.remove_prefix(4);
    return true;
  }

  bool number() {
    static const std::regex kNumber(R"(^-?(0|[1-9]\d*)(\.\d+)?([eE][-+]?\d+)?)");
    const std::string head(rest_.substr(0, 40));
    std::smatch found;
    if (!std::regex_search(head, found, kNumber)) return false;
    rest_.remove_prefix(static_cast<std::size_t>(found.length()));
    return true;
  }

  std::string_view rest_;
};

}  // namespace

bool is_json(std::string_view text) {
  return Parser(text).document();
}

}  // namespace beespace::cli_test
