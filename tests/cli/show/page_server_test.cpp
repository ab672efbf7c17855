// How long the server of `beespace view` waits for each kind of client.
#include "cli/show/page_server.hpp"

#include <gtest/gtest.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

namespace asio = boost::asio;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

// More than what a connection holds between the two.
constexpr std::size_t kPageBytes = 32'000'000;

class Served : public testing::Test {
 protected:
  void SetUp() override {
    auto opened = PageServer::open(0, {milliseconds(1'500), milliseconds(10'000)});
    ASSERT_TRUE(opened.has_value());
    server_ = std::make_unique<PageServer>(*std::move(opened));
    host_ = server_->address().substr(7);
    host_.pop_back();
    serving_ = std::thread([this] { server_->serve(page_); });
    const auto port = static_cast<std::uint16_t>(std::stoul(host_.substr(host_.find(':') + 1)));
    socket_.connect({asio::ip::address_v4::loopback(), port});
  }
  void TearDown() override {
    server_->stop();
    serving_.join();
  }

  // All that comes until the connection is closed.
  std::size_t read_to_end() {
    std::vector<char> text(kPageBytes + 10'000);
    boost::system::error_code ended;
    return asio::read(socket_, asio::buffer(text), ended);
  }

  std::string page_ = std::string(kPageBytes, 'p');
  std::unique_ptr<PageServer> server_;
  std::string host_;
  std::thread serving_;
  asio::io_context context_;
  asio::ip::tcp::socket socket_{context_};
};

TEST_F(Served, ASlowReaderGetsAllThoughItAskedLate) {
  std::this_thread::sleep_for(milliseconds(300));
  asio::write(socket_,
              asio::buffer("GET / HTTP/1.1\r\nHost: " + host_ + "\r\nConnection: close\r\n\r\n"));
  std::this_thread::sleep_for(milliseconds(1'600));
  EXPECT_GT(read_to_end(), kPageBytes);
}

TEST_F(Served, ASilentClientIsNotWaitedForForEver) {
  const auto begun = steady_clock::now();
  EXPECT_EQ(read_to_end(), 0u);
  EXPECT_LT(steady_clock::now() - begun, std::chrono::seconds(5));
}

}  // namespace
}  // namespace beespace::cli
