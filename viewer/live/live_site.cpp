// The routes of a running match.
#include "viewer/live/live_site.h"

#include <optional>
#include <string_view>
#include <utility>

#include "base/text/value_text.h"
#include "viewer/page/page_drawings.h"

namespace cls::viewer {
namespace {

constexpr std::size_t kMaxDrawingsReply = std::size_t{1} << 20;

HttpReply text_reply(int status, const char* text) { return {.status = status, .body = text}; }
HttpReply not_found() { return text_reply(404, "not found\n"); }
HttpReply bad_query() { return text_reply(400, "from=BYTES expected\n"); }

// The offset of "from=12"; 0 without a query.
std::optional<std::size_t> offset_of(std::string_view query) {
  constexpr std::string_view kFrom = "from=";
  if (query.empty()) return 0;
  return base::value_of<std::size_t>(query.substr(query.starts_with(kFrom) ? kFrom.size() : 0));
}

constexpr const char* kBytesType = "application/octet-stream";

}  // namespace

HttpReply page_reply(std::string html) {
  return {.status = 200, .type = "text/html; charset=utf-8", .body = std::move(html)};
}

HttpReply feed_reply(std::shared_ptr<const LiveFeed> feed, std::string_view query) {
  const auto from = offset_of(query);
  if (!from) return bad_query();
  return {.status = 200, .type = kBytesType, .feed = std::move(feed), .from = *from};
}

HttpReply drawings_reply(const std::filesystem::path& folder, std::string_view path,
                         std::string_view query) {
  const std::string_view drawings = kDrawingsPath;
  if (!path.starts_with(drawings)) return not_found();
  path.remove_prefix(drawings.size());
  if (path != "-left" && path != "-right") return not_found();

  const auto from = offset_of(query);
  if (!from) return bad_query();

  const soccer::Side side = path == "-left" ? soccer::Side::kLeft : soccer::Side::kRight;
  return {.status = 200,
          .type = kBytesType,
          .body = read_drawings(folder, side, *from, kMaxDrawingsReply)};
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
