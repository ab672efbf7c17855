// `beespace view`: the page that `report` writes, over HTTP, to this machine only.
#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/page_command.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kBees = "id,x,y,z\na,0,0,0\nb,1,0,0\nc,500,0,0\n";

sockaddr_in here(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  return address;
}

// A socket, which waits ten seconds at most.
class Socket {
 public:
  Socket() : descriptor_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const timeval patience{10, 0};
    setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    setsockopt(descriptor_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  }
  ~Socket() { close(descriptor_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  bool connect_to(std::uint16_t port) const {
    const sockaddr_in address = here(port);
    return connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }

  // Takes a free port, and returns it.
  std::uint16_t listen_anywhere() const {
    sockaddr_in address = here(0);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (bind(descriptor_, any, size) != 0 || listen(descriptor_, 1) != 0) return 0;
    if (getsockname(descriptor_, any, &size) != 0) return 0;
    return ntohs(address.sin_port);
  }

  void say(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t sent = send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL);
      if (sent <= 0) return;
      text.remove_prefix(static_cast<std::size_t>(sent));
    }
  }

  // Adds what comes next; false at the end.
  bool hear(std::string& text) const {
    std::array<char, 65'536> block{};
    const ssize_t count = recv(descriptor_, block.data(), block.size(), 0);
    if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
    return count > 0;
  }

 private:
  int descriptor_;
};

struct Reply {
  int status = 0;
  std::string head;
  std::string body;
};

// One reply; without a body where `only_head`.
Reply heard(const Socket& socket, bool only_head = false) {
  std::string text;
  std::size_t end = std::string::npos;
  while (end == std::string::npos && socket.hear(text)) end = text.find("\r\n\r\n");
  Reply reply;
  if (end == std::string::npos || !text.starts_with("HTTP/1.")) return reply;
  reply.head = text.substr(0, end + 2);
  reply.body = text.substr(end + 4);
  reply.status = std::stoi(text.substr(9, 3));
  const std::string name = "Content-Length: ";
  const std::size_t at = reply.head.find(name);
  const std::size_t size = at == std::string::npos ? 0 : std::stoul(reply.head.substr(at + 16));
  while (!only_head && reply.body.size() < size && socket.hear(reply.body)) continue;
  return reply;
}

class View : public PageCommand {
 protected:
  void SetUp() override {
    PageCommand::SetUp();
    if (!kHasPage) return;
    viewing_ =
        std::make_unique<Running>(Arguments{"view", folder_.file("bees.csv", kBees), "--no-open"});
    address_ = viewing_->read_line();
    ASSERT_TRUE(address_.starts_with("http://127.0.0.1:") && address_.ends_with("/")) << address_;
    port_ = static_cast<std::uint16_t>(std::stoul(address_.substr(17)));
  }

  [[nodiscard]] std::string page() const { return run({"report", folder_.path("bees.csv")}).out; }
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(port_); }
  [[nodiscard]] std::string request(const std::string& line, const std::string& more = {}) const {
    return line + " HTTP/1.1\r\nHost: " + host() + "\r\n" + more + "\r\n";
  }

  // The response to this request on a connection of its own.
  [[nodiscard]] Reply asked(const std::string& text, bool only_head = false) const {
    const Socket socket;
    EXPECT_TRUE(socket.connect_to(port_));
    socket.say(text);
    return heard(socket, only_head);
  }

  void expect_page() const {
    const Reply reply = asked(request("GET /"));
    EXPECT_EQ(reply.status, 200);
    EXPECT_TRUE(reply.body == page());
  }

  std::unique_ptr<Running> viewing_;
  std::string address_;
  std::uint16_t port_ = 0;
};

TEST_F(View, ThePageIsTheOneThatReportWrites) {
  const Reply reply = asked(request("GET /"));
  EXPECT_EQ(reply.status, 200);
  expect_parts(reply.head,
               {"Content-Type: text/html; charset=utf-8\r\n", "Cache-Control: no-store\r\n"});
  EXPECT_EQ(std::uint64_t(Page(reply.body).risk()["at_risk"]), 2u);
  EXPECT_TRUE(reply.body == page());
  EXPECT_TRUE(asked(request("GET /?any")).body == page());
}

TEST_F(View, OfTheHeadOnlyTheHeadIsSent) {
  const Socket socket;
  ASSERT_TRUE(socket.connect_to(port_));
  socket.say(request("HEAD /"));
  const Reply head = heard(socket, true);
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.body, "");
  expect_parts(head.head, {"Content-Length: " + std::to_string(page().size()) + "\r\n"});
  socket.say(request("GET /nothing"));  // nothing came in between
  EXPECT_EQ(heard(socket).status, 404);
}

TEST_F(View, ThereIsNothingElse) {
  for (const char* path : {"/page.html", "/favicon.ico", "/../etc/passwd", "//", "*"}) {
    EXPECT_EQ(asked(request(std::string("GET ") + path)).status, 404) << path;
  }
  EXPECT_EQ(asked(request("HEAD /nothing"), true).status, 404);
}

TEST_F(View, OtherMethodsAreRefused) {
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH"}) {
    EXPECT_EQ(asked(request(std::string(method) + " /")).status, 405) << method;
  }
  EXPECT_EQ(asked(request("POST /", "Content-Length: 5\r\n") + "hello").status, 405);
  expect_page();
}

TEST_F(View, OtherHostsAreRefused) {
  const std::string port = host().substr(std::string_view("127.0.0.1").size());
  for (const std::string& other :
       {"Host: example.org" + port + "\r\n", "Host: 127.0.0.1.example.org" + port + "\r\n",
        std::string("Host: 127.0.0.1:1\r\n"), std::string("Host: \r\n"), std::string()}) {
    const Reply reply = asked("GET / HTTP/1.1\r\n" + other + "\r\n");
    EXPECT_EQ(reply.status, 421) << other;
    EXPECT_EQ(reply.body, "This is served to this machine only.\n");
  }
  EXPECT_EQ(asked("GET / HTTP/1.1\r\nHost: localhost" + port + "\r\n\r\n").status, 200);
}

TEST_F(View, AConnectionMayAskAgain) {
  const Socket socket;
  ASSERT_TRUE(socket.connect_to(port_));
  const std::string whole = page();
  for (int i = 0; i < 5; ++i) {
    socket.say(request("GET /"));
    EXPECT_TRUE(heard(socket).body == whole);
  }
  socket.say(request("GET /nothing") + request("GET /", "Connection: close\r\n"));  // both at once
  std::string rest;
  while (socket.hear(rest)) continue;
  EXPECT_TRUE(rest.starts_with("HTTP/1.1 404"));
  EXPECT_TRUE(rest.ends_with(whole));
}

TEST_F(View, ManyAreServedAtOnceAndIdleOnesDoNotBlock) {
  std::vector<std::unique_ptr<Socket>> idle;
  for (int i = 0; i < 20; ++i) {
    idle.push_back(std::make_unique<Socket>());
    ASSERT_TRUE(idle.back()->connect_to(port_));
    if (i % 2 == 0) idle.back()->say("GET / HT");  // and no more
  }
  const std::string whole = page();
  std::vector<std::thread> browsers;
  std::array<bool, 8> served{};
  for (bool& good : served) {
    browsers.emplace_back([&] { good = asked(request("GET /")).body == whole; });
  }
  for (std::thread& browser : browsers) browser.join();
  for (const bool good : served) EXPECT_TRUE(good);
  idle[0]->say("TP/1.1\r\nHost: " + host() + "\r\n\r\n");
  EXPECT_TRUE(heard(*idle[0]).body == whole);
}

TEST_F(View, NonsenseDoesNotEndIt) {
  for (const std::string& nonsense :
       {std::string("nonsense\r\n\r\n"), std::string(1'000, '\0'), std::string(100'000, 'x'),
        std::string("\x16\x03\x01\x02\x00\x01", 6), "GET / HTTP/9.9\r\n\r\n" + std::string(9, ' '),
        request("GET /", "Content-Length: -1\r\n"), request("GET /" + std::string(100'000, 'a')),
        request("GET /", "X: " + std::string(100'000, 'a') + "\r\n"),
        request("POST /", "Content-Length: 99999999999999\r\n") + std::string(100'000, 'a'),
        request("POST /", "Transfer-Encoding: chunked\r\n") + "fffffffffffffffff\r\n"}) {
    EXPECT_NE(asked(nonsense).status, 200);
  }
  {
    const Socket gone;  // before the page is read
    ASSERT_TRUE(gone.connect_to(port_));
    gone.say(request("GET /"));
  }
  expect_page();
}

TEST_F(View, AnInvalidRequestGetsAnError) {
  EXPECT_EQ(asked("nonsense\r\n\r\n").status, 400);
  EXPECT_EQ(asked(request("GET /", "Content-Length: -1\r\n")).status, 400);
  EXPECT_EQ(asked(request("POST /", "Content-Length: 99999999999\r\n")).status, 413);
  EXPECT_EQ(asked(request("GET /", "X: " + std::string(100'000, 'a') + "\r\n")).status, 431);
  const Reply reply = asked(request("POST /", "Content-Length: 2000000\r\n") +
                            std::string(2'000'000, 'a'));  // an answer though it is not read
  EXPECT_EQ(reply.status, 413);
  EXPECT_EQ(reply.body, "There is only a page to get.\n");
  expect_parts(reply.head, {"Connection: close\r\n"});
}

TEST_F(View, CtrlCEndsIt) {
  expect_page();  // from here on all is said
  viewing_->signal(SIGINT);
  const Finished finished = viewing_->finish();
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(finished.out, "") << "more than the address";
  expect_parts(finished.err, {"input      bees.csv (", "bees       3\n", "at risk    2 of 3: ",
                              "Open this address in a browser on this machine; Ctrl-C ends it.\n"});
}

TEST_F(View, APortThatIsTakenIsReported) {
  expect_failure({"view", folder_.path("bees.csv"), "--no-open", "--port", std::to_string(port_)},
                 {}, 4, "cannot serve a page on 127.0.0.1, port " + std::to_string(port_) + ": ");
}

class ViewOnce : public PageCommand {};

// With a desktop whose xdg-open is this script.
class ViewOnDesktop : public PageCommand {
 protected:
  void SetUp() override {
    PageCommand::SetUp();
    path_ = std::getenv("PATH");
    setenv("PATH", (folder_.path("") + ":" + path_).c_str(), 1);
    setenv("DISPLAY", ":0", 1);
  }
  void TearDown() override {
    if (!path_.empty()) setenv("PATH", path_.c_str(), 1);
    unsetenv("DISPLAY");
  }

  void opens_with(const std::string& script) const {
    const std::string opener = folder_.file("xdg-open", "#!/bin/bash\n" + script);
    std::filesystem::permissions(opener, std::filesystem::perms::owner_all);
  }
  [[nodiscard]] std::unique_ptr<Running> view() const {
    return std::make_unique<Running>(Arguments{"view", folder_.file("bees.csv", kBees)});
  }
  // The line that says what became of it.
  static std::string told(const Running& viewing) {
    std::string line = viewing.read_error_line();
    while (!line.empty() && line.find("Ctrl-C") == std::string::npos) {
      line = viewing.read_error_line();
    }
    return line;
  }

 private:
  std::string path_;
};

TEST_F(ViewOnDesktop, ABrowserThatIsWaitedForIsServed) {
  opens_with(
      "authority=${1#http://}; authority=${authority%/}\n"
      "exec 3<>\"/dev/tcp/${authority%:*}/${authority#*:}\"\n"
      "printf 'GET / HTTP/1.1\\r\\nHost: %s\\r\\nConnection: close\\r\\n\\r\\n' "
      "\"$authority\" >&3\n"
      "cat <&3 >'" +
      folder_.path("part") + "'\nmv '" + folder_.path("part") + "' '" + folder_.path("got") +
      "'\n");
  const auto viewing = view();
  EXPECT_EQ(told(*viewing), "Opened in the browser; Ctrl-C ends it.");
  for (int k = 0; k < 1'000 && !std::filesystem::exists(folder_.path("got")); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));  // of a slow machine
  }
  const std::string got = folder_.read("got");
  EXPECT_TRUE(got.starts_with("HTTP/1.1 200"));
  EXPECT_TRUE(got.ends_with(run({"report", folder_.path("bees.csv")}).out));
  viewing->signal(SIGINT);
  EXPECT_EQ(viewing->finish().exit_code, 130);
}

TEST_F(ViewOnDesktop, ABrowserThatStaysIsNotWaitedFor) {
  opens_with("echo $$ >'" + folder_.path("process") + "'\nexec sleep 100\n");
  const auto viewing = view();
  EXPECT_EQ(told(*viewing), "Opened in the browser; Ctrl-C ends it.");
  viewing->signal(SIGINT);
  EXPECT_EQ(viewing->finish().exit_code, 130);
  const int browser = std::stoi(folder_.read("process"));
  EXPECT_EQ(kill(browser, SIGTERM), 0) << "the browser outlives the command";
}

TEST_F(ViewOnDesktop, ABrowserThatCannotBeOpenedIsReported) {
  opens_with("exit 3\n");
  EXPECT_EQ(told(*view()), "Open this address in a browser on this machine; Ctrl-C ends it.");
  opens_with("kill -9 $$\n");
  EXPECT_EQ(told(*view()), "Open this address in a browser on this machine; Ctrl-C ends it.");
}

TEST_F(ViewOnce, APortMayBeChosen) {
  std::uint16_t port = 0;
  {
    const Socket holder;
    port = holder.listen_anywhere();
    ASSERT_NE(port, 0);
    expect_failure({"view", "--no-open", "--port", std::to_string(port)}, kBees, 4, "port");
  }
  Running viewing({"view", "-", "--no-open", "--quiet", "--port", std::to_string(port)});
  viewing.send(kBees);
  viewing.close_input();
  EXPECT_EQ(viewing.read_line(), "http://127.0.0.1:" + std::to_string(port) + "/");
  viewing.signal(SIGTERM);
  const Finished finished = viewing.finish();
  EXPECT_EQ(finished.exit_code, 143);
  EXPECT_EQ(finished.err, "");
}

TEST_F(ViewOnce, WhatIsNoPortIsRefused) {
  for (const char* port : {"70000", "65536", "-1", "http", "8080x", "1e3"}) {
    expect_failure({"view", "--no-open", std::string("--port=") + port}, kBees, 2,
                   "--port is '" + std::string(port) + "'; give a number up to 65535");
  }
}

TEST_F(ViewOnce, ItsHelpSaysWhichOthersCanRead) {
  expect_parts(run({"view", "--help"}).out, {"who find the port can read the page"});
}

TEST_F(ViewOnce, WhatCannotBeReadIsNotServed) {
  expect_failure({"view", "--no-open"}, "x,y,z\n0,zero,0\n", 3, "<stdin>:2");
  expect_failure({"view", folder_.path("missing.csv"), "--no-open"}, {}, 4, "missing.csv");
}

TEST_F(ViewOnce, TwoAreServedBesideEachOther) {
  const std::string bees = folder_.file("bees.csv", kBees);
  Running viewing({"view", bees, "--compare", bees, "--no-open", "--quiet"});
  const std::string address = viewing.read_line();
  ASSERT_GT(address.size(), 18u);
  const Socket socket;
  ASSERT_TRUE(socket.connect_to(static_cast<std::uint16_t>(std::stoul(address.substr(17)))));
  const std::string host = address.substr(7, address.size() - 8);
  socket.say("GET / HTTP/1.1\r\nHost: " + host + "\r\n\r\n");
  EXPECT_EQ(Page(heard(socket).body).swarms(), 2u);
}

}  // namespace
}  // namespace beespace::cli_test
