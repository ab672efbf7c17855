// One way to answer the questions: a library used as a competent user would use it.
//
// Each contender is a program of its own: one source file that defines make_contender(), linked
// with contender_main.cpp, which reads the points, checks the answer, and does the timing.
#pragma once

#include "bench/compare/answer.hpp"
#include "bench/compare/question.hpp"

#include <beespace/point.hpp>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::compare {

// The meaning of a difference from the exact answer.
enum class Arithmetic : std::uint8_t {
  kExact,        // decided as by real numbers
  kFloat64,      // rounded, but wrong only within an ulp of the threshold: must agree here
  kFloat32,      // differs near the threshold: by how much is a result
  kApproximate,  // differs by its method: by how much is a result
};

struct Description {
  std::string name;
  std::string version;
  Arithmetic arithmetic = Arithmetic::kFloat64;
  std::string use;  // how it is used: the tuning, the order of the queries
  std::vector<Question> questions;
};

class Contender {
 public:
  Contender() = default;
  Contender(const Contender&) = delete;
  Contender& operator=(const Contender&) = delete;
  virtual ~Contender() = default;

  [[nodiscard]] virtual Description description() const = 0;

  // Builds whatever index it needs and answers, from nothing, on one thread (unless the variant
  // says otherwise). Only questions of description() are asked.
  virtual Answer answer(Question question, std::span<const Point> points, double threshold_m) = 0;

  // Takes back an answer that is no longer needed, for contenders that reuse memory. Not timed.
  virtual void take_back(Answer /*answer*/) {}
};

// `variant` tells apart several ways to use one library; most have only one, the empty one.
std::unique_ptr<Contender> make_contender(std::string_view variant);

}  // namespace beespace::compare
