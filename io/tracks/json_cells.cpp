#include "io/tracks/json_cells.hpp"

#include "io/bytes/number_text.hpp"
#include "io/table/table_layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::io {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < ' ';
}

// What a cell does not keep of the value, so that others have the same; empty where it keeps all.
std::string_view lost_in_cell(JsonElement value) {
  constexpr double kFirstInexact = 9007199254740992.0;
  std::int64_t whole = 0;
  std::uint64_t count = 0;
  double number = 0.0;
  switch (value.kind()) {
    case JsonKind::kArray:
    case JsonKind::kObject:
      return json_kind(value);
    case JsonKind::kNumber:
      if (value.get(whole) || value.get(count) || !value.get(number)) return {};
      return std::abs(number) < kFirstInexact ? std::string_view() : "a rounded number";
    default:
      return {};
  }
}

// In one line, and between quotes where it holds one.
std::string text_cell(std::string_view text) {
  std::string cell(text);
  for (char& c : cell) {
    if (is_control(c)) c = '?';
  }
  if (cell.find('"') == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

std::string JsonCells::cell_of(JsonElement value) {
  if (bool yes = false; value.get(yes)) return yes ? "true" : "false";
  // A whole number keeps all its digits.
  if (std::uint64_t count = 0; value.get(count)) return std::to_string(count);
  if (std::int64_t whole = 0; value.get(whole)) return std::to_string(whole);
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
  if (!looked_for_lists_) listed_ = listed_places(record);
  looked_for_lists_ = true;
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

std::optional<Error> JsonCells::learn_id() {
  id_place_ = names_.size();
  return learn("id");
}

void JsonCells::set(std::size_t place, JsonElement value) {
  if (std::string_view text; value.get(text)) return set(place, text);
  if (value.is_null()) {
    row_[place].clear();
    return;
  }
  has_objects_ = has_objects_ || value.is_object();
  if (const auto what = lost_in_cell(value); !what.empty()) shortened(place, what);
  fill(place, cell_of(value), value.is_number());
}

void JsonCells::set(std::size_t place, std::string_view text) {
  if (std::any_of(text.begin(), text.end(), is_control)) {
    shortened(place, "a control character");
  }
  fill(place, text_cell(text), false);
}

void JsonCells::fill(std::size_t place, std::string cell, bool number) {
  row_[place] = std::move(cell);
  contents_.resize(names_.size(), ColumnContent::kUnknown);
  if (contents_[place] == ColumnContent::kNumber) return;
  contents_[place] = number ? ColumnContent::kNumber : ColumnContent::kText;
}

void JsonCells::shortened(std::size_t place, std::string_view what) {
  shortened_.push_back({place, text_.size(), what});
}

void JsonCells::require_ids(std::size_t place) {
  std::string text;
  std::size_t kept = 0;
  for (const Shortened& cell : shortened_) {
    if (cell.place != place) continue;
    text.append(text_, kept, cell.row - kept).append(cell.what).append(" as the id");
    kept = text_.find('\n', cell.row);
  }
  if (kept == 0) return;
  text_ = text.append(text_, kept);
}

std::vector<ColumnContent> JsonCells::contents() const {
  std::vector<ColumnContent> contents = contents_;
  contents.resize(names_.size(), ColumnContent::kUnknown);
  return contents;
}

void JsonCells::add(JsonElement record, std::string_view id) {
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
  if (id_place_) set(*id_place_, id);
  end_row();
}

void JsonCells::end_row() {
  for (std::size_t i = 0; i < row_.size(); ++i) {
    if (i > 0) text_ += kUnitSeparator;
    text_ += row_[i];
  }
  text_ += '\n';
}

}  // namespace beespace::io
