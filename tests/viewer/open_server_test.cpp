// The HTTP server without a secret path: what it promises to everyone who reaches it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/http_client.h"
#include "viewer/live/http_server.h"
#include "viewer/live/live_feed.h"
#include "viewer/page/encoding.h"

namespace cls::viewer {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using testing::HasSubstr;
using testing::Not;
using tests::exchange;
using tests::get;

constexpr std::chrono::seconds kEnough{20};

class OpenServer : public testing::Test {
 protected:
  void serve(HttpAccess access) {
    access.open = true;
    auto started = HttpServer::start(
        {}, [this](auto path, auto) { return reply(path); }, access);
    ASSERT_TRUE(started) << started.error().message;
    server_ = *std::move(started);
  }

  HttpReply reply(std::string_view path) const {
    if (path.empty()) return {.status = 200, .document = document_};
    if (path == "live") return {.status = 200, .feed = feed_};
    return {};
  }

  std::string request(const std::string& target, const std::string& more = "",
                      const std::string& host = "127.0.0.1") const {
    return fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n{}Connection: close\r\n\r\n", target, host,
                       more);
  }
  tests::HttpResponse ask(const std::string& target, const std::string& more = "",
                          const std::string& host = "127.0.0.1") const {
    return exchange(server_->port(), request(target, more, host));
  }

  bool eventually(std::size_t (HttpServer::*count)() const, std::size_t wanted) const {
    const auto end = steady_clock::now() + kEnough;
    while ((server_.get()->*count)() != wanted && steady_clock::now() < end) {
      std::this_thread::sleep_for(milliseconds(5));
    }
    return (server_.get()->*count)() == wanted;
  }

  std::shared_ptr<LiveFeed> feed_ = std::make_shared<LiveFeed>();
  std::shared_ptr<const HttpDocument> document_ =
      std::make_shared<const HttpDocument>(HttpDocument{"<p>cup</p>", gzip("<p>cup</p>"), "v1"});
  std::unique_ptr<HttpServer> server_;
};

TEST_F(OpenServer, NeedsNoToken) {
  serve({});
  EXPECT_EQ(server_->url(), fmt::format("http://127.0.0.1:{}/", server_->port()));
  const auto page = get(server_->url());
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.body, "<p>cup</p>");
  EXPECT_EQ(ask("/cls.toml").status, 404);
  EXPECT_EQ(ask("/../cls.toml").status, 404);
}

TEST_F(OpenServer, StaysBelowItsPrefix) {
  serve({.prefix = "/cup/"});
  EXPECT_EQ(ask("/cup/").body, "<p>cup</p>");
  EXPECT_EQ(ask("/").status, 404);
  const auto moved = ask("/cup");
  EXPECT_EQ(moved.status, 302);
  EXPECT_THAT(moved.header, HasSubstr("Location: /cup/\r\n"));
}

TEST_F(OpenServer, AnswersToItsOwnAndGivenNamesOnly) {
  serve({.names = {"cup.example.org"}});
  EXPECT_EQ(ask("/", "", "cup.example.org").status, 200);
  EXPECT_EQ(ask("/", "", "cup.example.org:443").status, 200);
  EXPECT_EQ(ask("/", "", "evil.example.org").status, 403);
  EXPECT_EQ(ask("/", "X-Forwarded-Host: cup.example.org\r\n", "evil.example.org").status, 403);
}

TEST_F(OpenServer, DoesNotReadForwardedHeaders) {
  serve({});
  const auto plain = ask("/");
  const auto forwarded = ask("/",
                             "X-Forwarded-For: 10.0.0.1\r\nX-Forwarded-Proto: https\r\n"
                             "X-Forwarded-Prefix: /other\r\nForwarded: host=evil\r\n");
  EXPECT_EQ(forwarded.header, plain.header);
  EXPECT_EQ(forwarded.body, plain.body);
}

TEST_F(OpenServer, SendsAVersionOnceAndCompressedToThoseThatAccept) {
  serve({});
  const auto first = ask("/", "Accept-Encoding: br, gzip\r\n");
  EXPECT_THAT(first.header, HasSubstr("Content-Encoding: gzip\r\n"));
  EXPECT_THAT(first.header, HasSubstr("ETag: W/\"v1\"\r\n"));
  EXPECT_EQ(*gunzip(first.body, 1000), "<p>cup</p>");
  const auto again = ask("/", "If-None-Match: W/\"v1\"\r\n");
  EXPECT_EQ(again.status, 304);
  EXPECT_EQ(again.body, "");
  EXPECT_EQ(ask("/", "If-None-Match: W/\"v0\"\r\n").body, "<p>cup</p>");
}

TEST_F(OpenServer, RefusesToChangeAnything) {
  serve({});
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH", "OPTIONS"}) {
    const auto refused = exchange(
        server_->port(),
        fmt::format("{} / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 0\r\n\r\n", method));
    EXPECT_EQ(refused.status, 405) << method;
  }
}

TEST_F(OpenServer, ConnectionsThatAskNothingMakeRoom) {
  serve({.max_connections = 4});
  std::vector<std::unique_ptr<tests::HttpConnection>> idle;
  for (int i = 0; i < 12; ++i) {
    idle.push_back(std::make_unique<tests::HttpConnection>(server_->port()));
    idle.back()->send(i % 2 == 0 ? "GET / HT" : "");
  }

  EXPECT_EQ(ask("/").status, 200);

  // One that has been served and waits for its next request, too.
  const tests::HttpConnection served(server_->port());
  served.send("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");

  EXPECT_NE(served.receive(), "");

  for (int i = 0; i < 8; ++i) {
    idle.push_back(std::make_unique<tests::HttpConnection>(server_->port()));
  }

  EXPECT_EQ(ask("/").status, 200);
}

TEST_F(OpenServer, RefusesMoreStreamsThanConnections) {
  serve({.max_connections = 4});
  feed_->append("x");
  std::vector<std::unique_ptr<tests::HttpConnection>> readers;
  for (int i = 0; i < 4; ++i) {
    readers.push_back(std::make_unique<tests::HttpConnection>(server_->port()));
    readers.back()->send(request("/live"));
    EXPECT_NE(readers.back()->receive(), "");
  }
  const int refused = ask("/").status;

  EXPECT_TRUE(refused == 503 || refused == 0) << refused;

  readers.clear();
  EXPECT_TRUE(eventually(&HttpServer::streams, 0));
  EXPECT_EQ(ask("/").status, 200);
}

TEST_F(OpenServer, EndsReadersThatDoNotRead) {
  serve({.write_timeout = milliseconds(300),
         .piece = std::size_t{32} << 10,
         .send_buffer = 32 << 10});
  feed_->append(std::string(std::size_t{16} << 20, 'x'));
  const tests::HttpConnection stalled(server_->port());
  stalled.send(request("/live"));
  ASSERT_TRUE(eventually(&HttpServer::streams, 1));
  EXPECT_TRUE(eventually(&HttpServer::streams, 0));
  EXPECT_TRUE(eventually(&HttpServer::connections, 0));
}

}  // namespace
}  // namespace cls::viewer
