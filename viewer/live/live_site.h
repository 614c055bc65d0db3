// The site of a running match: its page, and its stream.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "viewer/live/http_server.h"
#include "viewer/live/live_feed.h"
#include "viewer/page/page.h"

namespace cls::viewer {

/// Where the pages of running matches read what they show.
inline constexpr const char* kStreamPath = "live";
inline constexpr const char* kDrawingsPath = "drawings";

/// "" is the page, "live?from=BYTES" the stream from that offset on, "drawings-left?from=BYTES" and
/// "drawings-right?from=BYTES" what is there of the debug logs in `folder`; without a folder the
/// page does not ask for them. `title` is what the page is called until the names of the teams are
/// known.
HttpRoutes live_site(const std::string& title, const PageSettings& settings,
                     std::shared_ptr<const LiveFeed> feed,
                     const std::filesystem::path& folder = {});

/// The stream of the query "from=BYTES"; 400 for another query.
HttpReply feed_reply(std::shared_ptr<const LiveFeed> feed, std::string_view query);

/// What the debug log of a side in `folder` has after the query "from=BYTES"; 404 for a path that
/// is neither side's.
HttpReply drawings_reply(const std::filesystem::path& folder, std::string_view path,
                         std::string_view query);

/// A page of HTML.
HttpReply page_reply(std::string html);

}  // namespace cls::viewer
