// The members of a JSON object that may have no others: what is missing, of another kind, there
// twice or not known is an error that names its place, as in "obstacles[2].radius_m".
//
// The first thing that is wrong is kept: ask for all members, and then for the error.
#pragma once

#include "io/json/json_document.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

class JsonMembers {
 public:
  // `what` is in sentences about them: "a sphere". Errors: kMalformedRecord for what is no object
  // or has two members of a name, kUnsupportedFormat for members that are not among `known`.
  JsonMembers(JsonElement object, std::string path, std::string what,
              const std::vector<std::string_view>& known);

  // Members that must be there; null is as good as nothing. Zero or nothing where there is an
  // error. Errors: kMissingColumn, and those of json_number_problem() and json_point_problem().
  double number(std::string_view key);
  Point point(std::string_view key);
  std::optional<JsonElement> element(std::string_view key);
  // One that need not be there.
  double number_or(std::string_view key, double otherwise);

  [[nodiscard]] std::string path_of(std::string_view key) const;
  void fail(Error error);
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  void check_names(const std::vector<std::string_view>& known);

  JsonElement object_;
  std::string path_;
  std::string what_;
  std::optional<Error> error_;
};

}  // namespace beespace::io
