// The routes of a running match.
#include "viewer/live/live_site.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "viewer/page/page_drawings.h"

namespace cls::viewer {
namespace {

constexpr std::size_t kMaxDrawingsReply = std::size_t{1} << 20;

HttpReply not_found() {
  HttpReply reply;
  reply.body = "not found\n";
  return reply;
}

// The offset of "from=12"; 0 without a query.
std::optional<std::size_t> offset_of(std::string_view query) {
  constexpr std::string_view kFrom = "from=";
  std::size_t offset = 0;
  if (query.empty()) return offset;

  const std::string_view number = query.substr(query.starts_with(kFrom) ? kFrom.size() : 0);
  const char* end = number.data() + number.size();
  const auto parsed = std::from_chars(number.data(), end, offset);
  if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return offset;
}

HttpReply bad_query() {
  HttpReply reply;
  reply.status = 400;
  reply.body = "from=BYTES expected\n";
  return reply;
}

HttpReply bytes_reply() {
  HttpReply reply;
  reply.status = 200;
  reply.type = "application/octet-stream";
  return reply;
}

}  // namespace

HttpReply page_reply(std::string html) {
  HttpReply reply;
  reply.status = 200;
  reply.type = "text/html; charset=utf-8";
  reply.body = std::move(html);
  return reply;
}

HttpReply feed_reply(std::shared_ptr<const LiveFeed> feed, std::string_view query) {
  const auto from = offset_of(query);
  if (!from) return bad_query();

  HttpReply reply = bytes_reply();
  reply.from = *from;
  reply.feed = std::move(feed);
  return reply;
}

HttpReply drawings_reply(const std::filesystem::path& folder, std::string_view path,
                         std::string_view query) {
  const std::string_view drawings = kDrawingsPath;
  if (!path.starts_with(drawings)) return not_found();
  path.remove_prefix(drawings.size());
  if (path != "-left" && path != "-right") return not_found();

  const auto from = offset_of(query);
  if (!from) return bad_query();

  HttpReply reply = bytes_reply();
  const soccer::Side side = path == "-left" ? soccer::Side::kLeft : soccer::Side::kRight;
  reply.body = read_drawings(folder, side, *from, kMaxDrawingsReply);
  return reply;
}

HttpRoutes live_site(const std::string& title, const PageSettings& settings,
                     std::shared_ptr<const LiveFeed> feed, const std::filesystem::path& folder) {
  const LivePaths paths{kStreamPath, folder.empty() ? "" : kDrawingsPath};
  return [page = live_page(title, paths, settings), feed = std::move(feed), folder](
             std::string_view path, std::string_view query) {
    if (path.empty()) return page_reply(page);
    if (path == kStreamPath) return feed_reply(feed, query);
    return folder.empty() ? not_found() : drawings_reply(folder, path, query);
  };
}

}  // namespace cls::viewer
