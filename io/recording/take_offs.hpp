// From which height each bee took off, by what its records say beside their heights: how high it is
// above that place, or whether it stands on the ground.
//
// A column may be stuck, or be of something else. So it is believed only where it says the same
// place throughout, within kTakeOffWavers_m, and that the bee has flown; of one that never says so,
// where the place is at the height of those that are believed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace beespace::io {

inline constexpr double kTakeOffWavers_m = 3.0;
// Above the place of take-off by this, a drone flies: the heights of one that stands waver by less.
inline constexpr double kFliesAboveTakeOff_m = 1.5;

// By one record.
struct TakeOffSaid {
  std::optional<double> ground_m = {};  // the height of the place, where the record tells it
  bool flies = false;                   // surely
};

class TakeOffs {
 public:
  void take(std::string_view id, double time_s, const TakeOffSaid& said);

  // The height of the place from which it took off; nothing where that is not known.
  [[nodiscard]] std::optional<double> of(const std::string& id) const;
  [[nodiscard]] bool empty() const { return told_.empty(); }

 private:
  struct Told {
    double first_s;
    std::optional<double> ground_m;  // by the first record
    double least_m;
    double greatest_m;
    bool flies = false;
  };

  [[nodiscard]] static bool is_believed(const Told& told);
  [[nodiscard]] std::optional<double> usual_m() const;

  std::unordered_map<std::string, Told> told_;  // by id
};

}  // namespace beespace::io
