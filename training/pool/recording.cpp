// Writes episodes as game logs.
#include "training/pool/recording.h"

#include <string_view>
#include <utility>

#include "base/io/gzip_sink.h"

namespace cls::training {
namespace {

// "episode.rcl.gz" for "episode.rcg.gz"; empty for other names.
std::string text_log_of(const std::string& path) {
  for (const std::string_view ending : {".rcg", ".rcg.gz"}) {
    if (!path.ends_with(ending)) continue;
    std::string text = path;
    text[path.size() - ending.size() + 3] = 'l';
    return text;
  }
  return {};
}

}  // namespace

base::Result<std::unique_ptr<Recording>> Recording::create(const std::string& path) {
  TRY_INIT(auto game, base::create_sink(path));
  std::unique_ptr<base::ByteSink> text;
  if (const std::string name = text_log_of(path); !name.empty()) {
    TRY_INIT(auto created, base::create_sink(name));
    text = std::move(created);
  }
  return std::unique_ptr<Recording>(new Recording(std::move(game), std::move(text)));
}

void Recording::begin(const Episode& episode) {
  recorder_.begin({.game = game_.get(), .text = text_.get()}, *episode.world().rules);
  recorder_.step(episode.world());
  running_ = true;
}

base::Result<void> Recording::finish(const Episode& episode) {
  if (running_) recorder_.finish(episode.world());
  running_ = false;
  const base::Result<void> closed = game_->close();
  if (text_ == nullptr || !closed) return closed;
  return text_->close();
}

}  // namespace cls::training
