// Pages read as docs/page-format.md has them, by nothing of what writes them.
#pragma once

#include <simdjson.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::report_test {

using Json = simdjson::dom::element;

// A JSON text, parsed; a request for a missing member throws.
class ParsedJson {
 public:
  explicit ParsedJson(std::string_view text) : root_(parser_.parse(text.data(), text.size())) {}
  ParsedJson(const ParsedJson&) = delete;
  ParsedJson& operator=(const ParsedJson&) = delete;

  [[nodiscard]] Json operator[](std::string_view key) const { return root_[key]; }
  [[nodiscard]] Json root() const { return root_; }

 private:
  simdjson::dom::parser parser_;  // holds what the root and its parts point to
  Json root_;
};

bool has(Json object, std::string_view key);
std::string text_of(Json text);
std::vector<std::string> texts_of(Json array);

struct Column {
  std::string type;
  std::string code;
  std::optional<double> scale;
  std::optional<double> offset;
  std::vector<std::uint64_t> numbers;  // of f64: their bits
  std::vector<std::string> texts;

  // What is meant.
  [[nodiscard]] std::vector<double> values() const;
};

// `json` is what stands in a column's place. Throws where they do not fit each other.
Column column_of(Json json, const std::vector<std::string>& elements);

// The same as what is meant, or as texts.
std::vector<double> values_of(Json json, const std::vector<std::string>& elements);
std::vector<std::uint64_t> numbers_of(Json json, const std::vector<std::string>& elements);

struct PageParts {
  std::string before;
  std::string json;
  std::vector<std::string> elements;  // in the order of their numbers, from 0
  std::string end;                    // a checksum, and how many elements there are
  std::string after;
};

// Throws where a page is not made of these.
PageParts parts_of(std::string_view page);

}  // namespace beespace::report_test
