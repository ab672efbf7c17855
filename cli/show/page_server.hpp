// One page over HTTP, to browsers on this machine only.
#pragma once

#include <beespace/result.hpp>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace beespace::cli {

// How long a connection may take before it is closed.
struct ServerPatience {
  std::chrono::milliseconds request = std::chrono::seconds(30);  // since the last answer
  // From the first byte of an answer to its last, and a second more for each 64 KiB of it.
  std::chrono::milliseconds answer = std::chrono::seconds(30);
};

class PageServer {
 public:
  // On a free port of 127.0.0.1, or on the given one. Errors: kCannotOpen.
  static Result<PageServer> open(std::uint16_t port = 0, const ServerPatience& patience = {});
  PageServer(PageServer&&) noexcept;
  PageServer& operator=(PageServer&&) noexcept;
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;
  ~PageServer();

  // "http://127.0.0.1:34567/".
  [[nodiscard]] std::string address() const;

  // Answers GET and HEAD of "/" with the page, and everything else with an error; until a signal
  // ends the program, or stop() is called. Requests that name another host are refused: a page from
  // elsewhere could make the browser ask in its name. The page must outlive the call.
  void serve(std::string_view page);
  // Ends serve(); from any thread.
  void stop();

 private:
  struct State;
  explicit PageServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace beespace::cli
