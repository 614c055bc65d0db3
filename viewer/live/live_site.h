// What a viewer of a running match gets: the page, and its stream.
#pragma once

#include <memory>
#include <string>

#include "viewer/live/http_server.h"
#include "viewer/live/live_feed.h"
#include "viewer/page/page.h"

namespace cls::viewer {

/// "" is the page, "live?from=BYTES" the stream from that offset on. `title` is what the page is
/// called until the names of the teams are known.
HttpRoutes live_site(const std::string& title, const PageSettings& settings,
                     std::shared_ptr<const LiveFeed> feed);

/// The stream of the query "from=BYTES"; 400 for another query.
HttpReply feed_reply(std::shared_ptr<const LiveFeed> feed, std::string_view query);

/// A page of HTML.
HttpReply page_reply(std::string html);

}  // namespace cls::viewer
