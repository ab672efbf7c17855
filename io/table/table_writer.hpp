// Writes a delimited table into a text, field after field: delimiters and quotes are its own.
//
// It only appends, so the owner of the text may pass on what is there and clear it between rows.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

// What becomes of texts that would otherwise be read as something else.
enum class TableText : std::uint8_t {
  kQuoted,   // in quotes (RFC 4180, for any delimiter)
  kOneLine,  // tabs and line ends become blanks: for people, and for tools that know no quotes
};

// In quotes where it would otherwise be read as something else; an empty text also between blanks,
// where nothing would be left of it.
void append_field(std::string& out, std::string_view text, char delimiter);

class TableWriter {
 public:
  TableWriter(std::string& out, char delimiter, TableText text = TableText::kQuoted)
      : out_(out), delimiter_(delimiter), text_(text) {}
  ~TableWriter() = default;
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;

  // Names of columns, with commas between.
  TableWriter& header(std::string_view names);

  TableWriter& field(std::string_view text);
  TableWriter& field(const char* text) { return field(std::string_view(text)); }
  TableWriter& field(double number);  // empty where it is not finite
  TableWriter& field(std::same_as<bool> auto yes) { return field(yes ? "yes" : "no"); }
  template <std::unsigned_integral Number>
  requires(!std::same_as<Number, bool>) TableWriter& field(Number number) { return count(number); }
  TableWriter& empty_field() { return field(std::string_view()); }
  // Begins a field, or several, that the caller appends as they are to be.
  std::string& next();

  void end_row() {
    out_ += '\n';
    begins_row_ = true;
  }

  [[nodiscard]] char delimiter() const { return delimiter_; }

 private:
  TableWriter& count(std::uint64_t number);

  std::string& out_;
  char delimiter_;
  TableText text_;
  bool begins_row_ = true;
};

}  // namespace beespace::io
