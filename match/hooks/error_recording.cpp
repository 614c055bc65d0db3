// A recording of one agent.
#include "match/hooks/error_recording.h"

#include <string>

#include "proto/recording_file.h"

namespace cls::match {

base::Result<void> write_error_recording(const std::filesystem::path& file,
                                         const recording::RecordingHeader& header,
                                         soccer::Side side, const proxy::PlaymakerError& error) {
  std::string problem;
  const auto writer = proto::RecordingWriter::create(file.string(), header, problem);
  if (writer == nullptr) return base::Error{problem};
  for (recording::RecordedCall call : error.calls) {
    call.set_side(side == soccer::Side::kRight ? 2 : 1);
    writer->write(call);
  }
  problem = writer->close();
  if (!problem.empty()) return base::Error{problem};
  return {};
}

}  // namespace cls::match
