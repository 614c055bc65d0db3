// A small HTTP server for viewers on this host.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "viewer/live/live_feed.h"

namespace cls::viewer {

struct HttpReply {
  int status = 404;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  /// If set, the body is this feed from the offset `from` on, until it ends.
  std::shared_ptr<const LiveFeed> feed;
  std::size_t from = 0;
};

/// The reply to a path below the token ("", "live") and its query ("from=12"). Called by the
/// server's thread; must not throw. No path may become the name of a file.
using HttpRoutes = std::function<HttpReply(std::string_view path, std::string_view query)>;

struct HttpAddress {
  std::string host = "127.0.0.1";  ///< an IP address; "0.0.0.0": all of this host
  int port = 0;                    ///< 0: a free port
};

/// Serves GET and HEAD under a secret path, so that other users of the host cannot watch. It
/// answers only requests whose Host header is an IP address, localhost or the name of this host:
/// pages of other sites cannot reach it by a name of their own. One thread; at most 64 connections,
/// of which those that have not sent the secret path yet make room for others.
class HttpServer {
 public:
  /// The error names address and port.
  static base::Result<std::unique_ptr<HttpServer>> start(const HttpAddress& address,
                                                         HttpRoutes routes);
  /// Closes all connections.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;
  /// "http://127.0.0.1:PORT/TOKEN/"
  std::string url() const;
  /// An address that redirects to url() once, for places that others can read, such as the
  /// arguments of a process. A further call invalidates the earlier one.
  std::string single_use_url();
  /// Connections that still receive a feed.
  std::size_t streams() const;

 private:
  struct State;
  explicit HttpServer(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace cls::viewer
