// Many callers at once: each with an Engine of its own, all with the threads of one crew.
#include "tests/contract/agreement.hpp"

#include <beespace/crew.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace beespace::test {
namespace {

TEST(Concurrency, CallersThatShareACrewGetTheAnswersOfBruteForce) {
  constexpr std::size_t kCallers = 4;
  constexpr std::size_t kStep = 23;  // a sample of the inquiries, another one for each caller
  const auto& expected = expected_digests();
  const auto crew = std::make_shared<ThreadCrew>(3);
  std::atomic<std::size_t> asked = 0;
  std::vector<std::string> wrong(kCallers);
  std::vector<std::thread> callers;
  for (std::size_t caller = 0; caller < kCallers; ++caller) {
    callers.emplace_back([&, caller] {
      const Variant engine = engine_with_crew("SharedCrew", crew);
      for (std::size_t i = caller; i < inquiries().size(); i += kStep) {
        if (digest(engine.ask(inquiries()[i])) != expected[i]) {
          wrong[caller] += described(inquiries()[i]) + "\n";
        }
        ++asked;
      }
    });
  }
  for (std::thread& caller : callers) caller.join();
  for (const std::string& text : wrong) EXPECT_EQ(text, "");
  EXPECT_GT(asked, kCallers * inquiries().size() / kStep - kCallers);
}

}  // namespace
}  // namespace beespace::test
