// Times that clocks show twice, as they are set back at night: which one is meant is told by the
// records of the same bee, where they go on in their order and begin again once.
#pragma once

#include <beespace/result.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

class DoubledHours {
 public:
  // A record of that bee at that time, which clocks show once. An error is that of an earlier one
  // which may have been either.
  std::optional<Error> take(std::string_view id, double time_s);
  // One whose time is this, or `by_s` later: which of them. `unclear` is what is wrong where
  // nothing tells.
  Result<double> take_doubled(std::string_view id, double time_s, double by_s, Error unclear);
  // Once all is read.
  [[nodiscard]] std::optional<Error> unclear() const;

 private:
  struct Bee {
    std::optional<double> last_s = {};
    double step_s = 0.0;                // by which the last one came after the one before
    std::optional<Error> pending = {};  // taken for the first time, unless it does not come again
    bool again = false;                 // the hour has begun again
  };

  Bee& bee_of(std::string_view id);

  std::map<std::string, Bee, std::less<>> bees_;
};

}  // namespace beespace::io
