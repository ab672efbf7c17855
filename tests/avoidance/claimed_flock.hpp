// A flock with claims, flown by hand: each agent has a path of a few states ahead, at whose end the
// advice takes effect; some commands are not sent, and of some it is not known whether they
// arrived.
#pragma once

#include "tests/avoidance/flock.hpp"

#include <beespace/advise.hpp>

#include <deque>
#include <vector>

namespace beespace::test {

inline Point plus(const Point& p, const Velocity& v, double s) {
  return {p.x + v.x * s, p.y + v.y * s, p.z + v.z * s};
}

// A path: states at successive ticks, the last of which brakes to a stop.
struct Path {
  std::deque<Mover> states;

  // All control points of the motion, and the stop.
  void append_places(const FlightLimits& limits, double step_s, std::vector<Point>& places) const {
    for (const Mover& state : states) {
      places.push_back(state.position);
      if (&state != &states.back()) {
        places.push_back(plus(state.position, state.velocity, 0.5 * step_s));
      }
    }
    const auto& [p, v] = states.back();
    const double lasts_s = 0.5 * (length_of(v) / limits.max_acceleration_mps2 + step_s);
    places.push_back(plus(p, v, lasts_s));
  }
};

inline Velocity braked(const Velocity& v, double change) {
  const double speed = length_of(v);
  return speed > change ? scaled(v, (speed - change) / speed) : Velocity{};
}

struct ClaimedAgent {
  Path path;                  // with the last command
  std::vector<Path> others;   // that it may follow instead
  std::vector<Point> places;  // of all
};

struct ClaimedFlock {
  std::vector<ClaimedAgent> agents;
  std::vector<Claim> claims;  // tubes, radii
  FlightLimits limits;
  AdviseOptions options;
  PlaneMemory planes;
  std::vector<Mover> movers;  // at departure

  void add(const Point& place, std::size_t ticks_ahead, const Claim& claim) {
    ClaimedAgent agent;
    agent.path.states.assign(ticks_ahead + 1, Mover{place, {}});
    agents.push_back(agent);
    claims.push_back(claim);
  }

  // What the next call needs.
  void prepare() {
    movers.clear();
    for (std::size_t k = 0; k < agents.size(); ++k) {
      ClaimedAgent& agent = agents[k];
      agent.places.clear();
      agent.path.append_places(limits, options.step_s, agent.places);
      for (const Path& path : agent.others)
        path.append_places(limits, options.step_s, agent.places);
      claims[k].places = agent.places;
      movers.push_back(agent.path.states.back());
    }
    options.claims = claims;
    options.planes = &planes;
  }

  // A tick later. An agent that holds gets nothing; of the others some commands are not sent, and
  // some may arrive or not.
  void advance(const std::vector<Advice>& advice, scenes::RandomStream& random) {
    for (std::size_t k = 0; k < agents.size(); ++k) {
      ClaimedAgent& agent = agents[k];
      const double change = limits.max_acceleration_mps2 * options.step_s;
      const auto onwards = [&](Path& path, const Velocity& next) {
        path.states.push_back(flown(path.states.back(), next, false, options.step_s));
        path.states.pop_front();
      };
      for (Path& path : agent.others) onwards(path, braked(path.states.back().velocity, change));
      const Velocity fallback = braked(agent.path.states.back().velocity, change);
      const auto what = random.index(10);
      if (claims[k].holds || what == 0) {
        onwards(agent.path, fallback);
        continue;
      }
      if (what == 1) agent.others.clear();  // heard of
      if (what == 2 && agent.others.size() < 3) {
        agent.others.push_back(agent.path);
        onwards(agent.others.back(), fallback);
      }
      onwards(agent.path, advice[k].velocity);
    }
  }
};

}  // namespace beespace::test
