// One page over HTTP, to browsers on this machine only.
#pragma once

#include <beespace/result.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace beespace::cli {

class PageServer {
 public:
  // On a free port of 127.0.0.1, or on the given one. Errors: kCannotOpen.
  static Result<PageServer> open(std::uint16_t port = 0);
  PageServer(PageServer&&) noexcept;
  PageServer& operator=(PageServer&&) noexcept;
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;
  ~PageServer();

  // "http://127.0.0.1:34567/".
  [[nodiscard]] std::string address() const;

  // Answers GET and HEAD of "/" with the page, and everything else with an error; until a signal
  // ends the program. Requests that name another host are refused: a page from elsewhere could
  // make the browser ask in its name. The page must outlive the call.
  void serve(std::string_view page);

 private:
  struct State;
  explicit PageServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace beespace::cli
