// Matches that are played now: their streams equal their logs, and their server is careful.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/io/byte_source.h"
#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"
#include "tests/support/http_client.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/record_difference.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/live/http_server.h"
#include "viewer/live/live_feed.h"
#include "viewer/live/live_match.h"
#include "viewer/live/live_site.h"
#include "viewer/live/log_glance.h"
#include "viewer/live/match_list.h"
#include "viewer/page/encoding.h"
#include "viewer/page/viewer_program.h"
#include "viewer/stream/chunk_reader.h"

namespace cls::viewer {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::Not;
using tests::exchange;
using tests::get;

constexpr milliseconds kLimit{20'000};

// All bytes of a feed, up to its end.
std::string whole(const LiveFeed& feed) {
  std::string bytes;
  while (feed.wait(bytes.size(), kLimit)) {
    const LiveFeed::Piece piece = feed.read(bytes.size(), 1000);
    bytes += piece.bytes;
    if (piece.ended) return bytes;
  }
  ADD_FAILURE() << "the feed has no end";
  return bytes;
}

std::string unpacked(const std::string& fixture) {
  return base::read_all(*base::open_source(tests::fixture(fixture).string()).value());
}

std::size_t frames_in(const std::string& stream) {
  ChunkReader reader;
  EXPECT_TRUE(reader.add(stream));
  return reader.match().record.frames();
}

/// A log that grows as a server writes it.
class GrowingLog {
 public:
  explicit GrowingLog(std::string_view bytes = "", std::string name = "match.rcg")
      : name_(std::move(name)) {
    add(bytes);
  }
  std::filesystem::path path() const { return folder_.path() / name_; }
  void add(std::string_view bytes) {
    std::ofstream(path(), std::ios::app | std::ios::binary) << bytes;
  }

 private:
  tests::TemporaryFolder folder_;
  std::string name_;
};

// Looks again and again; false if `condition` does not come about.
bool eventually(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + kLimit;
  while (!condition() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(milliseconds(5));
  }
  return condition();
}

TEST(LiveFeed, GivesEachReaderAllBytes) {
  LiveFeed feed;
  EXPECT_FALSE(feed.wait(0, milliseconds(0)));
  feed.append("abc");
  EXPECT_EQ(feed.read(0, 2).bytes, "ab");
  EXPECT_EQ(feed.read(2, 9).bytes, "c");
  EXPECT_FALSE(feed.read(2, 9).ended);
  feed.finish();
  EXPECT_TRUE(feed.read(2, 9).ended);
  EXPECT_FALSE(feed.read(0, 2).ended);
  EXPECT_TRUE(feed.wait(3, milliseconds(0)));
  EXPECT_EQ(feed.read(17, 9).bytes, "");
}

TEST(LiveMatch, EqualsTheLogHoweverItArrives) {
  for (const char* name : {"gamelog/rcg-v1-excerpt.rcg.gz", "gamelog/rcg-v3-excerpt.rcg.gz",
                           "gamelog/match-start.rcg.gz", "gamelog/rcg-json-excerpt.rcg.gz"}) {
    // Packed bytes, too: the log of a match may be gzip.
    for (const auto& [bytes, block] : {std::pair(unpacked(name), 7'777U),
                                       {unpacked(name), 100'000},
                                       {tests::read_file(tests::fixture(name)), 7'777}}) {
      SCOPED_TRACE(fmt::format("{}, {} bytes in blocks of {}", name, bytes.size(), block));

      GrowingLog out;
      std::atomic<bool> complete{false};
      LiveMatch live(follow_log(out.path(), [&] { return complete.load(); }));
      for (std::size_t at = 0; at < bytes.size(); at += block) {
        out.add(std::string_view(bytes).substr(at, block));
      }
      complete.store(true);

      const auto match = read_stream(whole(*live.feed()));
      const auto record = gamelog::read_rcg_file(tests::fixture(name).string()).value();
      ASSERT_EQ(tests::record_difference(record, match), "");
      EXPECT_TRUE(match->form.live);
      EXPECT_THAT(match->statistics, HasSubstr("\"possession\""));
    }
  }
}

TEST(LiveMatch, ShowsWholeLinesWhileTheyArrive) {
  const std::string text = unpacked("gamelog/rcg-v6-excerpt.rcg.gz");
  GrowingLog out;
  LiveMatch live(follow_log(out.path(), nullptr));
  std::size_t shows = 0;
  for (std::size_t at = 0; shows < 3;) {
    const std::size_t end = text.find('\n', at) + 1;
    out.add(text.substr(at, end - at));
    if (text.compare(at, 6, "(show ") == 0) {
      ++shows;
      ASSERT_TRUE(eventually(
          [&] { return frames_in(live.feed()->read(0, std::string::npos).bytes) >= shows; }));
    }
    at = end;
  }

  EXPECT_FALSE(live.over());
  EXPECT_FALSE(live.feed()->read(0, 1).ended);
}

// rcssserver writes the teams after the result.
TEST(LiveMatch, EndsWithTheResultInTheLog) {
  const GrowingLog log(unpacked("gamelog/rcg-v6-excerpt.rcg.gz"));
  const LiveMatch live(follow_log(log.path(), nullptr));
  const auto match = read_stream(whole(*live.feed()));
  ASSERT_TRUE(match) << match.error().message;
  EXPECT_EQ(match->record.errors.count, 0U);
}

TEST(LiveMatch, HasStatisticsWhileItIsPlayed) {
  const GrowingLog log(unpacked("gamelog/match-start.rcg.gz"));
  LiveMatch live(follow_log(log.path(), nullptr), {}, milliseconds(0));
  ASSERT_TRUE(live.feed()->wait(0, kLimit));
  ChunkReader reader;
  ASSERT_TRUE(reader.add(live.feed()->read(0, std::string::npos).bytes));
  EXPECT_GT(reader.match().record.frames(), 100U);
  EXPECT_THAT(reader.match().statistics, HasSubstr("\"possession\""));
  EXPECT_FALSE(live.over());
}

TEST(LiveMatch, EndsWithAnErrorWhenTheLogIsCut) {
  const GrowingLog log("ULG6\n(show 1 ");
  LiveMatch live(follow_log(log.path(), [] { return true; }));
  const auto match = read_stream(whole(*live.feed()));
  ASSERT_TRUE(match) << match.error().message;
  EXPECT_EQ(match->record.frames(), 0U);
  EXPECT_EQ(match->record.errors.count, 1U);
}

/// A match that is over, and counts who reads it.
class CountingInput : public LiveInput {
 public:
  explicit CountingInput(std::atomic<int>& reads) : reads_(reads) {}
  std::size_t read(char* /*to*/, std::size_t /*size*/) override {
    ++reads_;
    return 0;
  }
  State state() override { return State::kEnded; }
  bool knows_its_end() const override { return true; }

 private:
  std::atomic<int>& reads_;
};

// The match pays nothing for a page that is not open.
TEST(LiveMatch, ReadsNothingBeforeTheFirstReader) {
  std::atomic<int> reads{0};
  const LiveMatch live(std::make_unique<CountingInput>(reads));
  EXPECT_TRUE(eventually([&] { return live.over(); }));
  EXPECT_EQ(reads.load(), 0);
  EXPECT_NE(whole(*live.feed()), "");
  EXPECT_GT(reads.load(), 0);
}

TEST(LiveMatch, StopsWithoutALog) {
  LiveMatch live(follow_log("/nonexistent/match.rcg", nullptr));
  EXPECT_FALSE(live.over());
}

std::unique_ptr<HttpServer> serve(HttpRoutes routes) {
  auto server = HttpServer::start({}, std::move(routes));
  EXPECT_TRUE(server) << (server ? "" : server.error().message);
  return *std::move(server);
}

std::string request(const std::string& line, const std::string& host = "localhost") {
  return line + "\r\nHost: " + host + "\r\nConnection: close\r\n\r\n";
}

class LiveSite : public testing::Test {
 protected:
  LiveSite() : feed_(std::make_shared<LiveFeed>()) {
    server_ = serve(live_site("a<b", {12, {"l7"}}, feed_));
    token_ = tests::path_of(server_->url());
  }
  int status(const std::string& bytes) const { return exchange(server_->port(), bytes).status; }

  std::shared_ptr<LiveFeed> feed_;
  std::unique_ptr<HttpServer> server_;
  std::string token_;  // "/.../"
};

TEST_F(LiveSite, ServesThePage) {
  const auto response = get(server_->url());
  EXPECT_EQ(response.status, 200);
  EXPECT_THAT(response.body, HasSubstr("<title>a&lt;b</title>"));
  EXPECT_THAT(response.body, HasSubstr(R"("at":12,"players":["l7"],"live":"live")"));
  EXPECT_THAT(response.body, HasSubstr("connect-src 'self'"));
  EXPECT_THAT(response.body, Not(HasSubstr("id=\"match\"")));

  for (const char* line : {"Content-Type: text/html; charset=utf-8", "Cache-Control: no-store",
                           "X-Content-Type-Options: nosniff", "Referrer-Policy: no-referrer",
                           "Content-Security-Policy: frame-ancestors 'none'",
                           "Cross-Origin-Resource-Policy: same-origin"}) {
    EXPECT_THAT(response.header, HasSubstr(line)) << line;
  }
  const auto head = exchange(server_->port(), request("HEAD " + token_ + " HTTP/1.1"));

  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.body, "");
}

TEST_F(LiveSite, SendsTheFeedFromAnyByteWhileItGrows) {
  feed_->append("0123");
  const tests::HttpConnection connection(server_->port());
  connection.send(request("GET " + token_ + "live?from=2 HTTP/1.1"));
  std::string start;
  while (start.find("23") == std::string::npos) start += connection.receive();
  EXPECT_EQ(server_->streams(), 1U);
  feed_->append("456");
  feed_->finish();
  EXPECT_THAT((start + connection.receive()), HasSubstr("456"));
  EXPECT_EQ(get(server_->url() + "live").body, "0123456");
  EXPECT_EQ(get(server_->url() + "live?from=5").body, "56");
  EXPECT_EQ(get(server_->url() + "live?from=99").body, "");
}

TEST_F(LiveSite, RefusesWhatItDoesNotKnow) {
  for (const std::string path : {"/", "/live", "/../../etc/passwd", "/%2e%2e/", "//", "*"}) {
    EXPECT_EQ(status(request("GET " + path + " HTTP/1.1")), 404) << path;
  }
  for (const std::string path : {"x", "..", "%2e%2e/passwd", "../live", "live/", "live%00"}) {
    EXPECT_EQ(status(request("GET " + token_ + path + " HTTP/1.1")), 404) << path;
  }
  for (const std::string query : {"from=-1", "from=x", "from=", "to=2", "from=1&x", "from=1 "}) {
    EXPECT_EQ(status(request("GET " + token_ + "live?" + query + " HTTP/1.1")), 400) << query;
  }
  std::string wrong = token_;
  wrong[5] = wrong[5] == '0' ? '1' : '0';

  EXPECT_EQ(status(request("GET " + wrong + " HTTP/1.1")), 404);
  EXPECT_EQ(status(request("GET " + token_.substr(0, token_.size() - 1) + " HTTP/1.1")), 404);
}

TEST_F(LiveSite, SendsDrawingsOfTheMatchFolderWhileTheyGrow) {
  const tests::TemporaryFolder folder;
  const auto server = serve(live_site("a", {}, feed_, folder.path()));
  EXPECT_THAT(get(server->url()).body, HasSubstr(R"("drawings":"drawings")"));

  const auto drawings = [&](const char* rest) { return get(server->url() + "drawings" + rest); };
  EXPECT_EQ(drawings("-left?from=0").status, 200);
  EXPECT_EQ(drawings("-left?from=0").body, "");

  std::ofstream file(folder.path() / kLeftDebugFile);
  file << "one\n" << std::flush;
  EXPECT_EQ(drawings("-left?from=0").body, "one\n");

  file << "two\n" << std::flush;
  EXPECT_EQ(drawings("-left?from=4").body, "two\n");
  EXPECT_EQ(drawings("-left?from=9").body, "");
  EXPECT_EQ(drawings("-right").body, "");
  EXPECT_EQ(drawings("-left?from=x").status, 400);

  for (const char* rest : {"", "-", "-up", "-left/", "-left/../match.rcg"}) {
    EXPECT_EQ(drawings(rest).status, 404) << rest;
  }

  // A page of a server that writes no match folder does not ask.
  EXPECT_THAT(get(server_->url()).body, Not(HasSubstr(R"("drawings":)")));
  EXPECT_EQ(get(server_->url() + "drawings-left").status, 404);
}

TEST_F(LiveSite, AnswersToItsOwnNamesOnly) {
  const std::string line = "GET " + token_ + " HTTP/1.1";
  for (const std::string host : {"localhost", "127.0.0.1:81", "localhost:80", "[::1]:80"}) {
    EXPECT_EQ(status(request(line, host)), 200) << host;
  }
  for (const std::string host :
       {"example.org", "localhost.example.org", "127.0.0.1.example.org", "", "[::1", "evil:80"}) {
    EXPECT_EQ(status(request(line, host)), 403) << host;
  }
  EXPECT_EQ(status(line + "\r\nConnection: close\r\n\r\n"), 403);
}

TEST_F(LiveSite, RefusesOtherMethodsAndBrokenRequests) {
  for (const std::string method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE"}) {
    EXPECT_EQ(status(request(method + " " + token_ + " HTTP/1.1")), 405) << method;
  }
  EXPECT_EQ(status("POST " + token_ + " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9\r\n\r\n"),
            405);
  EXPECT_EQ(status("GET " + token_ + " HTTP/1.1\r\nX: " + std::string(9000, 'x') + "\r\n\r\n"),
            431);
  EXPECT_EQ(status("\x16\x03\x01\x02\x03\r\n\r\n"), 400);
  EXPECT_EQ(status("GET\r\n\r\n"), 400);
  EXPECT_EQ(get(server_->url()).status, 200);
}

TEST_F(LiveSite, ServesOthersWhileOneReaderStalls) {
  const std::string bytes(8 << 20, 'x');
  const tests::HttpConnection stalled(server_->port());
  stalled.send(request("GET " + token_ + "live HTTP/1.1"));
  feed_->append(bytes);
  feed_->finish();
  EXPECT_EQ(get(server_->url() + "live").body.size(), bytes.size());
  EXPECT_EQ(server_->streams(), 1U);
}

TEST_F(LiveSite, ForgetsReadersThatAreGone) {
  {
    const tests::HttpConnection connection(server_->port());
    connection.send(request("GET " + token_ + "live HTTP/1.1"));
    EXPECT_NE(connection.receive(), "");
  }
  EXPECT_TRUE(eventually([&] { return server_->streams() == 0; }));
}

TEST_F(LiveSite, LimitsTheNumberOfConnections) {
  std::vector<std::unique_ptr<tests::HttpConnection>> readers;
  for (int i = 0; i < 64; ++i) {
    readers.push_back(std::make_unique<tests::HttpConnection>(server_->port()));
    readers.back()->send(request("GET " + token_ + "live HTTP/1.1"));
    EXPECT_NE(readers.back()->receive(), "");
  }
  const auto refused = get(server_->url());
  EXPECT_TRUE(refused.status == 503 || refused.status == 0) << refused.status;
  readers.clear();
  EXPECT_TRUE(eventually([&] { return get(server_->url()).status == 200; }));
}

// Any process on this host can connect, but only viewers know the token.
TEST_F(LiveSite, HasRoomForViewersBesideUnfinishedRequests) {
  std::vector<std::unique_ptr<tests::HttpConnection>> strangers;
  for (int i = 0; i < 70; ++i) {
    strangers.push_back(std::make_unique<tests::HttpConnection>(server_->port()));
    strangers.back()->send(i % 2 == 0 ? "GET " : "");
  }
  EXPECT_EQ(get(server_->url()).status, 200);
}

TEST_F(LiveSite, RedirectsOnceFromAnAddressThatOthersMaySee) {
  const std::string url = server_->single_use_url();
  EXPECT_EQ(url.find(token_.substr(1, 8)), std::string::npos);
  EXPECT_EQ(exchange(server_->port(), request("HEAD " + tests::path_of(url) + " HTTP/1.1")).status,
            404)
      << "not a visit";

  const auto first = get(url);
  EXPECT_EQ(first.status, 302);
  EXPECT_THAT(first.header, HasSubstr("Location: " + token_ + "\r\n"));
  EXPECT_EQ(get(url).status, 404);

  const std::string old = server_->single_use_url();
  const std::string next = server_->single_use_url();
  EXPECT_EQ(get(old).status, 404);
  EXPECT_EQ(get(next).status, 302);
}

TEST(MatchList, LinksMatchesAndShowsNamesAsText) {
  const std::vector<ListedMatch> matches = {
      {1, "<b>", "B", "2 : 1", "", true},
      {2, "A", "B", "", "playing", true, soccer::Vec2{-12.5, 3.0}, true},
      {3, "A", "B", "", "planned", false}};
  const MatchList list = {"c\"up", "1 of 3 <matches>",     {"<table>\n</table>\n"}, matches,
                          true,    {{"played now", "<1>"}}};
  const std::string page = match_list_page(list);

  EXPECT_THAT(page, HasSubstr("&lt;b&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
  EXPECT_THAT(page, HasSubstr("<a href=\"match/1/\" aria-label=\"replay of match 1\">replay</a>"));
  EXPECT_THAT(page, HasSubstr("aria-label=\"live page of match 2\">live page</a>"));
  EXPECT_THAT(page, HasSubstr("<tr><th scope=\"row\">played now</th><td>&lt;1&gt;</td></tr>"));
  EXPECT_THAT(page, Not(HasSubstr("match/3/")));
  EXPECT_THAT(page, HasSubstr("1 of 3 &lt;matches&gt;"));
  EXPECT_THAT(page, HasSubstr("<noscript><meta http-equiv=\"refresh\""));
  EXPECT_THAT(page, HasSubstr("script-src " + csp_hash(list_script())));
  EXPECT_THAT(page, HasSubstr("<circle cx=\"-12.5\" cy=\"3.0\""));

  const std::string over = match_list_page({"cup", "", {}, matches, false});
  for (const char* part : {"refresh", "<script", "script-src", "data-running"}) {
    EXPECT_THAT(over, Not(HasSubstr(part))) << part;
  }
}

TEST(LogGlance, SeesWholeLinesOfAGrowingLog) {
  GrowingLog log;
  LogGlance glance(log.path());
  EXPECT_FALSE(glance.now());

  log.add("ULG6\n(team 1 A B 0 0)\n(show 1 ((b) 0 0 0 0) ((l 1) 0");
  EXPECT_FALSE(glance.now());

  log.add(")\n(team 2 A (x 2 1)\n(show 23 ((b) -1.5 2.25 0 0) ((l 1) 0)\n(show 24 ((b) 9");
  const auto seen = glance.now();
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->cycle, 23);
  EXPECT_EQ(seen->left, 2);
  EXPECT_EQ(seen->right, 1);
  EXPECT_EQ(seen->ball.x, -1.5);

  std::ofstream(log.path(), std::ios::binary) << "ULG6\n";
  EXPECT_FALSE(glance.now());
}

TEST(LogGlance, InflatesWhatIsThere) {
  std::string text = "ULG6\n(team 1 A B 3 0)\n";
  for (int cycle = 1; cycle < 5000; ++cycle) {
    text += fmt::format("(show {} ((b) {} {} 0 0))\n", cycle, cycle * 7 % 52, cycle * 11 % 34);
  }
  const std::string packed = gzip(text);
  GrowingLog log(packed.substr(0, packed.size() / 2), "match.rcg.gz");
  LogGlance glance(log.path());
  const auto half = glance.now();

  ASSERT_TRUE(half);
  EXPECT_GT(half->cycle, 500);
  EXPECT_LT(half->cycle, 4999);

  log.add(packed.substr(packed.size() / 2));
  EXPECT_EQ(glance.now()->cycle, 4999);
  EXPECT_EQ(glance.now()->left, 3);
}

TEST(HttpServer, SaysWhyItCannotListen) {
  const auto first = serve([](auto, auto) { return HttpReply{}; });
  const auto second = HttpServer::start({"127.0.0.1", first->port()}, nullptr);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("Address already in use"));
  EXPECT_EQ(HttpServer::start({"example.org", 0}, nullptr).error().message,
            "cannot listen on example.org port 0: not an IP address of this host");
  EXPECT_NE(serve(nullptr)->url(), serve(nullptr)->url());
}

}  // namespace
}  // namespace cls::viewer
