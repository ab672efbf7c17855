#include "io/tracks/json_cells.hpp"

#include "io/bytes/number_text.hpp"

namespace beespace::io {
namespace {

// In one line, and between quotes where it holds one.
std::string text_cell(std::string_view text) {
  std::string cell(text);
  for (char& c : cell) {
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  }
  if (cell.find('"') == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

std::string JsonCells::cell_of(JsonElement value) {
  std::string_view text;
  if (value.is_null()) return {};
  if (value.get(text)) return text_cell(text);
  if (bool yes = false; value.get(yes)) return yes ? "true" : "false";
  // A count keeps all its digits.
  if (std::uint64_t count = 0; value.get(count)) return std::to_string(count);
  if (double number = 0.0; value.get(number)) return exact(number);
  return std::string(json_kind(value));
}

std::optional<Error> JsonCells::learn(std::string_view name) {
  const auto [known, is_new] = places_.emplace(std::string(name), names_.size());
  if (!is_new) return std::nullopt;
  names_.emplace_back(name);
  if (names_.size() <= kMostNames) return std::nullopt;
  return Error{ErrorCode::kColumnCount,
               "the records have more than " + grouped(std::uint64_t{kMostNames}) +
                   " different keys; write the table with its columns as keys",
               {}};
}

std::optional<Error> JsonCells::learn(JsonMap record) {
  std::size_t expected = 0;
  for (const auto [key, value] : record) {
    if (expected < names_.size() && names_[expected] == key) {
      ++expected;
      continue;
    }
    if (auto error = learn(key)) return error;
    expected = places_.find(std::string(key))->second + 1;
  }
  return std::nullopt;
}

void JsonCells::set(std::size_t place, JsonElement value) {
  row_[place] = cell_of(value);
  if (value.is_null()) return;
  contents_.resize(names_.size(), ColumnContent::kUnknown);
  if (contents_[place] == ColumnContent::kNumber) return;
  contents_[place] = value.is_number() ? ColumnContent::kNumber : ColumnContent::kText;
}

std::vector<ColumnContent> JsonCells::contents() const {
  std::vector<ColumnContent> contents = contents_;
  contents.resize(names_.size(), ColumnContent::kUnknown);
  return contents;
}

void JsonCells::add(JsonElement record) {
  JsonMap object;
  if (!record.get(object)) {
    text_.append(json_kind(record)).append(" where an object should be\n");
    return;
  }
  begin_row();
  filled_.assign(names_.size(), false);
  std::size_t expected = 0;
  for (const auto [key, value] : object) {
    std::size_t place = expected;
    if (place >= names_.size() || names_[place] != key) {
      place = places_.find(std::string(key))->second;
    }
    if (filled_[place]) {
      text_.append("the key ").append(text_cell(key)).append(" twice\n");
      return;
    }
    filled_[place] = true;
    expected = place + 1;
    set(place, value);
  }
  end_row();
}

void JsonCells::end_row() {
  for (std::size_t i = 0; i < row_.size(); ++i) {
    if (i > 0) text_ += kBetween;
    text_ += row_[i];
  }
  text_ += '\n';
}

}  // namespace beespace::io
