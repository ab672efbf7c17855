// The records of a JSON document as those of a text table, which all that reads tables understands.
#pragma once

#include "io/json/json_document.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace beespace::io {

// Cells are written row by row, each row a line: first all names are learnt, then rows are filled.
class JsonCells {
 public:
  static constexpr char kBetween = '\x1F';
  static constexpr std::size_t kMostNames = 4096;

  // Errors: kColumnCount beyond kMostNames.
  std::optional<Error> learn(std::string_view name);
  std::optional<Error> learn(JsonMap record);

  // A record by its keys. What is no object, or has a key twice, is written so that it is no
  // record: who reads the table says so.
  void add(JsonElement record);
  // One by its cells, each of the name in that place.
  void begin_row() { row_.assign(names_.size(), {}); }
  void set(std::size_t place, JsonElement value);
  void end_row();
  // A line without a record.
  void skip_line() { text_ += '\n'; }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  // What each column holds, as far as it was filled.
  [[nodiscard]] std::vector<ColumnContent> contents() const;
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::string cell_of(JsonElement value);

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> places_;
  std::vector<std::string> row_;
  std::vector<bool> filled_;
  std::vector<ColumnContent> contents_;
  std::string text_;
};

}  // namespace beespace::io
