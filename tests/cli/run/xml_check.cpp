#include "tests/cli/run/xml_check.hpp"

#include "io/bytes/characters.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace beespace::cli_test {
namespace {

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ':' ||
         c == '-' || c == '_' || c == '.';
}

class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  bool document() {
    if (take("<?xml ") && !take_until("?>")) return false;
    blanks();
    if (rest_.empty() || rest_.front() != '<') return false;
    do {
      if (!(rest_.front() == '<' ? tag() : character(true))) return false;
    } while (!open_.empty() && !rest_.empty());
    blanks();
    return open_.empty() && rest_.empty();
  }

 private:
  bool take(std::string_view expected) {
    if (!rest_.starts_with(expected)) return false;
    rest_.remove_prefix(expected.size());
    return true;
  }
  bool take_until(std::string_view end) {
    const std::size_t at = rest_.find(end);
    if (at == std::string_view::npos) return false;
    rest_.remove_prefix(at + end.size());
    return true;
  }
  bool blanks() {
    const std::size_t count = std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size());
    rest_.remove_prefix(count);
    return count > 0;
  }
  std::string name() {
    std::string found;
    while (!rest_.empty() && is_name_character(rest_.front())) {
      found += rest_.front();
      rest_.remove_prefix(1);
    }
    return found;
  }

  bool tag() {
    if (take("</")) {
      const std::string closed = name();
      if (open_.empty() || open_.back() != closed || !take(">")) return false;
      open_.pop_back();
      return true;
    }
    take("<");
    const std::string opened = name();
    if (opened.empty()) return false;
    std::vector<std::string> attributes;
    while (blanks() && !rest_.starts_with('>') && !rest_.starts_with("/>")) {
      const std::string attribute = name();
      for (const std::string& other : attributes) {
        if (other == attribute) return false;
      }
      attributes.push_back(attribute);
      if (attribute.empty() || !take("=\"") || !value()) return false;
    }
    if (take("/>")) return true;
    open_.push_back(opened);
    return take(">");
  }

  bool value() {
    while (!rest_.empty() && rest_.front() != '"') {
      if (rest_.front() == '<' || !character(false)) return false;
    }
    return take("\"");
  }

  bool character(bool in_text) {
    if (rest_.front() == '&') {
      for (const char* known :
           {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;", "&#9;", "&#10;", "&#13;"}) {
        if (take(known)) return true;
      }
      return false;
    }
    if (in_text && rest_.starts_with("]]>")) return false;
    const std::size_t length = io::utf8_length(rest_);
    const auto first = static_cast<unsigned char>(rest_.front());
    const bool control = first < 0x20 && first != '\t' && first != '\n' && first != '\r';
    if (length == 0 || control || rest_.starts_with("\xEF\xBF\xBE") ||
        rest_.starts_with("\xEF\xBF\xBF")) {
      return false;
    }
    rest_.remove_prefix(length);
    return true;
  }

  std::string_view rest_;
  std::vector<std::string> open_;
};

}  // namespace

bool is_xml(std::string_view text) {
  return Reader(text).document();
}

}  // namespace beespace::cli_test
