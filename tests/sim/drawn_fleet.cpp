#include "tests/sim/drawn_fleet.hpp"

#include "scenes/random_stream.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

namespace beespace::sim {

namespace {

using scenes::RandomStream;

class Drawing {
 public:
  explicit Drawing(std::uint64_t seed) : random_(seed) { fleet_.options.seed = seed; }

  std::optional<DrawnFleet> draw() {
    draw_rules();
    draw_shape();
    if (!chance(0.08)) draw_errors();
    if (chance(0.4)) draw_clocks();
    draw_channels();
    draw_fates();
    const auto tube = stated_tube(options());
    if (!tube || tube->radius_m > 200.0 * options().threshold_m) return std::nullopt;
    draw_places(tube->radius_m);
    fleet_.text = text(tube->radius_m);
    return std::move(fleet_);
  }

 private:
  FleetOptions& options() { return fleet_.options; }
  [[nodiscard]] bool on_ground() const { return fleet_.options.place == LoopPlace::kGround; }
  bool chance(double probability) { return random_.uniform() < probability; }
  // As likely in each decade.
  double decades(double low, double high) {
    return low * std::exp(random_.uniform() * std::log(high / low));
  }
  int whole(int low, int high) {
    return low + static_cast<int>(random_.index(static_cast<std::uint32_t>(high - low + 1)));
  }

  void draw_rules() {
    FleetOptions& o = options();
    o.place = chance(0.4) ? LoopPlace::kGround : LoopPlace::kOnboard;
    constexpr int kInstants[] = {1, 2, 4, 5, 8, 10};
    o.instants = kInstants[random_.index(static_cast<std::uint32_t>(std::size(kInstants)))];
    // Whole microseconds an instant, so that ticks and instants are the same times.
    const double instant_us = std::max(1.0, std::round(decades(0.02, 1.0) * 1e6 / o.instants));
    o.link.period_s = instant_us * o.instants * 1e3 * 1e-9;
    o.link.command_delay = chance(0.05) ? 32 : whole(1, 12);
    o.threshold_m = decades(0.1, 50.0);
    o.limits = {decades(0.5, 30.0), decades(0.5, 20.0)};
    o.planar = chance(0.25);
    o.clearance_m = decades(0.05, 10.0);
    o.loop_period = whole(1, chance(0.2) ? 3 * o.instants : o.instants);
    o.loop_delay = whole(0, 5);
    fleet_.ticks = whole(50, 300);
  }

  void draw_shape() {
    FleetOptions& o = options();
    const std::uint32_t shape = random_.index(3);
    if (shape == 1) o.separation = {SeparationShape::kEllipsoid, decades(0.2, 5.0)};
    if (shape == 2) {
      o.separation = {SeparationShape::kCylinder, 1.0, o.threshold_m * decades(0.1, 4.0)};
    }
    if (!chance(0.3)) return;
    o.least_radius_m = o.threshold_m * random_.uniform(0.0, 0.7);
    o.most_radius_m = o.least_radius_m + o.threshold_m * random_.uniform(0.0, 0.8);
  }

  void draw_errors() {
    FleetOptions& o = options();
    o.correction_mps = o.limits.max_speed_mps * random_.uniform(0.05, 0.6);
    o.correction_mps2 = o.limits.max_acceleration_mps2 * random_.uniform(0.05, 0.6);
    const double carried_mps =
        o.correction_mps * (chance(0.2) ? random_.uniform(0.8, 0.98) : decades(0.01, 0.8));
    const double steady = chance(0.3) ? (chance(0.5) ? 0.0 : 1.0) : random_.uniform();
    DisturbanceBounds& wind = o.errors.disturbance;
    wind.kind = chance(0.6) ? ErrorKind::kAdversarial : ErrorKind::kUniform;
    wind.drift_mps = carried_mps * steady;
    wind.gust_mps = carried_mps * (1.0 - steady);
    wind.least_gust_s = decades(0.02, 1.0);
    wind.most_gust_s = wind.least_gust_s * decades(1.0, 10.0);
    const auto error = [&] { return chance(0.2) ? 0.0 : decades(3e-4, 0.3) * o.threshold_m; };
    o.errors.sensing_error_m = error();
    o.errors.report_error_m = error();
    o.errors.report_velocity_error_mps = chance(0.5) ? 0.25 : 0.0;
  }

  void draw_clocks() {
    FleetOptions& o = options();
    o.errors.clock.bound_s = o.link.period_s * decades(0.005, 1.0);
    o.errors.clock.wanders = chance(0.5);
    o.errors.clock.slew = decades(0.0005, 0.05);
    o.link.command_delay = std::max(2, o.link.command_delay);
  }

  void draw_channels() {
    FleetOptions& o = options();
    for (ChannelErrors* const channel : {&o.reports, &o.commands}) {
      channel->least_latency = whole(0, 3);
      channel->most_latency = channel->least_latency + whole(0, 4);
      if (chance(0.5)) channel->duplicates = random_.uniform();
    }
    if (on_ground()) return keep_up_with_the_ground();
    if (!chance(0.6)) return;
    o.link.longest_loss = whole(0, 19);
    for (ChannelErrors* const channel : {&o.reports, &o.commands}) {
      channel->loss = random_.uniform(0.0, 0.9);
      channel->in_a_row = random_.uniform();
      // On board even a radio that falls silent for long endangers nothing.
      channel->longest_run = chance(0.3) ? 1000 : o.link.longest_loss;
    }
  }

  // There each command must be in time.
  void keep_up_with_the_ground() {
    FleetOptions& o = options();
    const int clock = o.errors.clock.bound_s > 0.0 ? 1 : 0;
    const int least = o.instants == 1 ? 2 + clock : 1 + clock;
    constexpr int kMostOnTheWay = 12;  // commands, and reports of them
    const int most_delay = kMostOnTheWay - 3 * clock - static_cast<int>(o.reports.most_latency);
    o.link.command_delay = std::clamp(o.link.command_delay, least, most_delay);
    const std::int64_t most = o.link.command_delay - 1 - clock;
    o.commands.most_latency = std::min(o.commands.most_latency, most);
    o.commands.least_latency = std::min(o.commands.least_latency, o.commands.most_latency);
  }

  // Who is weak, falls silent, joins late or comes from elsewhere.
  void draw_fates() {
    FleetOptions& o = options();
    const double lasts_s = fleet_.ticks * o.link.period_s;
    if (chance(0.2)) {
      o.weak_share = random_.uniform(0.0, 0.5);
      o.weak_strength = random_.uniform(0.05, 1.0);
    }
    if (!on_ground() && chance(0.25)) {
      o.silent_share = random_.uniform(0.0, 0.8);
      o.silent_from_s = 0.0;
      o.silent_to_s = lasts_s;
      o.silent_are_told = chance(0.3);
    }
    if (chance(0.25)) o.joins_per_s = decades(10.0, 1000.0) / lasts_s;
    if (!chance(0.2)) return;
    o.intruders = 1 + random_.index(4);
    o.intruder_speed_mps = decades(0.5, 60.0);
    o.intruder_error_m = chance(0.5) ? 0.0 : decades(0.01, 5.0);
  }

  // A lattice, hardly wider than it must be, or with room; each wants to go to another's place, to
  // the opposite one, or all to the middle.
  void draw_places(double tube_m) {
    const FleetOptions& o = options();
    const double free_m = std::max(o.threshold_m, 2.0 * o.most_radius_m);
    const double room = chance(0.5) ? 1.0 + 1e-6 : 1.0 + random_.uniform(0.0, 0.5);
    const double spare_m = 2e-6 * (1.0 + free_m);
    double high_m = free_m;
    if (o.separation.shape == SeparationShape::kEllipsoid) high_m *= o.separation.vertical_factor;
    if (o.separation.shape == SeparationShape::kCylinder) high_m = o.separation.vertical_m;
    const Point step{(free_m + 2.0 * tube_m + spare_m) * room,
                     (free_m + 2.0 * tube_m + spare_m) * room,
                     (high_m + 2.0 * tube_m + spare_m) * room};
    const std::size_t agents = 2 + random_.index(chance(0.7) ? 20 : 59);
    const double dimensions = o.planar ? 2.0 : 3.0;
    const int side = static_cast<int>(std::ceil(std::pow(double(agents), 1.0 / dimensions)));
    std::vector<Point>& starts = fleet_.mission.starts;
    for (int z = 0; z < (o.planar ? 1 : side); ++z) {
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          starts.push_back({x * step.x, y * step.y, o.planar ? 3.0 : z * step.z});
        }
      }
    }
    shuffle(starts);
    starts.resize(std::min(starts.size(), agents));
    const double last = side - 1.0;
    const Point far{last * step.x, last * step.y, o.planar ? 6.0 : last * step.z};
    std::vector<Point>& goals = fleet_.mission.goals;
    goals = starts;
    switch (random_.index(3)) {
      case 0:
        shuffle(goals);
        break;
      case 1:
        for (Point& goal : goals) goal = {far.x - goal.x, far.y - goal.y, far.z - goal.z};
        break;
      default:
        for (Point& goal : goals) goal = {0.5 * far.x, 0.5 * far.y, 0.5 * far.z};
    }
    if (chance(0.25)) draw_fences(far, tube_m + o.clearance_m + spare_m * (1.0 + tube_m));
  }

  // Around all, hardly farther than they must be.
  void draw_fences(const Point& far, double off_m) {
    std::vector<Fence>& fences = options().fences;
    fences = {{{1, 0, 0}, -off_m}, {{0, 1, 0}, -off_m}, {{-1, 0, 0}, -far.x - off_m}};
    if (!options().planar && chance(0.5)) fences.push_back({{0, 0, 1}, -off_m});
    if (!chance(0.5)) return;
    const double angle = random_.uniform(0.1, 1.4);
    fences.push_back({{std::cos(angle), std::sin(angle), 0}, -1.001 * off_m});
  }

  void shuffle(std::vector<Point>& places) {
    for (std::size_t i = places.size(); i > 1; --i) {
      std::swap(places[i - 1], places[random_.index(static_cast<std::uint32_t>(i))]);
    }
  }

  std::string text(double tube_m) {
    const FleetOptions& o = options();
    std::ostringstream out;
    out.precision(4);
    out << fleet_.mission.starts.size() << (on_ground() ? " on the ground" : " on board") << ", "
        << fleet_.ticks << " ticks of " << o.link.period_s << " s in " << o.instants << ", D "
        << o.link.command_delay << ", X " << o.threshold_m << " m, shape "
        << static_cast<int>(o.separation.shape) << ", tube " << tube_m << " m, "
        << o.limits.max_speed_mps << " m/s, " << o.limits.max_acceleration_mps2 << " m/s^2, drift "
        << o.errors.disturbance.drift_mps << ", gusts " << o.errors.disturbance.gust_mps
        << ", clocks " << o.errors.clock.bound_s << " s, loss " << o.commands.loss << " and "
        << o.reports.loss << ", weak " << o.weak_share << ", silent " << o.silent_share
        << ", joins " << o.joins_per_s << ", intruders " << o.intruders << ", fences "
        << o.fences.size() << (o.planar ? ", planar" : "");
    return out.str();
  }

  RandomStream random_;
  DrawnFleet fleet_;
};

}  // namespace

std::optional<DrawnFleet> draw_fleet(std::uint64_t seed) {
  return Drawing(seed).draw();
}

}  // namespace beespace::sim
