#include "io/json/json_writer.hpp"

#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"

#include <cassert>
#include <cmath>
#include <exception>

namespace beespace::io {
namespace {

constexpr std::uint8_t kIndent = 2;

bool breaks_lines(JsonLayout layout) {
  return layout == JsonLayout::kRows || layout == JsonLayout::kLines ||
         layout == JsonLayout::kFlush;
}

// Of what stands within, where a line begins there.
std::uint8_t indent_within(JsonLayout layout, std::uint8_t around) {
  if (layout == JsonLayout::kFlush) return 0;
  const bool on_one_line = layout == JsonLayout::kTight || layout == JsonLayout::kLine;
  return on_one_line ? around : static_cast<std::uint8_t>(around + kIndent);
}

}  // namespace

JsonWriter::~JsonWriter() {
  assert((depth_ == 0 && !has_key_) || std::uncaught_exceptions() > 0);
}

JsonWriter& JsonWriter::begin(JsonLayout layout, bool is_object) {
  begin_value();
  assert(depth_ + 1 < kMostNested);
  const std::uint8_t indent = indent_within(layout, level().indent);
  levels_[++depth_] = {layout, is_object, true, indent};
  out_ += is_object ? '{' : '[';
  return *this;
}

JsonWriter& JsonWriter::end() {
  assert(depth_ > 0 && !has_key_);
  const Level& ended = level();
  if (starts_line_) break_line(ended.indent);
  if (ended.layout == JsonLayout::kFlush) break_line(0);
  if (ended.layout == JsonLayout::kLines && !ended.empty) break_line(ended.indent - kIndent);
  out_ += ended.is_object ? '}' : ']';
  --depth_;
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  assert(level().is_object && !has_key_);
  separate();
  append_json_string(out_, name);
  out_ += level().layout == JsonLayout::kTight ? ":" : ": ";
  has_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::value(double number) {
  if (!std::isfinite(number)) return write("null");
  begin_value();
  append_exact(out_, number);
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  begin_value();
  append_json_string(out_, text);
  return *this;
}

JsonWriter& JsonWriter::write(std::string_view word) {
  begin_value();
  out_ += word;
  return *this;
}

JsonWriter& JsonWriter::write_count(std::uint64_t number) {
  begin_value();
  append_exact(out_, number);
  return *this;
}

JsonWriter& JsonWriter::write_signed(std::int64_t number) {
  if (number >= 0) return write_count(static_cast<std::uint64_t>(number));
  begin_value();
  out_ += '-';
  // Of the least number there is no positive one of its type.
  append_exact(out_, std::uint64_t{0} - static_cast<std::uint64_t>(number));
  return *this;
}

void JsonWriter::begin_value() {
  assert(level().is_object == has_key_);
  if (!has_key_ && depth_ > 0) separate();
  has_key_ = false;
}

void JsonWriter::separate() {
  Level& around = levels_[depth_];
  const bool breaks = starts_line_ || breaks_lines(around.layout);
  if (!around.empty) out_ += breaks || around.layout == JsonLayout::kTight ? "," : ", ";
  if (breaks) break_line(around.indent);
  around.empty = false;
}

void JsonWriter::break_line(std::size_t indent) {
  out_ += '\n';
  out_.append(indent, ' ');
  starts_line_ = false;
}

}  // namespace beespace::io
