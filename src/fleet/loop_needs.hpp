// What the loop of correction_loop.hpp needs, and how far an agent can deviate all the same.
//
// The answer of the loop to what carries the agent off (at most w), and to the error of what it
// takes for the deviation (at most e), is linear; so the most that x, u and a can be is the sum of
// the magnitudes of their impulse responses, times w and e. They are numbers, not matrices, so the
// same holds for vectors and their lengths. The sums are closed; docs/tube.md derives them.
#pragma once

namespace beespace::fleet {

// What works on a loop: both bounds.
struct LoopBurden {
  double deviation_mps = 0.0;  // w
  double error_m = 0.0;        // e
};

struct LoopNeeds {
  double radius_m = 0.0;     // |x|, at every instant
  double speed_mps = 0.0;    // |u|
  double thrust_mps2 = 0.0;  // |a|
};

// Of a loop that is closed all the time; the gain k, above zero.
LoopNeeds continuous_needs(double gain_per_s, const LoopBurden& burden);
// Of a loop that is closed once in a period; the share 1 - exp(-k T), above zero, below one.
LoopNeeds sampled_needs(double share, double period_s, const LoopBurden& burden);

// The fastest loop of which the needs are met, as the deviation is the smallest then; zero if there
// is none. Deviation above zero. The continuous one gives k, the sampled one the share.
double fastest_continuous(const LoopBurden& burden, double most_mps, double most_mps2);
double fastest_sampled(double period_s, const LoopBurden& burden, double most_mps,
                       double most_mps2);

}  // namespace beespace::fleet
