// Reads responses by the end of the connection or the chunks of their bodies.
#include "tests/support/http_client.h"

#include <poll.h>
#include <sys/socket.h>

#include <chrono>
#include <cstdlib>

#include "base/system/tcp_connect.h"

namespace cls::tests {
namespace {

constexpr std::chrono::seconds kTimeout{10};

auto deadline() { return std::chrono::steady_clock::now() + kTimeout; }

std::string without_chunks(const std::string& body) {
  std::string text;
  for (std::size_t at = 0; at < body.size();) {
    const std::size_t line = body.find("\r\n", at);
    const std::size_t size = std::strtoul(body.c_str() + at, nullptr, 16);
    if (line == std::string::npos || size == 0) break;
    text += body.substr(line + 2, size);
    at = line + 2 + size + 2;
  }
  return text;
}

}  // namespace

HttpConnection::HttpConnection(int port) : fd_(base::connect_tcp("127.0.0.1", port, deadline())) {}

void HttpConnection::send(const std::string& bytes) const {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(fd_.get(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (!base::wait_for_events(fd_.get(), POLLOUT, deadline())) {
      return;
    }
  }
}

std::string HttpConnection::receive(std::size_t size) const {
  std::string bytes(size, '\0');
  if (!base::wait_for_events(fd_.get(), POLLIN, deadline())) return "";
  const ssize_t count = ::recv(fd_.get(), bytes.data(), bytes.size(), 0);
  bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return bytes;
}

HttpResponse HttpConnection::response() const {
  std::string all;
  for (std::string bytes = receive(); !bytes.empty(); bytes = receive()) all += bytes;
  HttpResponse response;
  const std::size_t end = all.find("\r\n\r\n");
  if (end == std::string::npos || !all.starts_with("HTTP/1.1 ")) return response;
  response.status = std::atoi(all.c_str() + 9);
  response.header = all.substr(0, end);
  response.body = all.substr(end + 4);
  if (response.header.find("Transfer-Encoding: chunked") != std::string::npos) {
    response.body = without_chunks(response.body);
  }
  return response;
}

HttpResponse exchange(int port, const std::string& request) {
  const HttpConnection connection(port);
  connection.send(request);
  return connection.response();
}

HttpResponse get(const std::string& url) {
  return exchange(port_of(url), "GET " + path_of(url) +
                                    " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
}

int port_of(const std::string& url) {
  return std::atoi(url.c_str() + url.find(':', url.find("//")) + 1);
}

std::string path_of(const std::string& url) {
  return url.substr(url.find('/', url.find("//") + 2));
}

}  // namespace cls::tests
