// The settings.
#include "proto/grpc_settings.h"

#include <absl/synchronization/mutex.h>

namespace cls::proto {

void apply_grpc_settings() { absl::SetMutexDeadlockDetectionMode(absl::OnDeadlockCycle::kIgnore); }

}  // namespace cls::proto
