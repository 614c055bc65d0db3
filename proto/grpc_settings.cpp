// Deadlock detection and log lines.
#include "proto/grpc_settings.h"

#include <absl/synchronization/mutex.h>
#include <grpc/compression.h>
#include <grpc/grpc.h>
#include <grpc/support/log.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>

#include <cstdlib>
#include <memory>

#include "proto/rpc.h"

namespace cls::proto {

void apply_grpc_settings() {
  absl::SetMutexDeadlockDetectionMode(absl::OnDeadlockCycle::kIgnore);
  [[maybe_unused]] static const bool kept = (grpc_init(), true);

  // Never connects and is never destroyed: the last channel of a process destroys gRPC's timers,
  // and waits for ever for their thread when there was no memory to start it.
  // Volatile: otherwise nothing would refer to it, and leak checkers would report it.
  [[maybe_unused]] static const std::shared_ptr<grpc::Channel>* volatile last_channel =
      new std::shared_ptr<grpc::Channel>(
          grpc::CreateChannel("unix:/nonexistent", grpc::InsecureChannelCredentials()));
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
