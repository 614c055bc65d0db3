// A plain HTTP client that sends what a test wants, correct or not.
#pragma once

#include <string>

#include "base/system/unique_fd.h"

namespace cls::tests {

struct HttpResponse {
  int status = 0;      ///< 0: the connection ended without a response
  std::string header;  ///< with the status line
  std::string body;    ///< decoded if it is chunked
};

/// A connection to 127.0.0.1.
class HttpConnection {
 public:
  explicit HttpConnection(int port);

  bool connected() const { return bool(fd_); }
  void send(const std::string& bytes) const;
  /// Up to `size` bytes; empty at the end of the connection, or after ten seconds without one.
  std::string receive(std::size_t size = 65536) const;
  /// Everything until the end of the connection.
  HttpResponse response() const;

 private:
  base::UniqueFd fd_;
};

/// Sends `request` and reads the response until the connection ends.
HttpResponse exchange(int port, const std::string& request);

/// GET of "http://127.0.0.1:PORT/PATH".
HttpResponse get(const std::string& url);

/// The port of such a URL, and its path.
int port_of(const std::string& url);
std::string path_of(const std::string& url);

}  // namespace cls::tests
