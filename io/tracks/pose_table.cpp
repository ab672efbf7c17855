#include "io/tracks/pose_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/problems/unplaced.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/track_columns.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_table.hpp"
#include "io/tracks/video_units.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::array<std::string_view, 3> kCoords = {"x", "y", "z"};

// A place of the body of an animal.
struct BodyPart {
  std::string animal;  // empty where a column, or nothing, tells it
  std::string name;
  std::array<std::optional<std::size_t>, 3> axes = {};  // the columns
  std::optional<std::size_t> likelihood = {};
};

struct PoseLayout {
  std::string_view tool;
  std::size_t offset = 0;  // where the data begin
  std::uint64_t lines_before = 0;
  std::size_t columns = 0;
  std::size_t frame = 0;
  std::optional<std::size_t> id = {};
  std::vector<BodyPart> parts = {};
};

// Takes a column that is a coordinate, or the likelihood, of that place.
void take(PoseLayout& pose, const std::string& animal, const std::string& name,
          std::string_view what, std::size_t column) {
  auto part = std::find_if(pose.parts.begin(), pose.parts.end(), [&](const BodyPart& of) {
    return of.animal == animal && of.name == name;
  });
  if (part == pose.parts.end()) {
    BodyPart added;
    added.animal = animal;
    added.name = name;
    part = pose.parts.insert(pose.parts.end(), std::move(added));
  }
  for (std::size_t axis = 0; axis < kCoords.size(); ++axis) {
    if (what == kCoords[axis]) part->axes[axis] = column;
  }
  if (what == "likelihood" || what == "score") part->likelihood = column;
}

void drop_half_places(PoseLayout& pose) {
  std::erase_if(pose.parts, [](const BodyPart& part) { return !part.axes[0] || !part.axes[1]; });
}

// "scorer,...", perhaps "individuals,...", "bodyparts,...", "coords,...".
std::optional<PoseLayout> deeplabcut_layout(std::string_view text) {
  constexpr std::size_t kMostRows = 4;
  PoseLayout pose;
  pose.tool = "DeepLabCut";
  std::vector<std::vector<std::string>> rows;
  while (rows.size() < kMostRows && pose.offset < text.size()) {
    const Line line = line_at(text, pose.offset, '\n');
    if (line.text.size() > kLongestLine) return std::nullopt;
    rows.push_back(cells_of_line(line.text, ','));
    if (rows.back().empty()) return std::nullopt;
    pose.offset = line.next;
    ++pose.lines_before;
    const std::string first = lower_case(rows.back()[0]);
    const bool individuals = rows.size() == 2 && first == "individuals";
    const std::size_t behind =
        rows.size() - (rows.size() > 2 && lower_case(rows[1][0]) == "individuals");
    const std::string_view wanted = behind == 1 ? "scorer" : behind == 2 ? "bodyparts" : "coords";
    if (!individuals && first != wanted) return std::nullopt;
    if (rows.back().size() != rows.front().size()) return std::nullopt;
    if (first == "coords") break;
  }
  if (rows.size() < 3 || lower_case(rows.back()[0]) != "coords") return std::nullopt;
  const std::vector<std::string>& parts = rows[rows.size() - 2];
  pose.columns = parts.size();
  for (std::size_t i = 1; i < pose.columns; ++i) {
    take(pose, rows.size() == kMostRows ? rows[1][i] : std::string(), parts[i],
         lower_case(rows.back()[i]), i);
  }
  drop_half_places(pose);
  return pose.parts.empty() ? std::nullopt : std::optional(std::move(pose));
}

// "track,frame_idx,instance.score,nose.x,nose.y,nose.score,...".
std::optional<PoseLayout> sleap_layout(std::string_view text) {
  const Line line = line_at(text, 0, '\n');
  if (line.text.size() > kLongestLine) return std::nullopt;
  const std::vector<std::string> names = cells_of_line(line.text, ',');
  PoseLayout pose;
  pose.tool = "SLEAP";
  pose.offset = line.next;
  pose.lines_before = 1;
  pose.columns = names.size();
  bool frames = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t dot = names[i].rfind('.');
    if (names[i] == "track") {
      pose.id = i;
    } else if (names[i] == "frame_idx") {
      pose.frame = i;
      frames = true;
    } else if (dot != std::string::npos && dot > 0 && names[i] != "instance.score") {
      take(pose, {}, names[i].substr(0, dot), names[i].substr(dot + 1), i);
    }
  }
  drop_half_places(pose);
  if (!frames || !pose.id || pose.parts.empty()) return std::nullopt;
  return pose;
}

std::optional<PoseLayout> pose_layout(std::string_view text) {
  auto pose = deeplabcut_layout(text);
  return pose ? pose : sleap_layout(text);
}

std::vector<std::string> names_of(const PoseLayout& pose) {
  std::vector<std::string> names;
  for (const BodyPart& part : pose.parts) {
    if (std::find(names.begin(), names.end(), part.name) == names.end()) names.push_back(part.name);
  }
  return names;
}

// What else pictures do not tell is asked for at once.
std::string what_pictures_lack(const RecordingOptions& options) {
  std::string text;
  if (!options.frames_per_second) text += "how many pictures there are in a second (--fps 25)";
  if (!options.pixel)
    text.append(text.empty() ? "" : " and ").append("how long a pixel is (--scale 0.1mm)");
  return text.empty() ? text : ", and " + text;
}

Error which_part(const PoseLayout& pose, const RecordingOptions& options, std::string_view why) {
  constexpr std::size_t kMostNamed = 20;
  const std::vector<std::string> names = names_of(pose);
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) {
    list.append(i == 0 ? "" : ", ").append(excerpt(names[i]));
  }
  if (names.size() > kMostNamed) list += ", ...";
  return {ErrorCode::kInvalidArgument,
          std::string(why) +
              "say which place of the body is where the animal is, as in --columns " +
              "x=" + names[0] + ".x,y=" + names[0] + ".y (" + std::string(pose.tool) + " has " +
              list + ")" + what_pictures_lack(options),
          {}};
}

// The place of the body that the caller means, or the only one.
Result<std::string> choose_part(const PoseLayout& pose, const RecordingOptions& options) {
  const std::vector<std::string> names = names_of(pose);
  if (options.columns.empty()) {
    if (names.size() == 1) return names.front();
    return which_part(pose, options, {});
  }
  const auto overrides = read_column_overrides(track_columns(), options.columns, options.frame);
  if (!overrides) return overrides.error();
  std::optional<std::string> chosen;
  for (const ColumnOverride& of : *overrides) {
    const auto axis = part_within(Role::kX, of.role);
    const std::string ending = axis ? "." + std::string(kCoords[*axis]) : std::string();
    const bool fits = axis && of.column.size() > 2 && of.column.ends_with(ending);
    const std::string name = fits ? of.column.substr(0, of.column.size() - 2) : std::string();
    const bool known = std::find(names.begin(), names.end(), name) != names.end();
    if (!known || (chosen && *chosen != name)) {
      return which_part(pose, options,
                        "--columns " + excerpt(options.columns) +
                            " names no place of a body that this table has; ");
    }
    chosen = name;
  }
  return *std::move(chosen);
}

// The same as a table with a record for each animal in each row, and how many likelihoods are low.
struct LongTable {
  std::string text = {};
  std::uint64_t unsure = 0;
};

LongTable long_table(std::string_view text, const PoseLayout& pose, std::size_t dimensions,
                     double least_likelihood) {
  LongTable out;
  std::vector<std::string_view> fields;
  std::uint64_t lines = 0;
  RecordWalk walk(text, pose.offset, '\n');
  while (walk.next()) {
    out.text.append((walk.line() - lines) * pose.parts.size(), '\n');
    lines = walk.line() + 1;
    fields.clear();
    FieldCursor cursor(walk.record(), ',');
    for (Field field; cursor.next(field);) fields.push_back(without_padding(field.text));
    const bool whole = fields.size() == pose.columns && cursor.problem().empty();
    for (const BodyPart& part : pose.parts) {
      if (!whole) {
        out.text.append("a row of ").append(std::to_string(fields.size())).append(" values\n");
        continue;
      }
      out.text.append(fields[pose.frame]) += kUnitSeparator;
      const bool named = pose.id || !part.animal.empty();
      if (named) out.text.append(pose.id ? fields[*pose.id] : part.animal) += kUnitSeparator;
      double likelihood = 1.0;
      const bool told = part.likelihood &&
                        parse_number(fields[*part.likelihood], likelihood) == NumberKind::kNumber;
      const bool unsure = told && likelihood < least_likelihood;
      if (unsure) ++out.unsure;
      for (std::size_t axis = 0; axis < dimensions; ++axis) {
        out.text.append(unsure ? std::string_view() : fields[*part.axes[axis]]) += kUnitSeparator;
      }
      out.text.back() = '\n';
    }
  }
  return out;
}

TableLayout layout_of(const PoseLayout& pose, std::size_t dimensions) {
  TableLayout table;
  table.delimiter = kUnitSeparator;
  table.names = {"frame"};
  if (pose.id || !pose.parts.front().animal.empty()) table.names.emplace_back("id");
  for (std::size_t axis = 0; axis < dimensions; ++axis) table.names.emplace_back(kCoords[axis]);
  table.columns = table.names.size();
  table.contents.assign(table.columns, ColumnContent::kNumber);
  table.lines_before = pose.lines_before;
  table.records_per_line = pose.parts.size();
  return table;
}

void say_choice(const PoseLayout& pose, const std::string& part, std::uint64_t unsure,
                RecordingAssembly& assembly) {
  assembly.note("a table of poses, as " + std::string(pose.tool) +
                " writes them: each animal is where its " + excerpt(part) + " is");
  if (unsure == 0) return;
  assembly.note(std::to_string(unsure) + (unsure == 1 ? " place has" : " places have") +
                " a likelihood below " + exact(assembly.options().least_likelihood) + " and " +
                (unsure == 1 ? "is" : "are") + " as if not there (--least-likelihood)");
}

// Animals that have no such place are known nowhere; "single" has the places of none, as corners of
// the cage.
void keep_part(PoseLayout& pose, const std::string& name, RecordingAssembly& assembly) {
  std::vector<std::string> animals;
  for (const BodyPart& part : pose.parts) animals.push_back(part.animal);
  std::erase_if(pose.parts, [&name](const BodyPart& of) { return of.name != name; });
  for (const std::string& animal : animals) {
    if (!animal.empty() && animal != "single") assembly.heard_of(kNeverPlaced, animal);
  }
}

// Where no instance is on a track: those of a video of one animal are all of that. Of several it is
// not known who is who.
std::optional<Error> settle_no_tracks(std::string_view text, PoseLayout& pose) {
  if (!pose.id) return std::nullopt;
  std::unordered_set<std::string_view> frames;
  bool one_each = true;
  RecordWalk walk(text, pose.offset, '\n');
  while (walk.next()) {
    if (!without_padding(field_at(walk.record(), ',', *pose.id).text).empty()) return std::nullopt;
    const std::string_view frame = field_at(walk.record(), ',', pose.frame).text;
    one_each = frames.insert(frame).second && one_each;
  }
  pose.id.reset();
  if (one_each) return std::nullopt;
  return Error{ErrorCode::kMissingColumn,
               "no instance is on a track, and there are several in a frame, so that nothing tells "
               "which is which: track them in SLEAP (Predict, Run Inference, with a tracker), save "
               "the project, and export it again",
               {}};
}

}  // namespace

bool is_pose_table(std::string_view text) {
  return pose_layout(text).has_value();
}

std::optional<Error> read_pose_table(std::string_view text, const std::string& stem,
                                     RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  auto pose = pose_layout(text);
  if (!pose) return Error{ErrorCode::kUnsupportedFormat, "this is no table of poses", {}};
  if (auto error = settle_no_tracks(text, *pose)) return error;
  RecordingOptions options = assembly.options();
  const auto part = choose_part(*pose, options);
  if (!part) return part.error();
  options.columns.clear();
  keep_part(*pose, *part, assembly);
  const bool high = std::all_of(pose->parts.begin(), pose->parts.end(),
                                [](const BodyPart& of) { return of.axes[2].has_value(); });
  const std::size_t dimensions = high ? 3 : 2;
  const LongTable records = long_table(text, *pose, dimensions, options.least_likelihood);
  if (records.text.empty()) {
    return Error{ErrorCode::kNoPoints, "there are rows that name columns and none after them", {}};
  }
  if (options.progress != nullptr) options.progress->total += records.text.size();
  auto layout =
      choose_track_layout(layout_of(*pose, dimensions), records.text, options, SeenRecords::kWhole);
  if (!layout) {
    Error error = std::move(layout).error();
    error.location.column.reset();
    return error;
  }
  if (auto error = lengths_problem(layout->table, options)) return error;
  say_choice(*pose, *part, records.unsure, assembly);
  SourceFacts facts = facts_of(*layout, "text, poses");
  // Their heights, where they have any, are as good as their places.
  facts.of_animals = dimensions == 2;
  if (auto error = assembly.agree(facts)) return error;
  for (std::string& note : layout->notes) assembly.note(std::move(note));
  const bool named = layout->table.choice.id.has_value();
  if (!named) assembly.note("there is no id: each file is taken for one bee, named after it");
  const std::string animal = named ? std::string() : assembly.name_of_source(stem);
  RecordsBefore none;
  return read_track_records(records.text, *layout, animal, RecordPlace::kLineAndName, none,
                            assembly);
}

}  // namespace beespace::io
