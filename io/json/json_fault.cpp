#include "io/json/json_fault.hpp"

#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace beespace::io {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Walks over a JSON text without recursion; stops at what should not be there.
class JsonWalk {
 public:
  explicit JsonWalk(std::string_view text) : text_(text) {}

  // Whether all of it is JSON; at() says where it is not, and expected() what should be there.
  bool whole() {
    skip_blanks();
    while (true) {
      if (!value()) return false;
      if (opened_) {
        opened_ = false;
        continue;
      }
      if (!behind_value()) return false;
      if (open_.empty()) break;
    }
    skip_blanks();
    return at_ == text_.size() || fail("nothing more");
  }

  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] std::string_view expected() const { return expected_; }

 private:
  bool fail(std::string_view expected) {
    expected_ = expected;
    return false;
  }

  [[nodiscard]] bool next_is(char c) const { return at_ < text_.size() && text_[at_] == c; }

  bool take(char c) {
    if (!next_is(c)) return false;
    ++at_;
    return true;
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  bool string() {
    if (!take('"')) return fail("a name in quotes");
    while (at_ < text_.size() && text_[at_] != '"') {
      if (static_cast<unsigned char>(text_[at_]) < 0x20) return fail("a closing quote");
      at_ += text_[at_] == '\\' ? 2u : 1u;
    }
    at_ = std::min(at_, text_.size());
    return take('"') || fail("a closing quote");
  }

  bool digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    return at_ > begin || fail("a digit");
  }

  bool number() {
    take('-');
    if (!take('0') && !digits()) return false;
    if (take('.') && !digits()) return false;
    if (!take('e') && !take('E')) return true;
    if (!take('+')) take('-');
    return digits();
  }

  // "key": before a value of an object.
  bool key() {
    if (!string()) return false;
    skip_blanks();
    if (!take(':')) return fail("a colon");
    skip_blanks();
    return true;
  }

  // A whole scalar, or the opening of an array or object with something in it.
  bool value() {
    if (next_is('[') || next_is('{')) {
      const char close = text_[at_++] == '[' ? ']' : '}';
      skip_blanks();
      if (take(close)) return true;
      open_.push_back(close);
      opened_ = true;
      return close == ']' || key();
    }
    if (next_is('"')) return string();
    for (const std::string_view word : {"true", "false", "null"}) {
      if (text_.substr(at_, word.size()) == word) return at_ += word.size(), true;
    }
    if (next_is('-') || (at_ < text_.size() && is_digit(text_[at_]))) return number();
    return fail("a value");
  }

  // Closes what ends here, and passes the comma before the next value.
  bool behind_value() {
    while (!open_.empty()) {
      skip_blanks();
      if (take(open_.back())) {
        open_.pop_back();
        continue;
      }
      const bool array = open_.back() == ']';
      if (!take(',')) return fail(array ? "a comma or ]" : "a comma or }");
      skip_blanks();
      return array || key();
    }
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string_view expected_ = {};
  std::vector<char> open_;  // the brackets that are yet to come
  bool opened_ = false;     // value() stands before the first value inside
};

}  // namespace

JsonFault find_json_fault(std::string_view text) {
  JsonFault fault;
  JsonWalk walk(text);
  if (walk.whole()) return fault;
  fault.found = true;
  const std::size_t at = std::min(walk.at(), text.size());
  fault.at_end = at == text.size();
  const std::string_view before = text.substr(0, at);
  fault.line = 1 + static_cast<std::uint64_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t newline = before.rfind('\n');
  fault.column = at - (newline == std::string_view::npos ? 0 : newline + 1) + 1;
  fault.what = std::string(walk.expected()) + " is expected";
  if (!fault.at_end) {
    const std::string_view rest = text.substr(at, 12);
    const std::size_t end = rest.find_first_of(" \t\r\n,]}:");
    fault.what +=
        ", not " + excerpt(rest.substr(0, std::max<std::size_t>(1, std::min(end, rest.size()))));
  }
  return fault;
}

}  // namespace beespace::io
