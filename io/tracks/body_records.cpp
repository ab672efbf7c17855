#include "io/tracks/body_records.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/table/table_layout.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

// As it is written, with the other sign.
std::string negated(std::string_view number) {
  if (number.empty() || number.find_first_of("123456789") == std::string_view::npos) {
    return std::string(number);
  }
  if (number.front() == '-') return std::string(number.substr(1));
  return "-" + std::string(number.substr(number.front() == '+' ? 1 : 0));
}

// Of a picture, counted from the one that is at 0 s.
std::string seconds_of(std::string_view picture, double pictures_per_second) {
  double number = 0.0;
  if (parse_number(picture, number) != NumberKind::kNumber) return std::string(picture);
  return exact(number / pictures_per_second);
}

bool was_seen(const BodyColumns& body, const std::vector<std::string_view>& fields) {
  double residual = 0.0;
  return !body.residual || parse_number(fields[*body.residual], residual) != NumberKind::kNumber ||
         residual >= 0.0;
}

}  // namespace

bool has_unclear_names(const std::vector<BodyColumns>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [&bodies](const BodyColumns& body) {
    return body.name.empty() ||
           std::count_if(bodies.begin(), bodies.end(),
                         [&body](const BodyColumns& other) { return other.name == body.name; }) > 1;
  });
}

LongRecords body_records(std::string_view rows, const BodyTable& table) {
  LongRecords records;
  records.names = {"time_s", "id", "x_" + table.unit, "y_" + table.unit, "z_" + table.unit};
  records.unit_reason = "exports of " + std::string(table.program) + " have them so";
  records.lines_before = table.lines_before;
  records.per_line = table.bodies.size();
  std::string& out = records.text;
  std::vector<std::string_view> fields;
  std::uint64_t lines = 0;
  RecordWalk walk(rows, 0, '\n');
  while (walk.next()) {
    out.append((walk.line() - lines) * table.bodies.size(), '\n');
    lines = walk.line() + 1;
    fields.clear();
    FieldCursor cursor(walk.record(), table.delimiter);
    for (Field field; cursor.next(field);) fields.push_back(without_padding(field.text));
    const bool whole = fields.size() == table.columns && cursor.problem().empty();
    for (const BodyColumns& body : table.bodies) {
      if (!whole) {
        out.append("a row of ").append(std::to_string(fields.size())).append(" values\n");
        continue;
      }
      const std::string_view time = table.by_line ? std::string_view() : fields[table.time];
      if (table.by_line) {
        const auto picture = static_cast<double>(walk.line());
        out.append(exact(picture / *table.pictures_per_second)) += kUnitSeparator;
      } else if (table.pictures_per_second) {
        out.append(seconds_of(time, *table.pictures_per_second)) += kUnitSeparator;
      } else {
        out.append(time) += kUnitSeparator;
      }
      out.append(body.name) += kUnitSeparator;
      const bool seen = was_seen(body, fields);
      const auto axis = [&](std::size_t of) {
        return seen ? fields[body.axes[of]] : std::string_view();
      };
      out.append(axis(0)) += kUnitSeparator;
      if (table.y_is_up) {
        out.append(negated(axis(2))) += kUnitSeparator;
        out.append(axis(1)) += '\n';
      } else {
        out.append(axis(1)) += kUnitSeparator;
        out.append(axis(2)) += '\n';
      }
    }
  }
  return records;
}

std::optional<Error> own_beginning(const BodyTable& table, const RecordingAssembly& assembly) {
  const RecordingOptions& options = assembly.options();
  if (!assembly.has_several() || options.one_clock) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "times of " + std::string(table.program) +
                   " count from the beginning of each recording, so that it shares no clock with "
                   "other inputs; read it alone, or say --one-clock if all begin at one moment, as "
                   "where each body of a recording was written to a file of its own",
               {}};
}

}  // namespace beespace::io
