// This machine and this moment, for manifests and records.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace cls::base {

/// "2026-11-21T01:02:03Z".
std::string utc_now();

/// The same moment without signs that names of files and folders do not like: "20261121T010203Z".
std::string utc_stamp();

std::string host_name();

/// Runnable processes, averaged over the last minute; 0 when unknown.
double load_average();

/// Numbers of the processors this process may run on, ascending; empty when unknown.
std::vector<int> allowed_processors();

/// The same by physical cores: each entry holds the processors that are threads of one core.
std::vector<std::vector<int>> allowed_cores();

/// Two parts of equal size that share no core; one core in the middle is left to everybody. Of a
/// single core the threads are shared out. Empty parts for a single processor.
std::array<std::vector<int>, 2> halves_of(const std::vector<std::vector<int>>& cores);

/// Processors that count for planning: physical cores this process may run on, at least 1.
int usable_cores();

}  // namespace cls::base
