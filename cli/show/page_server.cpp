#include "cli/show/page_server.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

#include <chrono>
#include <utility>

namespace beespace::cli {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using Tcp = asio::ip::tcp;

using Request = http::request<http::string_body>;  // what is posted is read, and refused
using Response = http::response<http::span_body<const char>>;

// A connection: one request after the other, until the browser closes it or says nothing for long.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Tcp::socket socket, std::string_view page, std::uint16_t port,
             const ServerPatience& patience)
      : stream_(std::move(socket)),
        patience_(patience),
        page_(page),
        port_(port == kPlainPort ? "" : ":" + std::to_string(port)) {}

  void read() {
    request_ = {};
    stream_.expires_after(patience_.request);
    http::async_read(stream_, buffer_, request_,
                     [self = shared_from_this()](const beast::error_code& error, std::size_t) {
                       if (error) {
                         self->refuse(error);
                       } else {
                         self->answer();
                       }
                     });
  }

 private:
  // What is no request, or too long. Who has gone, or says nothing, needs no answer.
  void refuse(const beast::error_code& error) {
    const bool about_http =
        error.category() == beast::error_code(http::error::bad_method).category();
    if (!about_http || error == http::error::end_of_stream ||
        error == http::error::partial_message) {
      return;
    }
    request_ = {};
    request_.keep_alive(false);
    if (error == http::error::body_limit) {
      answer(http::status::payload_too_large, "There is only a page to get.\n");
    } else if (error == http::error::header_limit || error == http::error::buffer_overflow) {
      answer(http::status::request_header_fields_too_large, "This is too long.\n");
    } else {
      answer(http::status::bad_request, "This is no request.\n");
    }
  }

  void answer() {
    const auto host = request_[http::field::host];
    const bool page = request_.target() == "/" || request_.target().starts_with("/?");
    if (host != "127.0.0.1" + port_ && host != "localhost" + port_) {
      answer(http::status::misdirected_request, "This is served to this machine only.\n");
    } else if (request_.method() != http::verb::get && request_.method() != http::verb::head) {
      answer(http::status::method_not_allowed, "There is only a page to get.\n");
    } else if (!page) {
      answer(http::status::not_found, "There is nothing but the page at /.\n");
    } else {
      answer(http::status::ok, page_);
    }
  }

  void answer(http::status status, std::string_view body) {
    response_ = Response(status, request_.version());
    response_.keep_alive(request_.keep_alive());
    response_.set(http::field::content_type,
                  status == http::status::ok ? "text/html; charset=utf-8" : "text/plain");
    response_.set(http::field::cache_control, "no-store");
    response_.content_length(body.size());
    const bool only_head = request_.method() == http::verb::head;
    response_.body() =
        only_head ? beast::span<const char>() : beast::span<const char>(body.data(), body.size());
    const auto more = std::chrono::seconds(body.size() / kSlowest);
    stream_.expires_after(patience_.answer + more);
    http::async_write(stream_, response_,
                      [self = shared_from_this()](const beast::error_code& error, std::size_t) {
                        if (error) return;
                        if (self->response_.keep_alive()) {
                          self->read();
                        } else {
                          self->finish();
                        }
                      });
  }

  // A connection that is closed with something unread takes back the answer; so what still comes
  // is read, for a while.
  void finish() {
    constexpr std::chrono::seconds kPatience(2);
    beast::error_code gone;
    stream_.socket().shutdown(Tcp::socket::shutdown_send, gone);
    if (gone) return;
    stream_.expires_after(kPatience);
    read_out();
  }

  void read_out() {
    buffer_.clear();
    stream_.async_read_some(
        buffer_.prepare(buffer_.max_size()),
        [self = shared_from_this()](const beast::error_code& error, std::size_t) {
          if (!error) self->read_out();
        });
  }

  static constexpr std::size_t kSlowest = 65'536;  // bytes a second

  beast::tcp_stream stream_;
  ServerPatience patience_;
  beast::flat_buffer buffer_{16384};  // no more than that of a request
  Request request_;
  Response response_;
  std::string_view page_;
  std::string port_;  // as hosts are named: with it, but for that of all pages
  static constexpr std::uint16_t kPlainPort = 80;
};

}  // namespace

struct PageServer::State {
  asio::io_context context{1};
  Tcp::acceptor acceptor{context};
  asio::steady_timer pause{context};
  ServerPatience patience;

  void accept(std::string_view page) {
    acceptor.async_accept([this, page](const beast::error_code& error, Tcp::socket socket) {
      if (error) {
        accept_later(page);
        return;
      }
      const std::uint16_t port = acceptor.local_endpoint().port();
      std::make_shared<Connection>(std::move(socket), page, port, patience)->read();
      accept(page);
    });
  }

  // Where as many are open as may be, until some are closed.
  void accept_later(std::string_view page) {
    pause.expires_after(std::chrono::milliseconds(100));
    pause.async_wait([this, page](const beast::error_code&) { accept(page); });
  }
};

PageServer::PageServer(std::unique_ptr<State> state) : state_(std::move(state)) {
}
PageServer::PageServer(PageServer&&) noexcept = default;
PageServer& PageServer::operator=(PageServer&&) noexcept = default;
PageServer::~PageServer() = default;

Result<PageServer> PageServer::open(std::uint16_t port, const ServerPatience& patience) {
  auto state = std::make_unique<State>();
  state->patience = patience;
  beast::error_code error;
  const Tcp::endpoint here(asio::ip::address_v4::loopback(), port);
  state->acceptor.open(here.protocol(), error);
  if (!error) state->acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
  if (!error) state->acceptor.bind(here, error);
  if (!error) state->acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (error) {
    return Error{ErrorCode::kCannotOpen,
                 "cannot serve a page on 127.0.0.1" +
                     (port == 0 ? std::string() : ", port " + std::to_string(port)) + ": " +
                     error.message(),
                 {}};
  }
  return PageServer(std::move(state));
}

std::string PageServer::address() const {
  return "http://127.0.0.1:" + std::to_string(state_->acceptor.local_endpoint().port()) + "/";
}

void PageServer::serve(std::string_view page) {
  state_->accept(page);
  state_->context.run();
}

void PageServer::stop() {
  state_->context.stop();
}

}  // namespace beespace::cli
