// HTTP with Boost.Beast: the only file that includes it. Feeds are sent in pieces as readers accept
// them, so a slow reader delays nothing but itself.
#include "viewer/live/http_server.h"

#include <fmt/format.h>
#include <openssl/crypto.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <functional>
#include <iterator>
#include <list>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <thread>
#include <utility>

#include "base/system/host.h"
#include "base/system/socket_address.h"

namespace cls::viewer {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using ErrorCode = boost::system::error_code;

constexpr std::size_t kMaxHeader = 8 * 1024;
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
  const auto is_host = [&host](const std::string& name) { return beast::iequals(host, name); };
  return is_ip_address(host) || is_host("localhost") ||
         (!host.empty() && is_host(base::host_name())) ||
         std::any_of(names.begin(), names.end(), is_host);
}

// "no-transform" and "q=0" aside: browsers that accept gzip say so in these letters.
bool accepts_gzip(std::string_view header) { return header.find("gzip") != header.npos; }

}  // namespace

// What the server and its sessions share. Sessions run on the server's thread only.
struct HttpServer::State {
  State(HttpRoutes given, std::string shown, HttpAccess allowed)
      : routes(std::move(given)), shown_host(std::move(shown)), access(std::move(allowed)) {}

  HttpRoutes routes;
  std::string shown_host;
  HttpAccess access;
  /// What the paths of all pages begin with.
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

  // Whether `target` is the ticket, which is used up then.
  bool redeem(std::string_view target) {
    const std::lock_guard lock(ticket_mutex);
    const bool same = !ticket.empty() && target.size() == ticket.size() + 1 &&
                      CRYPTO_memcmp(target.data() + 1, ticket.data(), ticket.size()) == 0;
    if (same) ticket.clear();
    return same;
  }
};

namespace {

template <typename State>
class Session : public std::enable_shared_from_this<Session<State>> {
 public:
  Session(tcp::socket socket, State& state)
      : stream_(std::move(socket)), timer_(stream_.get_executor()), state_(state) {
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
    state_.strangers.push_back([weak = this->weak_from_this()] {
      const auto self = weak.lock();
      if (self == nullptr) return;
      self->leave_strangers();
      self->close();
    });
    entry_ = std::prev(state_.strangers.end());
  }

  void read_request() {
    if (state_.access.open) enter_as_stranger();
    parser_.emplace();
    parser_->header_limit(kMaxHeader);

    stream_.expires_after(kRequestTimeout);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = this->shared_from_this()](ErrorCode error, std::size_t) {
                              self->on_request(error);
                            });
  }

  void refuse_as_busy() { send_text({503, "", "too many viewers\n", nullptr, 0}, false, false); }

 private:
  void leave_strangers() {
    if (entry_) state_.strangers.erase(*entry_);
    entry_.reset();
  }

  void on_request(ErrorCode error) {
    if (error == http::error::header_limit) return refuse(431, "the header is too large\n");
    if (error == http::error::end_of_stream || error == beast::error::timeout) return close();
    if (error.category() == http::make_error_code(http::error::bad_method).category()) {
      return refuse(400, "no HTTP request\n");
    }
    if (error) return close();

    const auto& request = parser_->get();
    const bool head = request.method() == http::verb::head;
    if (!head && request.method() != http::verb::get) return refuse(405, "GET and HEAD only\n");

    // The body of a request is not read, so nothing may follow it.
    const bool keep = request.keep_alive() && parser_->is_done();
    if (!is_own_host(view(request[http::field::host]), state_.access.names)) {
      return refuse(403, "unknown host\n");
    }
    if (!head && state_.redeem(view(request.target()))) return redirect();
    reply(route(view(request.target())), head, keep);
  }

  static std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

  HttpReply route(std::string_view target) {
    const std::string& prefix = state_.prefix;
    if (state_.access.open && target.size() + 1 == prefix.size() && prefix.starts_with(target)) {
      return {302, HttpReply().type, "", nullptr, 0, nullptr, prefix};
    }
    if (target.size() < prefix.size() ||
        CRYPTO_memcmp(target.data(), prefix.data(), prefix.size()) != 0) {
      return {404, HttpReply().type, "not found\n", nullptr, 0};
    }

    leave_strangers();
    target.remove_prefix(prefix.size());

    const std::size_t mark = std::min(target.find('?'), target.size());
    const std::string_view query = mark < target.size() ? target.substr(mark + 1) : "";
    return state_.routes(target.substr(0, mark), query);
  }

  void reply(HttpReply reply, bool head, bool keep) {
    if (reply.feed == nullptr || head) return send_text(std::move(reply), head, keep);
    send_feed(std::move(reply));
  }

  void redirect() {
    send_text({302, HttpReply().type, "", nullptr, 0, nullptr, state_.prefix}, false, false);
  }

  void refuse(int status, std::string text) {
    send_text({status, HttpReply().type, std::move(text), nullptr, 0}, false, false);
  }

  template <typename Message>
  void set_fields(Message& message, const std::string& type, bool stored = false) {
    message.set(http::field::content_type, type);
    message.set(http::field::cache_control, stored ? "no-cache" : "no-store");
    message.set("X-Content-Type-Options", "nosniff");
    message.set("X-Frame-Options", "DENY");
    message.set("Referrer-Policy", "no-referrer");
    message.set("Cross-Origin-Resource-Policy", "same-origin");
    message.set("Content-Security-Policy", "frame-ancestors 'none'");
  }

  // What of the reply goes out: nothing to readers that have this version already.
  std::string_view chosen_body(HttpReply& reply) {
    body_ = std::move(reply.body);
    document_ = std::move(reply.document);
    if (document_ == nullptr) return body_;

    const auto& request = parser_->get();
    const std::string tag = fmt::format("W/\"{}\"", document_->tag);
    text_->set(http::field::etag, tag);
    text_->set(http::field::vary, "Accept-Encoding");
    if (view(request[http::field::if_none_match]) == tag) {
      text_->result(http::status::not_modified);
      return {};
    }
    if (!accepts_gzip(view(request[http::field::accept_encoding]))) return document_->text;
    text_->set(http::field::content_encoding, "gzip");
    return document_->packed;
  }

  void send_text(HttpReply reply, bool head, bool keep) {
    text_.emplace(static_cast<http::status>(reply.status), 11);
    set_fields(*text_, reply.type, reply.document != nullptr);
    if (!reply.location.empty()) text_->set(http::field::location, reply.location);
    if (reply.status == 405) text_->set(http::field::allow, "GET, HEAD");

    const std::string_view body = chosen_body(reply);
    text_->keep_alive(keep);
    if (reply.feed == nullptr && text_->result() != http::status::not_modified) {
      text_->content_length(body.size());
    }
    if (!head) text_->body() = boost::beast::span<const char>(body.data(), body.size());

    serializer_.emplace(*text_);
    if (head) serializer_->split(true);
    stream_.expires_after(state_.access.write_timeout);

    const auto sent = [self = this->shared_from_this(), keep](ErrorCode error, std::size_t) {
      if (error || !keep) return self->close();
      self->read_request();
    };
    if (head) {
      http::async_write_header(stream_, *serializer_, sent);
    } else {
      http::async_write(stream_, *serializer_, sent);
    }
  }

  void send_feed(HttpReply reply) {
    feed_ = std::move(reply.feed);
    from_ = reply.from;
    ++state_.streams;

    head_.emplace(http::status::ok, 11);
    set_fields(*head_, reply.type);
    head_->chunked(true);
    head_->set("X-Accel-Buffering", "no");  // proxies of this kind send pieces as they come
    head_->keep_alive(false);

    head_serializer_.emplace(*head_);
    stream_.expires_after(state_.access.write_timeout);
    http::async_write_header(stream_, *head_serializer_,
                             [self = this->shared_from_this()](ErrorCode error, std::size_t) {
                               if (error) return self->close();
                               self->watch_reader();
                               self->send_piece();
                             });
  }

  // A reader of a feed sends nothing more: readable means gone.
  void watch_reader() {
    stream_.socket().async_wait(tcp::socket::wait_read,
                                [self = this->shared_from_this()](ErrorCode) { self->close(); });
  }

  void send_piece() {
    if (closed_) return;
    LiveFeed::Piece piece = feed_->read(from_, state_.access.piece);
    if (piece.bytes.empty() && !piece.ended) return wait_for_bytes();

    from_ += piece.bytes.size();
    piece_ = std::move(piece.bytes);
    stream_.expires_after(state_.access.write_timeout);

    const auto sent = [self = this->shared_from_this()](ErrorCode error, std::size_t) {
      error || self->piece_.empty() ? self->close() : self->send_piece();
    };
    if (piece_.empty()) {
      asio::async_write(stream_, http::make_chunk_last(), sent);
    } else {
      asio::async_write(stream_, http::make_chunk(asio::buffer(piece_)), sent);
    }
  }

  void wait_for_bytes() {
    timer_.expires_after(state_.access.feed_interval);
    timer_.async_wait([self = this->shared_from_this()](ErrorCode error) {
      if (!error) self->send_piece();
    });
  }

  void close() {
    closed_ = true;
    ErrorCode ignored;
    timer_.cancel();
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    stream_.close();
  }

  beast::tcp_stream stream_;
  asio::steady_timer timer_;
  State& state_;

  beast::flat_buffer buffer_{2 * kMaxHeader};
  std::optional<http::request_parser<http::empty_body>> parser_;

  using TextBody = http::span_body<const char>;
  std::string body_;
  std::shared_ptr<const HttpDocument> document_;
  std::optional<http::response<TextBody>> text_;
  std::optional<http::response_serializer<TextBody>> serializer_;

  std::optional<http::response<http::empty_body>> head_;
  std::optional<http::response_serializer<http::empty_body>> head_serializer_;

  std::shared_ptr<const LiveFeed> feed_;
  std::size_t from_ = 0;
  std::string piece_;

  std::optional<std::list<std::function<void()>>::iterator> entry_;
  bool closed_ = false;
};

// False if all connections are of viewers.
template <typename State>
bool make_room(State& state) {
  if (state.strangers.empty()) return false;
  const auto give_way = state.strangers.front();  // a copy, because the entry is removed
  give_way();
  return true;
}

template <typename State>
void accept_next(State& state);

template <typename State>
void begin_session(tcp::socket socket, State& state) {
  const HttpAccess& access = state.access;
  if (access.send_buffer > 0) {
    ErrorCode ignored;
    socket.set_option(asio::socket_base::send_buffer_size(access.send_buffer), ignored);
  }

  const bool full = state.connections.load() >= access.max_connections;
  const bool busy = full && !make_room(state);
  const auto session = std::make_shared<Session<State>>(std::move(socket), state);
  if (!busy) session->enter_as_stranger();
  busy ? session->refuse_as_busy() : session->read_request();
}

template <typename State>
void accept_next(State& state) {
  state.acceptor.async_accept([&state](ErrorCode error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      begin_session(std::move(socket), state);
      return accept_next(state);
    }

    state.accept_timer.expires_after(kAcceptRetry);
    state.accept_timer.async_wait([&state](ErrorCode stopped) {
      if (!stopped) accept_next(state);
    });
  });
}

// Listens; returns the error, empty if there is none.
std::string listen(tcp::acceptor& acceptor, const HttpAddress& address) {
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

}  // namespace

base::Result<std::unique_ptr<HttpServer>> HttpServer::start(const HttpAddress& address,
                                                            HttpRoutes routes, HttpAccess access) {
  auto state = std::make_unique<State>(std::move(routes), address.host, std::move(access));
  if (const std::string error = listen(state->acceptor, address); !error.empty()) {
    return base::Error{
        fmt::format("cannot listen on {} port {}: {}", address.host, address.port, error)};
  }

  accept_next(*state);
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
  if (host.find(':') != std::string::npos) host = fmt::format("[{}]", host);
  return fmt::format("http://{}:{}{}", host, port(), state_->prefix);
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
