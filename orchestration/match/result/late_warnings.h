// Warnings that only the whole match shows: useless replies, what programs printed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "orchestration/match/result/match_result.h"

namespace cls::orchestration::match {

/// A side most of whose replies led to no executed action.
std::vector<std::string> action_warnings(const TeamResult& team);

/// Reads the logs of the processes in the match folder: sets `exception` of each process that
/// printed one, and warns of exceptions and of lines that were repeated very often.
std::vector<std::string> output_warnings(std::vector<ProcessResult>& processes,
                                         const std::filesystem::path& folder);

}  // namespace cls::orchestration::match
