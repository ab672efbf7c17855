// What `beespace watch --advise` says: how those should fly on whose way leads too close to others.
//
// Everybody would like to fly on as it does. Everybody who is not stale takes part, brought forward
// in a straight line to the time of the look; who was heard of once and without a velocity does
// not, as nobody knows where it is going. While there is one of these, or a stale one, nothing is
// certified.
//
// Between positions in degrees the frame is that of the Earth, in which z is not up. The advice
// asks for up only to tell sides apart where there is nothing else to tell them by; any direction
// that all agree on will do.
#pragma once

#include "cli/moving/live_feed.hpp"
#include "io/recording.hpp"

#include <beespace/advise.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

struct LiveAdviceRequest {
  AdviseOptions options;
  FlightLimits limits;  // who is faster already may stay so
};

class LiveAdvice {
 public:
  LiveAdvice(const LiveAdviceRequest& request, io::Frame frame)
      : request_(request), frame_(frame) {}

  // A line of JSON for each bee that should not fly on as it does or is not certified, in the order
  // of their numbers; none at the time of the call before.
  // Errors: as Adviser::advise.
  Result<std::string> lines(double time_s, const LiveFeed& feed);

  // Lines so far; and those of bees that are not certified.
  [[nodiscard]] std::uint64_t told() const { return told_; }
  [[nodiscard]] std::uint64_t uncertified() const { return uncertified_; }

 private:
  void append_line(std::string& out, double time_s, const LiveMover& bee, const Advice& advice,
                   const BeeName& name) const;

  LiveAdviceRequest request_;
  io::Frame frame_;
  Adviser adviser_;
  std::vector<Mover> movers_;
  std::vector<Velocity> preferred_;
  std::vector<FlightLimits> limits_;
  Advised advised_;
  std::optional<double> last_s_;
  std::uint64_t told_ = 0;
  std::uint64_t uncertified_ = 0;
};

}  // namespace beespace::cli
