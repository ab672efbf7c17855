// Aircraft that say that they are on the ground, while what they report before and after shows that
// they fly.
//
// Reports come in the order of the input; an aircraft whose time goes back is looked at anew from
// there. A run of claims is taken for flight where one of these holds:
// - it goes on at more than 45 m/s on average for a minute: no roll before a take-off or after a
//   landing lasts so long;
// - its heights differ by more than 100 m within two minutes: no runway does;
// - it is more than 50 m higher than where the aircraft flew within the minute before or after;
// - at least 20 s before and after it the aircraft flies within 50 m of its height, at over 30 m/s:
//   who touches down and goes comes from higher, and climbs.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/track.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>

namespace beespace::io {

class GroundClaims {
 public:
  // Of a run that is over, for which nothing more can be said: whose, how many claims it had, and
  // whether they were made in flight.
  using Settle = std::function<void(const std::string& id, std::uint64_t claims, bool in_flight)>;

  // The next report of that aircraft. Where the height is unknown it is not-a-number.
  void take(std::string_view id, const Fix& fix, bool on_ground, Frame frame, const Settle& settle);
  // At the end of the input.
  void finish(const Settle& settle);

 private:
  // Heights over some time.
  struct Stretch {
    double begins_s = std::numeric_limits<double>::infinity();
    double ends_s = -std::numeric_limits<double>::infinity();
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -std::numeric_limits<double>::infinity();

    void add(const Fix& fix);
    void add(const Stretch& other);
    [[nodiscard]] double lasts_s() const { return ends_s - begins_s; }
  };

  struct Aircraft {
    Fix last = {};
    bool known = false;    // there is a last report
    Stretch earlier = {};  // of where it flew: the last half a minute or so,
    Stretch lately = {};   // and since then
    // The run of claims; none where `claims` is 0.
    std::uint64_t claims = 0;
    bool over = false;  // it flies again
    bool in_flight = false;
    Fix anchor = {};       // the first claim, or one a minute and more ago
    Stretch window = {};   // of the claims since then
    Stretch run = {};      // of all claims
    Stretch before = {};   // of where it flew before
    Fix flew_before = {};  // the last of these
    bool flew = false;     // there is one
  };

  static void begin_run(Aircraft& aircraft, const Fix& fix);
  static void claim(Aircraft& aircraft, const Fix& fix, Frame frame);
  static void fly(Aircraft& aircraft, const Fix& fix, Frame frame);

  std::map<std::string, Aircraft, std::less<>> aircraft_;
};

}  // namespace beespace::io
