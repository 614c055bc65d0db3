// Deadlock detection and log lines.
#include "proto/grpc_settings.h"

#include <absl/synchronization/mutex.h>
#include <grpc/compression.h>
#include <grpc/grpc.h>
#include <grpc/support/log.h>

#include <cstdlib>

#include "proto/rpc.h"

namespace cls::proto {

void apply_grpc_settings() {
  absl::SetMutexDeadlockDetectionMode(absl::OnDeadlockCycle::kIgnore);
  static const bool kept = (grpc_init(), true);
  static_cast<void>(kept);
}

void limit_replies(grpc::ChannelArguments& arguments) {
  constexpr int kEnvelope = 1 << 16;  // of a team's reply
  constexpr int kUncompressed = 1 << GRPC_COMPRESS_NONE;
  arguments.SetMaxReceiveMessageSize(static_cast<int>(kMaxTeamReplyBytes) + kEnvelope);
  arguments.SetInt(GRPC_COMPRESSION_CHANNEL_ENABLED_ALGORITHMS_BITSET, kUncompressed);
}

void silence_grpc_log() {
  if (std::getenv("GRPC_VERBOSITY") == nullptr) gpr_set_log_function([](gpr_log_func_args*) {});
}

}  // namespace cls::proto
