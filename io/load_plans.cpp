#include "io/load_plans.hpp"

#include "io/bytes/byte_source.hpp"
#include "io/bytes/gzip.hpp"
#include "io/plans/plan_layout.hpp"
#include "io/plans/plan_record.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/record_walk.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

namespace beespace::io {
namespace {

// The lines on which ids were met.
using IdLines = std::unordered_map<std::string, std::uint64_t>;

std::optional<Error> known_already(const std::string& id, const PlanLayout& layout,
                                   std::uint64_t line, IdLines& lines) {
  if (!layout.id) return std::nullopt;
  const auto [known, fresh] = lines.emplace(id, line);
  if (fresh) return std::nullopt;
  Error error{ErrorCode::kMalformedRecord,
              "the bee " + excerpt(id) + " is on line " + std::to_string(known->second) +
                  " already; give each an id of its own",
              {}};
  error.location.column = *layout.id + 1;
  return error;
}

void add(PlanRecord& record, const PlanLayout& layout, FlightPlans& plans) {
  plans.ids.push_back(layout.id ? std::move(record.id) : std::to_string(plans.ids.size()));
  plans.positions.push_back(record.position);
  if (layout.has(Role::kVelocityX)) plans.velocities.push_back(record.velocity);
  if (layout.has(Role::kGoalX)) plans.goals.push_back(record.goal);
  if (layout.has(Role::kPreferredX)) plans.preferred.push_back(record.preferred);
  if (layout.has(Role::kMaxSpeed)) plans.max_speeds_mps.push_back(record.max_speed_mps);
  if (layout.has(Role::kMaxAcceleration)) {
    plans.max_accelerations_mps2.push_back(record.max_acceleration_mps2);
  }
}

Result<FlightPlans> read_plans(std::string_view bytes, PlanNeed need) {
  if (auto problem = text_problem(bytes)) return *std::move(problem);
  const std::string_view text = without_byte_order_mark(bytes);
  auto layout = find_plan_layout(text, need);
  if (!layout) return layout.error();
  FlightPlans plans;
  plans.has_ids = layout->id.has_value();
  plans.notes = std::move(layout->notes);
  plans.units = layout->units;
  plans.format_description =
      "text, " + std::string(delimiter_name(layout->table.delimiter)) + "-separated";
  PlanRecordReader reader(*layout);
  PlanRecord record;
  IdLines lines;
  RecordWalk walk(text, layout->table.data_offset, layout->table);
  while (walk.next()) {
    const std::uint64_t line = layout->table.lines_before + walk.line() + 1;
    auto error = reader.read(walk.record(), record);
    if (!error) error = known_already(record.id, *layout, line, lines);
    if (error) {
      error->location.line = line;
      error->location.record = walk.row();
      return *std::move(error);
    }
    add(record, *layout, plans);
  }
  return plans;
}

Result<FlightPlans> load_bytes(Bytes bytes, const std::string& path, PlanNeed need) {
  const std::string source = source_name(path);
  const bool compressed = is_packed(bytes.view);
  const bool zstd = is_zstd(bytes.view);
  auto content = unpacked(std::move(bytes), source);
  if (!content) return content.error();
  auto plans = read_plans(content->view, need);
  if (!plans) {
    plans.error().location.source = source;
  } else if (compressed) {
    plans->format_description += zstd ? ", zstd-compressed" : ", gzip-compressed";
  }
  return plans;
}

}  // namespace

Result<FlightPlans> load_flight_plans(const std::string& path, PlanNeed need) {
  auto bytes = open_bytes(path, nullptr);
  if (!bytes) return bytes.error();
  return load_bytes(std::move(bytes).value(), path, need);
}

Result<FlightPlans> load_flight_plans_from_memory(std::string_view content, const std::string& name,
                                                  PlanNeed need) {
  return load_bytes(copy_of(content), name, need);
}

std::vector<FlightLimits> limits_of(const FlightPlans& plans, const FlightLimits& otherwise) {
  if (plans.max_speeds_mps.empty() && plans.max_accelerations_mps2.empty()) return {};
  std::vector<FlightLimits> limits(plans.positions.size(), otherwise);
  for (std::size_t bee = 0; bee < limits.size(); ++bee) {
    if (!plans.max_speeds_mps.empty()) limits[bee].max_speed_mps = plans.max_speeds_mps[bee];
    if (plans.max_accelerations_mps2.empty()) continue;
    limits[bee].max_acceleration_mps2 = plans.max_accelerations_mps2[bee];
  }
  return limits;
}

}  // namespace beespace::io
