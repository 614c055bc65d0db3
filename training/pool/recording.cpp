// Writes episodes as game logs.
#include "training/pool/recording.h"

#include <utility>

#include "base/io/gzip_sink.h"

namespace cls::training {

base::Result<std::unique_ptr<Recording>> Recording::create(const std::string& path) {
  auto sink = base::create_sink(path);
  if (!sink) return sink.error();
  return std::unique_ptr<Recording>(new Recording(std::move(*sink)));
}

void Recording::begin(const Episode& episode) {
  recorder_.begin({.game = sink_.get()}, *episode.world().rules);
  recorder_.step(episode.world());
  running_ = true;
}

base::Result<void> Recording::finish(const Episode& episode) {
  if (running_) recorder_.finish(episode.world());
  running_ = false;
  return sink_->close();
}

}  // namespace cls::training
