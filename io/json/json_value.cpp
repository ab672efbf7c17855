#include "io/json/json_value.hpp"

#include <simdjson.h>

#include <bit>
#include <new>

namespace beespace::io {
namespace {

namespace dom = simdjson::dom;

// What simdjson calls an element, an array, an object or a place within them is a document and an
// index each.
template <typename Part>
Part at(const JsonPlace& place) {
  static_assert(sizeof(Part) == sizeof(JsonPlace));
  return std::bit_cast<Part>(place);
}

template <typename Part>
JsonPlace place_of(const Part& part) {
  return std::bit_cast<JsonPlace>(part);
}

template <typename Value>
bool get_scalar(const JsonPlace& place, Value& value) {
  Value found = {};
  if (at<dom::element>(place).get(found) != simdjson::SUCCESS) return false;
  value = found;
  return true;
}

std::string_view problem_of(simdjson::error_code code) {
  if (code == simdjson::MEMALLOC) throw std::bad_alloc();
  return code == simdjson::SUCCESS ? std::string_view() : simdjson::error_message(code);
}

}  // namespace

static_assert(JsonParser::kPadding >= simdjson::SIMDJSON_PADDING);

JsonKind JsonElement::kind() const {
  switch (at<dom::element>(place_).type()) {
    case dom::element_type::ARRAY:
      return JsonKind::kArray;
    case dom::element_type::OBJECT:
      return JsonKind::kObject;
    case dom::element_type::STRING:
      return JsonKind::kText;
    case dom::element_type::BOOL:
      return JsonKind::kFlag;
    case dom::element_type::NULL_VALUE:
      return JsonKind::kNull;
    default:
      return JsonKind::kNumber;
  }
}

bool JsonElement::get(double& value) const {
  return get_scalar(place_, value);
}
bool JsonElement::get(std::int64_t& value) const {
  return get_scalar(place_, value);
}
bool JsonElement::get(std::uint64_t& value) const {
  return get_scalar(place_, value);
}
bool JsonElement::get(bool& value) const {
  return get_scalar(place_, value);
}
bool JsonElement::get(std::string_view& value) const {
  return get_scalar(place_, value);
}

bool JsonElement::get(JsonArray& value) const {
  dom::array found;
  if (!get_scalar(place_, found)) return false;
  value = JsonArray(place_of(found));
  return true;
}

bool JsonElement::get(JsonMap& value) const {
  dom::object found;
  if (!get_scalar(place_, found)) return false;
  value = JsonMap(place_of(found));
  return true;
}

bool JsonElement::follow(std::string_view pointer, JsonElement& value) const {
  dom::element found;
  if (at<dom::element>(place_).at_pointer(pointer).get(found) != simdjson::SUCCESS) return false;
  value = JsonElement(place_of(found));
  return true;
}

JsonArray::Iterator JsonArray::begin() const {
  return Iterator(place_of(at<dom::array>(place_).begin()));
}
JsonArray::Iterator JsonArray::end() const {
  return Iterator(place_of(at<dom::array>(place_).end()));
}
std::size_t JsonArray::size() const {
  return at<dom::array>(place_).size();
}

JsonArray::Iterator& JsonArray::Iterator::operator++() {
  auto here = at<dom::array::iterator>(place_);
  place_ = place_of(++here);
  return *this;
}

JsonMap::Iterator JsonMap::begin() const {
  return Iterator(place_of(at<dom::object>(place_).begin()));
}
JsonMap::Iterator JsonMap::end() const {
  return Iterator(place_of(at<dom::object>(place_).end()));
}
std::size_t JsonMap::size() const {
  return at<dom::object>(place_).size();
}

bool JsonMap::get(std::string_view key, JsonElement& value) const {
  dom::element found;
  if (at<dom::object>(place_).at_key(key).get(found) != simdjson::SUCCESS) return false;
  value = JsonElement(place_of(found));
  return true;
}

JsonMap::Member JsonMap::Iterator::operator*() const {
  const auto here = at<dom::object::iterator>(place_);
  return {here.key(), JsonElement(place_of(here.value()))};
}

JsonMap::Iterator& JsonMap::Iterator::operator++() {
  auto here = at<dom::object::iterator>(place_);
  place_ = place_of(++here);
  return *this;
}

struct JsonParser::State {
  dom::parser parser;
};

JsonParser::JsonParser() : state_(std::make_unique<State>()) {
}
JsonParser::JsonParser(JsonParser&&) noexcept = default;
JsonParser& JsonParser::operator=(JsonParser&&) noexcept = default;
JsonParser::~JsonParser() = default;

std::string_view JsonParser::parse(std::string_view text, JsonElement& root) {
  dom::element found;
  const auto code = state_->parser.parse(text.data(), text.size(), true).get(found);
  root = JsonElement(place_of(found));
  return problem_of(code);
}

std::string_view JsonParser::parse_padded(std::string_view text, JsonElement& root) {
  dom::element found;
  const auto code = state_->parser.parse(text.data(), text.size(), false).get(found);
  root = JsonElement(place_of(found));
  return problem_of(code);
}

}  // namespace beespace::io
