// Heads of requests: whole, in pieces, and what is none.
#include "viewer/live/http_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cls::viewer {
namespace {

using State = ParsedRequest::State;

const std::string kHead =
    "GET /live?from=2 HTTP/1.1\r\nHost: a:80\r\nX-Empty:\r\nX: \t b c \r\n\r\n";

TEST(HttpRequest, IsReadWhereverItsBytesAreCut) {
  for (std::size_t size = 0; size < kHead.size(); ++size) {
    EXPECT_EQ(parse_request(kHead.substr(0, size)).state, State::kIncomplete) << size;
  }

  const std::string two = kHead + kHead;
  const ParsedRequest parsed = parse_request(two);
  ASSERT_EQ(parsed.state, State::kWhole);
  EXPECT_EQ(parsed.size, kHead.size());
  EXPECT_EQ(parsed.request.method, "GET");
  EXPECT_EQ(parsed.request.target, "/live?from=2");
  EXPECT_THAT(parsed.request.fields,
              testing::ElementsAre(testing::Pair("Host", "a:80"), testing::Pair("X-Empty", ""),
                                   testing::Pair("X", "b c")));
  EXPECT_EQ(parsed.request.field("hOST"), "a:80");
}

TEST(HttpRequest, HasALineAndFieldsOfItsGrammar) {
  for (const std::string head :
       {"G(T / HTTP/1.1", "GET  / HTTP/1.1", "GET / x HTTP/1.1", "GET / HTTP/2.0", "GET /",
        "GET /\x01 HTTP/1.1", "GET / HTTP/1.1\r\nno colon", "GET / HTTP/1.1\r\na b: c",
        "GET / HTTP/1.1\r\n: c", "GET / HTTP/1.1\r\na: \x01", "GET / HTTP/1.1\r\na: b\r\n folded",
        "GET / HTTP/1.1\r\nContent-Length: -1", "GET / HTTP/1.1\r\nContent-Length: 1, 2"}) {
    EXPECT_EQ(parse_request(head + "\r\n\r\n").state, State::kBad) << head;
  }
  EXPECT_EQ(parse_request(std::string(kMaxRequestHead, 'x')).state, State::kTooLong);
}

TEST(HttpRequest, KeepsConnectionsThatItsClientKeepsIfNoBodyFollows) {
  const auto keeps = [](const std::string& version, const std::string& field) {
    return parse_request("GET / HTTP/" + version + field + "\r\n\r\n").request.keeps_connection;
  };
  EXPECT_TRUE(keeps("1.1", "") && keeps("1.1", "\r\nContent-Length: 0"));
  EXPECT_TRUE(keeps("1.0", "\r\nConnection: Keep-Alive"));
  EXPECT_FALSE(keeps("1.0", "") || keeps("1.1", "\r\nconnection: x, CLOSE"));
  EXPECT_FALSE(keeps("1.1", "\r\nContent-Length: 1") ||
               keeps("1.1", "\r\nTransfer-Encoding: chunked"));
}

}  // namespace
}  // namespace cls::viewer
