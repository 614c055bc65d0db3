// The State that caused a Playmaker's first error, as a recording to be sent again.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "proto/rpc_recording.pb.h"
#include "proxy/playmaker/playmaker_errors.h"
#include "soccer/side.h"

namespace cls::match {

/// Names inside a match folder.
inline constexpr const char* kLeftErrorFile = "left-error.rpc";
inline constexpr const char* kRightErrorFile = "right-error.rpc";

/// Writes the handshake of the agent and the failed call. `header` names the match, `side` is left
/// or right. The error names the file.
base::Result<void> write_error_recording(const std::filesystem::path& file,
                                         const recording::RecordingHeader& header,
                                         soccer::Side side, const proxy::PlaymakerError& error);

}  // namespace cls::match
