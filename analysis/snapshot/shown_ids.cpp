#include "analysis/snapshot/shown_ids.hpp"

#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace beespace::analysis {

namespace {

constexpr std::string_view kTabsAndLineEnds = "\t\n\v\f\r";

}  // namespace

bool is_empty_id(std::string_view id) {
  return id.find_first_not_of(" \t\n\v\f\r") == std::string_view::npos;
}

bool is_broken_id(std::string_view id) {
  return id.find_first_of(kTabsAndLineEnds) != std::string_view::npos;
}

void append_id(std::string& out, std::string_view id) {
  const std::size_t begin = out.size();
  out += id;
  std::replace_if(
      out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
      [](char c) { return kTabsAndLineEnds.find(c) != std::string_view::npos; }, ' ');
}

ShownIds::ShownIds(const io::LoadedPoints& loaded, const std::vector<PointId>& ascending)
    : own_ids_(io::has_id_column(loaded)),
      rows_are_points_(!own_ids_ && loaded.skipped_count == 0),
      points_(&ascending) {
  if (rows_are_points_) return;
  begin_.reserve(ascending.size() + 1);
  io::for_each_record(loaded, ascending, [this](const io::Record& record) {
    begin_.push_back(texts_.size());
    if (own_ids_ && !is_empty_id(record.id)) {
      texts_ += record.id;
      if (is_broken_id(record.id)) ++broken_count_;
      return;
    }
    io::append_exact(texts_, record.row);
    if (own_ids_) empty_.push_back(record.point);
  });
  begin_.push_back(texts_.size());
}

std::string_view ShownIds::find(PointId point) const {
  const auto place = std::lower_bound(points_->begin(), points_->end(), point);
  const auto i = static_cast<std::size_t>(place - points_->begin());
  return std::string_view(texts_).substr(begin_[i], begin_[i + 1] - begin_[i]);
}

void ShownIds::append(std::string& out, PointId point) const {
  if (rows_are_points_) {
    io::append_exact(out, std::uint64_t{point});
    return;
  }
  if (broken_count_ > 0) return append_id(out, find(point));
  out += find(point);
}

std::string ShownIds::text(PointId point) const {
  std::string out;
  append(out, point);
  return out;
}

void ShownIds::write(io::JsonWriter& json, PointId point) const {
  if (rows_are_points_) {
    json.value(point);
  } else if (own_ids_ && !std::binary_search(empty_.begin(), empty_.end(), point)) {
    json.value(find(point));
  } else {
    json.value(io::parse_whole(find(point)));
  }
}

}  // namespace beespace::analysis
