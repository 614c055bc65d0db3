// This machine and this moment, for manifests and records.
#pragma once

#include <string>

namespace cls::orchestration {

/// "2026-11-21T01:02:03Z".
std::string utc_now();

std::string host_name();

/// Runnable processes, averaged over the last minute; 0 when unknown.
double load_average();

/// Processors that count for planning: physical cores this process may run on, at least 1.
int usable_cores();

}  // namespace cls::orchestration
