// Days without a time of day among dates with times: R (4.3 and later) writes midnight so, one time
// after the other. A day alone may as well mean a day of which the time is not known. It is
// midnight where no other one is written out, and the bee is heard of as long before or after it as
// it is between its other records.
#pragma once

#include "io/recording/track_gathering.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

class BareMidnights {
 public:
  struct Doubt {
    Origin origin;
    std::string why;  // as a phrase
  };

  void take(std::string_view id, double time_s, Origin origin) {
    taken_.push_back({std::string(id), time_s, origin});
  }
  // A midnight with its time of day.
  void take_written() { written_ = true; }
  [[nodiscard]] std::size_t count() const { return taken_.size(); }

  // Once all are in the order of time: the first that may be no midnight; nothing where none is.
  [[nodiscard]] std::optional<Doubt> doubt(const TrackGathering& tracks) const;

 private:
  struct Taken {
    std::string id;
    double time_s;
    Origin origin;
  };

  std::vector<Taken> taken_;
  bool written_ = false;
};

}  // namespace beespace::io
