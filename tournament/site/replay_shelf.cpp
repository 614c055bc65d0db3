// A queue of orders and a list of pages by the time of their last request.
#include "tournament/site/replay_shelf.h"

#include <sys/resource.h>
#include <unistd.h>

#include <iterator>
#include <utility>

#include "viewer/page/match_page.h"

namespace cls::tournament {
namespace {

constexpr int kLowestPriority = 19;

std::string make_page(const std::filesystem::path& log, const std::string& home) {
  const auto match = viewer::read_log_or_page(log.string());
  if (!match || match->record.frames() == 0) {
    return "<!doctype html>\n<html lang=\"en\"><title>no replay</title>"
           "<p>This match has no log to show.</p></html>\n";
  }
  viewer::PageSettings settings;
  settings.home = home;
  return viewer::match_page(match->record, nullptr, log.filename().string(),
                            {.settings = settings});
}

}  // namespace

ReplayShelf::ReplayShelf(std::size_t max_bytes)
    : max_bytes_(max_bytes), thread_([this] { make_pages(); }) {}

ReplayShelf::~ReplayShelf() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::shared_ptr<const viewer::LiveFeed> ReplayShelf::page(const std::filesystem::path& log,
                                                          const std::string& home) {
  std::error_code code;
  const Key key{log, std::filesystem::last_write_time(log, code)};
  const std::lock_guard lock(mutex_);
  const auto known = by_log_.find(key);
  if (known != by_log_.end()) {
    pages_.splice(pages_.begin(), pages_, known->second);
    return known->second->feed;
  }

  pages_.push_front({key, home, std::make_shared<viewer::LiveFeed>()});
  by_log_.emplace(key, pages_.begin());
  orders_.push_back(key);
  changed_.notify_all();
  return pages_.front().feed;
}

std::size_t ReplayShelf::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

void ReplayShelf::make_pages() {
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kLowestPriority);
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopped_ || !orders_.empty(); });
    if (stopped_) break;

    const auto ordered = by_log_.at(orders_.front());
    orders_.pop_front();
    const auto feed = ordered->feed;  // pages that are not made yet are not forgotten
    const std::string home = ordered->home;
    const std::filesystem::path log = ordered->key.first;
    lock.unlock();
    const std::string page = make_page(log, home);
    lock.lock();
    ordered->bytes = page.size();
    bytes_ += page.size();
    forget_old_pages();
    lock.unlock();

    // Last, so that a reader of a whole page finds the shelf within its limit.
    feed->append(page);
    feed->finish();
    lock.lock();
  }
  for (const Page& page : pages_) {
    if (page.bytes == 0) page.feed->finish();
  }
}

// The latest page stays, however large it is.
void ReplayShelf::forget_old_pages() {
  for (auto page = pages_.end(); bytes_ > max_bytes_ && page != pages_.begin();) {
    --page;
    if (page == pages_.begin() || page->bytes == 0) continue;
    bytes_ -= page->bytes;
    by_log_.erase(page->key);
    page = pages_.erase(page);
  }
}

}  // namespace cls::tournament
