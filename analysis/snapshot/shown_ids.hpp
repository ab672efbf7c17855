// The ids that people know: the file's own id column, or the 0-based data row, which also stands
// for an id that is empty.
//
// Made for some points at once, because the records lie in the file in their order. `loaded`
// must outlive it. Memory: none where the row is the point's number; the text of the ids otherwise.
#pragma once

#include "io/json/json_writer.hpp"
#include "io/points/loaded_points.hpp"

#include <beespace/point.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::analysis {

class ShownIds {
 public:
  ShownIds(const io::LoadedPoints& loaded, const std::vector<PointId>& ascending);

  // The id of one of the points given, for people and lines of text: tabs and line ends, which
  // would end it there, become blanks.
  void append(std::string& out, PointId point) const;
  [[nodiscard]] std::string text(PointId point) const;

  // The same for JSON: a number when it is a row, a string when it is the file's own.
  void write(io::JsonWriter& json, PointId point) const;

  // Whether each id is the point's own number, which is quicker written directly.
  [[nodiscard]] bool are_point_numbers() const { return rows_are_points_; }

  // How many have an empty id, and how many one with tabs or line ends in it.
  [[nodiscard]] std::size_t empty_count() const { return empty_.size(); }
  [[nodiscard]] std::size_t broken_count() const { return broken_count_; }

 private:
  [[nodiscard]] std::string_view find(PointId point) const;

  bool own_ids_ = false;          // the file has an id column
  bool rows_are_points_ = false;  // nothing was skipped: no table is needed
  const std::vector<PointId>* points_;
  std::string texts_;               // all ids, one after the other
  std::vector<PointId> empty_;      // whose own id is empty, ascending
  std::size_t broken_count_ = 0;    // whose own id holds tabs or line ends
  std::vector<std::size_t> begin_;  // of each in texts_, and the end of the last
};

// Whether the data row stands for it.
bool is_empty_id(std::string_view id);
// Whether there are tabs or line ends in it.
bool is_broken_id(std::string_view id);
// For people and lines of text: these become blanks.
void append_id(std::string& out, std::string_view id);

}  // namespace beespace::analysis
