// Chunks of the stream go into the file.
#include "match/hooks/world_model_recorder.h"

#include "base/io/gzip_sink.h"
#include "viewer/decisions/decision_files.h"

namespace cls::match {

using soccer::Side;

WorldModelRecorder::WorldModelRecorder(const std::filesystem::path& folder, const TeamNames& names)
    : SideHooks(
          {WorldModelsOfSide(Side::kLeft, names.left, folder / viewer::kLeftWorldModelsFile),
           WorldModelsOfSide(Side::kRight, names.right, folder / viewer::kRightWorldModelsFile)}) {}

void WorldModelsOfSide::end_cycle() {
  stream_.end_cycle(bytes_);
  write();
}

void WorldModelsOfSide::write() {
  if (!error_.empty()) bytes_.clear();
  if (bytes_.empty()) return;
  if (sink_ == nullptr) {
    auto file = base::FileSink::create(file_.string());
    if (!file) {
      error_ = file.error().message;
      return;
    }
    sink_ = std::make_unique<base::GzipSink>(*std::move(file));
  }
  sink_->write(bytes_);
  bytes_.clear();
}

std::string WorldModelsOfSide::close() {
  stream_.end(bytes_);
  write();
  if (sink_ == nullptr || !error_.empty()) return error_;
  const auto closed = sink_->close();
  return closed ? std::string() : closed.error().message;
}

}  // namespace cls::match
