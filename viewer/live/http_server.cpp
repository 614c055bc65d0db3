// HTTP with Boost.Asio: the only file that includes it. Feeds are sent in pieces as readers accept
// them, so a slow reader delays nothing but itself.
#include "viewer/live/http_server.h"

#include <fmt/format.h>
#include <openssl/crypto.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <iterator>
#include <list>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <utility>

#include "base/system/host.h"
#include "base/system/socket_address.h"
#include "viewer/live/http_request.h"

namespace cls::viewer {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using ErrorCode = boost::system::error_code;

constexpr std::chrono::seconds kRequestTimeout{10};
/// Without free file descriptors accepting fails until a connection ends.
constexpr std::chrono::milliseconds kAcceptRetry{100};

std::string random_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
  return token;
}

bool is_ip_address(const std::string& host) { return bool(base::parse_ip_address(host, 0)); }

// The host of a Host header, "[::1]:80" or "localhost:80". The port may be that of a tunnel.
std::string host_of(std::string_view header) {
  if (header.starts_with('[') && header.find(']') != std::string_view::npos) {
    return std::string(header.substr(1, header.find(']') - 1));
  }
  return std::string(header.substr(0, header.find(':')));
}

bool is_own_host(std::string_view header, const std::vector<std::string>& names) {
  const std::string host = host_of(header);
  const auto is_host = [&host](const std::string& name) {
    return equals_ignoring_case(host, name);
  };
  return is_ip_address(host) || is_host("localhost") ||
         (!host.empty() && is_host(base::host_name())) || std::ranges::any_of(names, is_host);
}

// "no-transform" and "q=0" aside: browsers that accept gzip say so in these letters.
bool accepts_gzip(std::string_view header) { return header.find("gzip") != header.npos; }

// The statuses of this server and its routes.
constexpr std::array<std::pair<int, std::string_view>, 9> kReasons = {
    {{200, "OK"},
     {302, "Found"},
     {304, "Not Modified"},
     {400, "Bad Request"},
     {403, "Forbidden"},
     {404, "Not Found"},
     {405, "Method Not Allowed"},
     {431, "Request Header Fields Too Large"},
     {503, "Service Unavailable"}}};

std::string_view reason_of(int status) {
  const auto row = std::ranges::find(kReasons, status, &std::pair<int, std::string_view>::first);
  return row == kReasons.end() ? "" : row->second;
}

HttpReply text_reply(int status, std::string text) {
  return {.status = status, .body = std::move(text)};
}

HttpReply redirection(std::string location) {
  return {.status = 302, .location = std::move(location)};
}

// The status line and the fields that all replies have.
std::string head_of(int status, const std::string& type, bool stored) {
  return fmt::format(
      "HTTP/1.1 {} {}\r\n"
      "Content-Type: {}\r\n"
      "Cache-Control: {}\r\n"
      "X-Content-Type-Options: nosniff\r\n"
      "X-Frame-Options: DENY\r\n"
      "Referrer-Policy: no-referrer\r\n"
      "Cross-Origin-Resource-Policy: same-origin\r\n"
      "Content-Security-Policy: frame-ancestors 'none'\r\n",
      status, reason_of(status), type, stored ? "no-cache" : "no-store");
}

}  // namespace

// Shared by the server and its sessions, which run on the server's thread only.
struct HttpServer::State {
  State(HttpRoutes given, std::string shown, HttpAccess allowed)
      : routes(std::move(given)), shown_host(std::move(shown)), access(std::move(allowed)) {}

  std::string listen(const HttpAddress& address);
  void accept_next();
  void begin_session(tcp::socket socket);
  bool make_room();
  bool redeem(std::string_view target);

  HttpRoutes routes;
  std::string shown_host;
  HttpAccess access;
  /// The start of the paths of all pages.
  std::string prefix = access.open ? access.prefix : "/" + random_token() + "/";

  std::mutex ticket_mutex;
  std::string ticket;  ///< of single_use_url(); empty: none or used

  /// Ends the sessions that make room for others, oldest first.
  std::list<std::function<void()>> strangers;
  std::atomic<std::size_t> connections{0};
  std::atomic<std::size_t> streams{0};

  asio::io_context io{1};  // sessions end with it, before what they use
  tcp::acceptor acceptor{io};
  asio::steady_timer accept_timer{io};
  std::thread thread;
};

class HttpServer::Session : public std::enable_shared_from_this<Session> {
 public:
  Session(tcp::socket socket, State& state)
      : socket_(std::move(socket)),
        deadline_(socket_.get_executor()),
        poll_(socket_.get_executor()),
        state_(state) {
    ++state_.connections;
  }
  ~Session() {
    --state_.connections;
    if (feed_ != nullptr) --state_.streams;
    leave_strangers();
  }

  // Others may take its place: until it has sent the token, or while it waits for a request.
  void enter_as_stranger() {
    if (entry_) return;
    state_.strangers.push_back([weak = weak_from_this()] {
      const auto self = weak.lock();
      if (self == nullptr) return;
      self->leave_strangers();
      self->close();
    });
    entry_ = std::prev(state_.strangers.end());
  }

  void read_request() {
    if (state_.access.open) enter_as_stranger();
    close_after(kRequestTimeout);
    read_more();
  }

  void refuse_as_busy() { refuse(503, "too many viewers\n"); }

 private:
  void leave_strangers() {
    if (entry_) state_.strangers.erase(*entry_);
    entry_.reset();
  }

  // Ends the connection unless what begins now is done by then.
  void close_after(std::chrono::milliseconds timeout) {
    deadline_.expires_after(timeout);
    deadline_.async_wait([weak = weak_from_this()](ErrorCode stopped) {
      const auto self = weak.lock();
      if (!stopped && self != nullptr) self->close();
    });
  }

  // The bytes of the last read may hold the next request, too.
  void read_more() {
    const ParsedRequest parsed = parse_request(received_);
    switch (parsed.state) {
      case ParsedRequest::State::kWhole:
        answer(parsed.request);
        received_.erase(0, parsed.size);
        return;
      case ParsedRequest::State::kTooLong:
        return refuse(431, "the header is too large\n");
      case ParsedRequest::State::kBad:
        return refuse(400, "no HTTP request\n");
      case ParsedRequest::State::kIncomplete:
        break;
    }

    socket_.async_read_some(asio::buffer(block_),
                            [self = shared_from_this()](ErrorCode error, std::size_t size) {
                              if (error == asio::error::eof && !self->received_.empty()) {
                                return self->refuse(400, "no HTTP request\n");
                              }
                              if (error) return self->close();
                              self->received_.append(self->block_.data(), size);
                              self->read_more();
                            });
  }

  void answer(const HttpRequest& request) {
    const bool head = request.method == "HEAD";
    if (!head && request.method != "GET") return refuse(405, "GET and HEAD only\n");
    if (!is_own_host(request.field("Host"), state_.access.names)) {
      return refuse(
          403, "unknown host; --host-name NAME of the command that serves this page allows it\n");
    }
    if (!head && state_.redeem(request.target)) {
      return send_text(redirection(state_.prefix), {}, false, false);
    }

    // The body of a request is not read, so nothing may follow it.
    HttpReply reply = route(request.target);
    if (reply.feed != nullptr && !head) return send_feed(std::move(reply));
    send_text(std::move(reply), request, head, request.keeps_connection);
  }

  HttpReply route(std::string_view target) {
    const std::string& prefix = state_.prefix;
    if (state_.access.open && target.size() + 1 == prefix.size() && prefix.starts_with(target)) {
      return redirection(prefix);
    }
    if (target.size() < prefix.size() ||
        CRYPTO_memcmp(target.data(), prefix.data(), prefix.size()) != 0) {
      return text_reply(404, "not found\n");
    }

    leave_strangers();
    target.remove_prefix(prefix.size());

    const std::size_t mark = std::min(target.find('?'), target.size());
    const std::string_view query = mark < target.size() ? target.substr(mark + 1) : "";
    return state_.routes(target.substr(0, mark), query);
  }

  void refuse(int status, std::string text) {
    send_text(text_reply(status, std::move(text)), {}, false, false);
  }

  // The bytes of the document to send: none to readers that have this version already.
  std::string_view chosen_version(const HttpRequest& request, int& status, std::string& fields) {
    const std::string tag = fmt::format("W/\"{}\"", document_->tag);
    fields = fmt::format("ETag: {}\r\nVary: Accept-Encoding\r\n", tag);
    if (request.field("If-None-Match") == tag) {
      status = 304;
      return {};
    }

    if (!accepts_gzip(request.field("Accept-Encoding"))) return document_->text;
    fields += "Content-Encoding: gzip\r\n";
    return document_->packed;
  }

  void send_text(HttpReply reply, const HttpRequest& request, bool head, bool keep) {
    body_ = std::move(reply.body);
    document_ = std::move(reply.document);
    int status = reply.status;
    std::string fields;
    const std::string_view body =
        document_ == nullptr ? body_ : chosen_version(request, status, fields);

    head_ = head_of(status, reply.type, document_ != nullptr);
    if (!reply.location.empty()) head_ += fmt::format("Location: {}\r\n", reply.location);
    if (status == 405) head_ += "Allow: GET, HEAD\r\n";
    head_ += fields;
    if (!keep) head_ += "Connection: close\r\n";
    if (reply.feed == nullptr && status != 304) {
      head_ += fmt::format("Content-Length: {}\r\n", body.size());
    }
    head_ += "\r\n";

    send(head ? std::string_view() : body, "",
         [keep](Session& self) { keep ? self.read_request() : self.close(); });
  }

  // Writes head_, then `bytes` and `end`, then calls `next`. All of them must stay until then.
  template <typename Next>
  void send(std::string_view bytes, std::string_view end, Next next) {
    close_after(state_.access.write_timeout);
    const std::array<asio::const_buffer, 3> parts = {asio::buffer(head_), asio::buffer(bytes),
                                                     asio::buffer(end)};
    asio::async_write(socket_, parts,
                      [self = shared_from_this(), next](ErrorCode error, std::size_t) {
                        if (error) return self->close();
                        self->deadline_.cancel();
                        next(*self);
                      });
  }

  void send_feed(HttpReply reply) {
    feed_ = std::move(reply.feed);
    from_ = reply.from;
    ++state_.streams;

    // Proxies that know X-Accel-Buffering send pieces as they come.
    head_ = head_of(200, reply.type, false) +
            "Transfer-Encoding: chunked\r\nX-Accel-Buffering: no\r\nConnection: close\r\n\r\n";
    send("", "", [](Session& self) {
      self.watch_reader();
      self.send_piece();
    });
  }

  // A reader of a feed sends nothing more: readable means gone.
  void watch_reader() {
    socket_.async_wait(tcp::socket::wait_read,
                       [self = shared_from_this()](ErrorCode) { self->close(); });
  }

  void send_piece() {
    if (closed_) return;
    LiveFeed::Piece piece = feed_->read(from_, state_.access.piece);
    if (piece.bytes.empty() && !piece.ended) return wait_for_bytes();

    from_ += piece.bytes.size();
    body_ = std::move(piece.bytes);
    head_ = fmt::format("{:x}\r\n", body_.size());
    send(body_, "\r\n",
         [](Session& self) { self.body_.empty() ? self.close() : self.send_piece(); });
  }

  void wait_for_bytes() {
    poll_.expires_after(state_.access.feed_interval);
    poll_.async_wait([self = shared_from_this()](ErrorCode stopped) {
      if (!stopped) self->send_piece();
    });
  }

  void close() {
    closed_ = true;
    ErrorCode ignored;
    deadline_.cancel();
    poll_.cancel();
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
    socket_.close(ignored);
  }

  tcp::socket socket_;
  asio::steady_timer deadline_;
  asio::steady_timer poll_;  // of a feed that has no bytes now
  State& state_;

  std::array<char, 2 * kMaxRequestHead> block_;
  std::string received_;

  std::string head_;
  std::string body_;
  std::shared_ptr<const HttpDocument> document_;
  std::shared_ptr<const LiveFeed> feed_;
  std::size_t from_ = 0;

  std::optional<std::list<std::function<void()>>::iterator> entry_;
  bool closed_ = false;
};

// Whether `target` is the ticket, which is used up then.
bool HttpServer::State::redeem(std::string_view target) {
  const std::lock_guard lock(ticket_mutex);
  const bool same = !ticket.empty() && target.size() == ticket.size() + 1 &&
                    CRYPTO_memcmp(target.data() + 1, ticket.data(), ticket.size()) == 0;
  if (same) ticket.clear();
  return same;
}

// False if all connections are of viewers.
bool HttpServer::State::make_room() {
  if (strangers.empty()) return false;
  const auto give_way = strangers.front();  // a copy, because the entry is removed
  give_way();
  return true;
}

void HttpServer::State::begin_session(tcp::socket socket) {
  if (access.send_buffer > 0) {
    ErrorCode ignored;
    socket.set_option(asio::socket_base::send_buffer_size(access.send_buffer), ignored);
  }

  const bool full = connections.load() >= access.max_connections;
  const bool busy = full && !make_room();
  const auto session = std::make_shared<Session>(std::move(socket), *this);
  if (!busy) session->enter_as_stranger();
  busy ? session->refuse_as_busy() : session->read_request();
}

void HttpServer::State::accept_next() {
  acceptor.async_accept([this](ErrorCode error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      begin_session(std::move(socket));
      return accept_next();
    }

    accept_timer.expires_after(kAcceptRetry);
    accept_timer.async_wait([this](ErrorCode stopped) {
      if (!stopped) accept_next();
    });
  });
}

// Returns the error, empty if there is none.
std::string HttpServer::State::listen(const HttpAddress& address) {
  ErrorCode error;
  const auto ip = asio::ip::make_address(address.host, error);
  if (error) return "not an IP address of this host";

  const tcp::endpoint endpoint(ip, static_cast<unsigned short>(address.port));
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(tcp::acceptor::max_listen_connections, error);

  return error ? error.message() : "";
}

base::Result<std::unique_ptr<HttpServer>> HttpServer::start(const HttpAddress& address,
                                                            HttpRoutes routes, HttpAccess access) {
  auto state = std::make_unique<State>(std::move(routes), address.host, std::move(access));
  if (const std::string error = state->listen(address); !error.empty()) {
    return base::Error{
        fmt::format("cannot listen on {} port {}: {}", address.host, address.port, error)};
  }

  state->accept_next();
  state->thread = std::thread([io = &state->io] { io->run(); });
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(state)));
}

HttpServer::HttpServer(std::unique_ptr<State> state) : state_(std::move(state)) {}

HttpServer::~HttpServer() {
  state_->io.stop();
  state_->thread.join();
}

int HttpServer::port() const {
  ErrorCode ignored;
  return state_->acceptor.local_endpoint(ignored).port();
}

std::string HttpServer::url() const {
  std::string host = state_->shown_host;
  if (host == "0.0.0.0" || host == "::") host = base::host_name();
  return fmt::format("http://{}:{}{}", base::with_brackets(host), port(), state_->prefix);
}

std::string HttpServer::single_use_url() {
  const std::string whole = url();
  const std::lock_guard lock(state_->ticket_mutex);
  state_->ticket = random_token();
  return whole.substr(0, whole.size() - state_->prefix.size() + 1) + state_->ticket;
}

std::size_t HttpServer::streams() const { return state_->streams.load(); }

std::size_t HttpServer::connections() const { return state_->connections.load(); }

}  // namespace cls::viewer
