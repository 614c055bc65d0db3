// A small HTTP server for viewers: of this host, or for everyone.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "viewer/live/live_feed.h"

namespace cls::viewer {

/// A page that many readers share. Readers that have this version get none of its bytes.
struct HttpDocument {
  std::string text;
  std::string packed;  ///< the same, compressed with gzip
  std::string tag;     ///< of the version, without quotes
};

struct HttpReply {
  int status = 404;
  std::string type = "text/plain; charset=utf-8";
  std::string body = {};
  /// If set, the body is this feed from the offset `from` on, until it ends.
  std::shared_ptr<const LiveFeed> feed = {};
  std::size_t from = 0;
  /// If set, the body is this document.
  std::shared_ptr<const HttpDocument> document = {};
  /// If not empty, the reader is sent to this address, relative to its own.
  std::string location = {};
};

/// The reply to a path below the token ("", "live") and its query ("from=12"). Called by the
/// server's thread; must not throw. No path may become the name of a file.
using HttpRoutes = std::function<HttpReply(std::string_view path, std::string_view query)>;

struct HttpAddress {
  std::string host = "127.0.0.1";  ///< an IP address; "0.0.0.0": all of this host
  int port = 0;                    ///< 0: a free port
};

/// Rights of readers, and the share of this process that they may use.
struct HttpAccess {
  /// Without a secret path: for everyone who reaches the address.
  bool open = false;
  /// The path that takes the place of the token: "/" or "/cup/". Open servers only.
  std::string prefix = "/";
  /// Names in Host headers in addition to those of this host.
  std::vector<std::string> names = {};
  std::size_t max_connections = 64;
  /// A piece or page that a reader has not accepted after this time ends its connection.
  std::chrono::milliseconds write_timeout{60'000};
  /// How often the server looks for new bytes of a feed.
  std::chrono::milliseconds feed_interval{20};
  /// Bytes of a feed for one write, and in the kernel's queue for one reader; 0: as it decides.
  std::size_t piece = std::size_t{64} * 1024;
  int send_buffer = 0;
};

/// Serves GET and HEAD, by default under a secret path, so that other users of the host cannot
/// watch. It answers only requests whose Host header is an IP address, localhost or a name of this
/// host: pages of other sites cannot reach it by a name of their own. One thread. When there are
/// as many connections as HttpAccess allows, those that have not sent the secret path yet make room
/// for others; of an open server those that wait for their next request. What a proxy writes into
/// headers (X-Forwarded-For and the like) is not read.
class HttpServer {
 public:
  /// The error names address and port.
  static base::Result<std::unique_ptr<HttpServer>> start(const HttpAddress& address,
                                                         HttpRoutes routes, HttpAccess access = {});
  /// Closes all connections.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;
  /// "http://127.0.0.1:PORT/TOKEN/", of an open server with its prefix.
  std::string url() const;
  /// An address that redirects to url() once, for places that others can read, such as the
  /// arguments of a process. A further call invalidates the earlier one.
  std::string single_use_url();
  /// Connections that still receive a feed.
  std::size_t streams() const;
  std::size_t connections() const;

 private:
  class Session;
  struct State;
  explicit HttpServer(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace cls::viewer
