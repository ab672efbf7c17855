#include "cli/detect/answer_ids.hpp"

#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::cli {
namespace {

// A set of points, of which those are taken out in their order that were put in.
class Mentioned {
 public:
  explicit Mentioned(std::size_t points) : is_in_(points, 0) {}

  void add(PointId point) {
    if (point != Nearest::kNone) is_in_[point] = 1;
  }

  void add(const Cell& cell) {
    if (const auto* one = std::get_if<BeeCell>(&cell)) add(one->id);
    if (const auto* several = std::get_if<std::span<const PointId>>(&cell)) {
      for (const PointId point : *several) add(point);
    }
  }

  [[nodiscard]] std::vector<PointId> ascending() const {
    std::vector<PointId> points;
    for (std::size_t i = 0; i < is_in_.size(); ++i) {
      if (is_in_[i] != 0) points.push_back(static_cast<PointId>(i));
    }
    return points;
  }

 private:
  std::vector<char> is_in_;
};

bool names_bees(const BeeTable& table) {
  return std::any_of(table.columns.begin(), table.columns.end(),
                     [](const Column& column) { return column.names_bees; });
}

// Among ourselves, a bee that a value names is at risk, or all are listed: none is missing.
std::vector<PointId> our_points(const Inputs& inputs, const Table& table, Form form) {
  const bool ids_stand_in_records = form == Form::kCsv;
  if (const auto* bees = std::get_if<BeeTable>(&table.rows)) {
    const bool needed = !ids_stand_in_records || (names_bees(*bees) && !inputs.others);
    return needed ? bees->bees : std::vector<PointId>();
  }
  if (const auto* groups = std::get_if<GroupTable>(&table.rows)) {
    return ids_stand_in_records ? std::vector<PointId>() : groups->members.bees;
  }
  Mentioned mentioned(inputs.ours.points.size());
  for (const Pair& pair : std::get<PairTable>(table.rows).pairs) {
    mentioned.add(pair.first);
    if (!inputs.others) mentioned.add(pair.second);
  }
  return mentioned.ascending();
}

std::vector<PointId> their_points(const Inputs& inputs, const Table& table) {
  if (!inputs.others) return {};
  Mentioned mentioned(inputs.others->points.size());
  if (const auto* pairs = std::get_if<PairTable>(&table.rows)) {
    for (const Pair& pair : pairs->pairs) mentioned.add(pair.second);
  }
  if (const auto* bees = std::get_if<BeeTable>(&table.rows)) {
    for (const Column& column : bees->columns) {
      if (!column.names_bees) continue;
      for (const PointId bee : bees->bees) mentioned.add(column.cell(bee));
    }
  }
  return mentioned.ascending();
}

}  // namespace

AnswerIds::AnswerIds(const Inputs& inputs, const Table& table, Form form)
    : our_points_(our_points(inputs, table, form)),
      their_points_(their_points(inputs, table)),
      ours_(inputs.ours, our_points_) {
  if (inputs.others) theirs_.emplace(*inputs.others, their_points_);
}

void note_ids(const OddIds& ids, std::string_view which, Form form,
              std::vector<std::string>& notes) {
  if (ids.empty > 0) {
    notes.push_back(io::grouped(ids.empty) + (ids.empty == 1 ? " bee" : " bees") +
                    std::string(which) + (ids.empty == 1 ? " has" : " have") +
                    " an empty id: the data row stands for it");
  }
  const bool is_text = form == Form::kText || form == Form::kCsv;
  if (ids.broken > 0 && is_text) {
    notes.push_back("tabs and line ends inside an id are written as blanks (" +
                    io::counted(ids.broken, "id", "ids") + ")");
  }
}

}  // namespace beespace::cli
