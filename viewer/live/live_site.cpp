// The routes of a running match.
#include "viewer/live/live_site.h"

#include <charconv>
#include <utility>

namespace cls::viewer {

HttpReply page_reply(std::string html) {
  HttpReply reply;
  reply.status = 200;
  reply.type = "text/html; charset=utf-8";
  reply.body = std::move(html);
  return reply;
}

HttpReply feed_reply(std::shared_ptr<const LiveFeed> feed, std::string_view query) {
  constexpr std::string_view kFrom = "from=";
  HttpReply reply;
  if (!query.empty()) {
    const std::string_view number = query.substr(query.starts_with(kFrom) ? kFrom.size() : 0);
    const char* end = number.data() + number.size();
    const auto parsed = std::from_chars(number.data(), end, reply.from);
    if (parsed.ec != std::errc() || parsed.ptr != end) {
      reply.status = 400;
      reply.body = "from=BYTES expected\n";
      return reply;
    }
  }
  reply.status = 200;
  reply.type = "application/octet-stream";
  reply.feed = std::move(feed);
  return reply;
}

HttpRoutes live_site(const std::string& title, const PageSettings& settings,
                     std::shared_ptr<const LiveFeed> feed) {
  return [page = live_page(title, "live", settings), feed = std::move(feed)](
             std::string_view path, std::string_view query) {
    if (path.empty()) return page_reply(page);
    if (path == "live") return feed_reply(feed, query);
    HttpReply reply;
    reply.body = "not found\n";
    return reply;
  };
}

}  // namespace cls::viewer
