#include "io/shows/show_limits.hpp"

#include "io/bytes/number_text.hpp"
#include "io/json/json_document.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// "max_velocity_xy" and "maxVelocityXY" are one limit: "maxvelocityxy".
std::string plain_name(std::string_view written) {
  std::string plain;
  for (const char letter : written) {
    if (letter == '_') continue;
    plain.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(letter))));
  }
  return plain;
}

class LimitReader {
 public:
  LimitReader(ShowDocuments& documents, const ShowValue& validation)
      : documents_(documents), validation_(validation) {
    JsonMap members;
    if (validation.element.get(members)) {
      for (const auto& [key, value] : members) {
        const std::string plain = plain_name(key);
        const bool limits_something = plain.starts_with("max") || plain.starts_with("min");
        if (!limits_something || value.is_null()) continue;
        names_.push_back({std::string(key), plain});
      }
    }
  }

  // The limit of that plain name, above zero; nothing where it is not declared.
  Result<std::optional<double>> take(std::string_view plain, ErrorCode if_not_above) {
    std::optional<double> taken;
    std::string written;
    for (Name& name : names_) {
      if (name.plain != plain) continue;
      name.taken = true;
      const auto value = read(name.written, if_not_above);
      if (!value) return value.error();
      if (taken && *value && **value != *taken) {
        return Error{ErrorCode::kMalformedRecord,
                     "settings.validation." + written + " is " + exact(*taken) + ", and " +
                         name.written + " " + exact(**value) +
                         "; remove the one that does not hold",
                     {documents_.place_of(validation_)}};
      }
      if (*value) taken = *value;
      written = name.written;
    }
    return taken;
  }

  struct Name {
    std::string written;
    std::string plain;
    bool taken = false;
  };
  [[nodiscard]] const std::vector<Name>& names() const { return names_; }

 private:
  Result<std::optional<double>> read(const std::string& written, ErrorCode if_not_above) {
    const auto found = documents_.member(validation_, written);
    if (!found) return found.error();
    if (!*found) return std::optional<double>();
    const std::string path = "settings.validation." + written;
    const std::string place = documents_.place_of(**found);
    double value = 0.0;
    if (!read_json((*found)->element, value)) {
      Error error = json_number_problem((*found)->element, path);
      error.location.source = place;
      return error;
    }
    // A distance of zero promises none: what is too close is then asked for.
    const bool none = value == 0.0 && if_not_above == ErrorCode::kInvalidThreshold;
    if (value > 0.0 || none) return std::optional(std::abs(value));
    return Error{
        if_not_above, path + " is not above zero; correct it, or remove it from the show", {place}};
  }

  ShowDocuments& documents_;
  const ShowValue& validation_;
  std::vector<Name> names_;
};

using Direction = ShowAcceleration::Direction;

// Where upwards has a limit of its own, it is not known which way that in height is meant.
Direction direction_of(std::string_view plain, bool upwards_apart) {
  if (plain == "maxacceleration") return Direction::kAll;
  if (plain == "maxaccelerationxy") return Direction::kHorizontal;
  if (plain == "maxaccelerationz" && !upwards_apart) return Direction::kVertical;
  return Direction::kNotKnown;
}

// Zero limits nothing.
std::optional<double> height_above_zero(const ShowValue& validation, const std::string& name,
                                        bool& is_number) {
  double value = 0.0;
  const auto found = json_member(validation.element, name);
  is_number = found && read_json(*found, value);
  if (!is_number || !(value > 0.0)) return std::nullopt;
  return value;
}

// Accelerations, and what is no limit that is known here: its name is kept, so that it can be said.
std::optional<Error> read_other_limits(LimitReader& reader, const ShowValue& validation,
                                       ShowLimits& limits) {
  const std::vector<LimitReader::Name> names = reader.names();
  const bool upwards_apart = std::any_of(names.begin(), names.end(), [](const auto& name) {
    return name.plain == "maxaccelerationzup";
  });
  for (std::size_t i = 0; i < names.size(); ++i) {
    const LimitReader::Name& name = names[i];
    // In both ways of writing they are one, which take() has compared.
    const bool again = std::any_of(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i),
                                   [&](const auto& other) { return other.plain == name.plain; });
    if (name.taken) continue;
    if (name.plain.starts_with("maxacceleration")) {
      if (again) continue;
      const auto most = reader.take(name.plain, ErrorCode::kMalformedRecord);
      if (!most) return most.error();
      const Direction direction = direction_of(name.plain, upwards_apart);
      if (*most) limits.accelerations.push_back({name.written, **most, direction});
      continue;
    }
    bool is_number = false;
    const auto height_m = name.plain == "minnavaltitude"
                              ? height_above_zero(validation, name.written, is_number)
                              : std::nullopt;
    if (height_m) limits.navigation_m.emplace_back(name.written, *height_m);
    if (!is_number) limits.not_looked_at.push_back(name.written);
  }
  return std::nullopt;
}

std::optional<Error> read_limits(LimitReader& reader, const ShowValue& validation,
                                 DeclaredShowLimits& read) {
  ShowLimits& limits = read.limits;
  const struct {
    std::string_view plain;
    std::optional<double>& limit;
    ErrorCode if_not_above = ErrorCode::kMalformedRecord;
  } table[] = {{"mindistance", read.least_distance_m, ErrorCode::kInvalidThreshold},
               {"maxvelocityxy", limits.horizontal_mps},
               {"maxvelocityz", limits.descent_mps},
               {"maxvelocityzup", limits.climb_mps},
               {"maxaltitude", limits.height_m}};
  for (const auto& [plain, taken, if_not_above] : table) {
    auto value = reader.take(plain, if_not_above);
    if (!value) return value.error();
    taken = *value;
  }
  if (!limits.climb_mps) limits.climb_mps = limits.descent_mps;
  return read_other_limits(reader, validation, limits);
}

}  // namespace

Result<DeclaredShowLimits> read_show_limits(ShowDocuments& documents) {
  DeclaredShowLimits read;
  std::optional<ShowValue> validation = documents.root();
  for (const std::string_view key : {"settings", "validation"}) {
    auto member = documents.member(*validation, key);
    if (!member) return member.error();
    validation = std::move(member).value();
    if (!validation) return read;
  }
  LimitReader reader(documents, *validation);
  if (auto error = read_limits(reader, *validation, read)) return *std::move(error);
  return read;
}

}  // namespace beespace::io
