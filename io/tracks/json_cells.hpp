// The records of a JSON document as those of a text table, which all that reads tables understands.
#pragma once

#include "io/json/json_document.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/listed_places.hpp"

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
  static constexpr std::size_t kMostNames = 4096;

  // Errors: kColumnCount beyond kMostNames.
  std::optional<Error> learn(std::string_view name);
  std::optional<Error> learn(JsonMap record);
  // After all names: rows have an id beside their cells, in a column "id" behind all others.
  std::optional<Error> learn_id();

  // A record by its keys. What is no object, or has a key twice, is written so that it is no
  // record: who reads the table says so. `id` where learn_id() said that rows have one.
  void add(JsonElement record, std::string_view id = {});
  // One by its cells, each of the name in that place.
  void begin_row() { row_.assign(names_.size(), {}); }
  void set(std::size_t place, JsonElement value);
  void set(std::size_t place, std::string_view text);
  void end_row();
  // A line without a record.
  void skip_line() { text_ += '\n'; }
  // Once all rows are there: those whose value in that place is no id, as others would be written
  // like it, become no records either.
  void require_ids(std::size_t place);

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  // What each column holds, as far as it was filled.
  [[nodiscard]] std::vector<ColumnContent> contents() const;
  [[nodiscard]] const std::string& text() const { return text_; }
  // Whether a value is an object within its record, of which a cell keeps nothing.
  [[nodiscard]] bool has_objects() const { return has_objects_; }
  // Of the first record: what makes records of a list that it holds.
  [[nodiscard]] const std::optional<ListedPlaces>& listed() const { return listed_; }
  // The place of learn_id().
  [[nodiscard]] std::optional<std::size_t> id_place() const { return id_place_; }

 private:
  // A cell that says less than the value did.
  struct Shortened {
    std::size_t place;
    std::size_t row;  // where its text begins
    std::string_view what;
  };

  static std::string cell_of(JsonElement value);
  void fill(std::size_t place, std::string cell, bool number);
  void shortened(std::size_t place, std::string_view what);

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> places_;
  std::vector<std::string> row_;
  std::vector<bool> filled_;
  std::vector<ColumnContent> contents_;
  std::vector<Shortened> shortened_;  // in the order of the rows
  std::optional<std::size_t> id_place_;
  bool has_objects_ = false;
  bool looked_for_lists_ = false;
  std::optional<ListedPlaces> listed_;
  std::string text_;
};

}  // namespace beespace::io
