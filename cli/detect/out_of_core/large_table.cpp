#include "cli/detect/out_of_core/large_table.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace beespace::cli {
namespace {

// Fields between tabs, or records as they stand with fields behind them.
class LargeFieldTable final : public LargeTable {
 public:
  LargeFieldTable(const LargeTableParts& parts, bool csv)
      : out_(parts.out),
        ids_(parts.ids),
        file_(parts.file),
        records_(parts.records),
        table_(parts.out.text, csv ? parts.file.delimiter : '\t'),
        csv_(csv) {}

  void begin_bees(const std::vector<LargeColumn>& columns) override {
    // Without an id column the row is the id, which the record itself does not say.
    with_rows_ = csv_ && !file_.own_ids &&
                 std::any_of(columns.begin(), columns.end(),
                             [](const LargeColumn& column) { return column.names_bees; });
    // A plain list of ids needs no header.
    const std::string_view header = csv_ ? record_header() : columns.empty() ? "" : "id";
    if (header.empty()) return;
    table_.next() += header;
    if (with_rows_) table_.field("row");
    for (const LargeColumn& column : columns) table_.field(column.name);
    table_.end_row();
  }

  void bee(LargeId id, std::span<const LargeCell> cells) override {
    if (csv_) {
      table_.next() += records_->text(id);
    } else {
      write_id(id);
    }
    if (with_rows_) table_.field(ids_.row(id));
    for (const LargeCell& cell : cells) write(cell);
    table_.end_row();
    out_.pass_on();
  }

  void begin_pairs(const ApartFields& fields) override {
    fields_ = fields;
    table_.header(pair_header(fields)).end_row();
  }

  void pair(const LargePair& pair, double distance_m, const analysis::Apart& apart) override {
    write_id(pair.first);
    write_id(pair.second);
    table_.field(distance_m);
    write_apart(table_, apart, fields_);
    table_.end_row();
    out_.pass_on();
  }

 private:
  [[nodiscard]] std::string_view record_header() const {
    if (file_.is_table) return file_.header;
    return file_.facts.frame == io::Frame::kWgs84 ? "longitude,latitude,height" : "x,y,z";
  }

  void write_id(LargeId id) {
    if (csv_) {
      table_.field(ids_.text(id));
    } else {
      ids_.append(table_.next(), id);
    }
  }

  void write(const LargeCell& cell) {
    if (const auto* number = std::get_if<std::uint64_t>(&cell)) {
      table_.field(*number);
    } else if (const auto* far = std::get_if<DistanceCell>(&cell)) {
      table_.field(far->distance_m);
    } else if (const auto* other = std::get_if<LargeBeeCell>(&cell)) {
      if (other->id) {
        write_id(*other->id);
      } else {
        table_.empty_field();
      }
    } else {
      write_ids(std::get<std::span<const LargeId>>(cell));
    }
  }

  // Each a field of its own, or all one.
  void write_ids(std::span<const LargeId> bees) {
    const char between = table_.delimiter() == ';' ? ',' : ';';
    std::string listed;
    for (const LargeId one : bees) {
      if (!csv_) {
        write_id(one);
        continue;
      }
      if (!listed.empty()) listed += between;
      ids_.append(listed, one);
    }
    if (csv_) table_.field(listed);
  }

  BlockWriter& out_;
  const LargeIds& ids_;
  const LargeFile& file_;
  TextStore* records_;
  io::TableWriter table_;
  ApartFields fields_;
  bool csv_;
  bool with_rows_ = false;
};

class LargeJsonTable final : public LargeTable {
 public:
  explicit LargeJsonTable(const LargeTableParts& parts)
      : out_(parts.out), ids_(parts.ids), json_(parts.json) {}

  void begin_bees(const std::vector<LargeColumn>& columns) override {
    columns_ = columns;
    json_.begin_array(columns.empty() ? io::JsonLayout::kLine : io::JsonLayout::kRows);
    if (!columns.empty()) json_.new_line();
  }

  void bee(LargeId id, std::span<const LargeCell> cells) override {
    if (columns_.empty()) {
      ids_.write(json_, id);
    } else {
      json_.begin_object();
      ids_.write(json_.key("id"), id);
      for (std::size_t at = 0; at < cells.size(); ++at) {
        json_.key(columns_[at].name);
        write(cells[at]);
      }
      json_.end();
    }
    out_.pass_on();
  }

  void begin_pairs(const ApartFields& fields) override {
    fields_ = fields;
    json_.begin_array(io::JsonLayout::kRows);
  }

  void pair(const LargePair& pair, double distance_m, const analysis::Apart& apart) override {
    json_.begin_object();
    write_pair(json_, ids_, pair, distance_m);
    write_apart(json_, apart, fields_);
    json_.end();
    out_.pass_on();
  }

  void end() override { json_.end(); }

 private:
  void write(const LargeCell& cell) {
    if (const auto* number = std::get_if<std::uint64_t>(&cell)) {
      json_.value(*number);
    } else if (const auto* far = std::get_if<DistanceCell>(&cell)) {
      json_.value(far->distance_m);
    } else if (const auto* other = std::get_if<LargeBeeCell>(&cell)) {
      if (!other->id) return json_.null();
      ids_.write(json_, *other->id);
    } else {
      json_.begin_array();
      for (const LargeId one : std::get<std::span<const LargeId>>(cell)) ids_.write(json_, one);
      json_.end();
    }
  }

  BlockWriter& out_;
  const LargeIds& ids_;
  io::JsonWriter& json_;
  std::vector<LargeColumn> columns_;
  ApartFields fields_;
};

}  // namespace

std::unique_ptr<LargeTable> LargeTable::make(Form form, const LargeTableParts& parts) {
  if (form == Form::kJson) return std::make_unique<LargeJsonTable>(parts);
  return std::make_unique<LargeFieldTable>(parts, form == Form::kCsv);
}

void write_pair(io::JsonWriter& json, const LargeIds& ids, const LargePair& pair,
                double distance_m) {
  ids.write(json.key("first"), pair.first);
  ids.write(json.key("second"), pair.second);
  json.member("distance_m", distance_m);
}

}  // namespace beespace::cli
