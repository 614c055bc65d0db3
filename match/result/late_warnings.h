// Warnings that only the whole match shows: useless replies, what programs printed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "match/result/match_result.h"

namespace cls::match {

/// A side most of whose replies led to no executed action.
std::vector<std::string> action_warnings(const TeamResult& team);

/// Cycles in which the server did not wait any longer for all clients; none when there are none.
std::vector<std::string> missed_cycle_warnings(const MatchResult& result);

/// True if the first failed call of a side reports this exception.
bool is_reported(const MatchResult& result, const std::string& exception);

/// The remedy for an exception of a program that lacks something: "pip install ./python ...";
/// empty: not known.
std::string remedy_of(const std::string& exception);

/// Reads the logs of the processes in the match folder: sets `exception` of each process that
/// printed one, and warns of exceptions that no failed call reports, and of lines that were
/// repeated very often, and of logs that could not be written.
std::vector<std::string> output_warnings(MatchResult& result, const std::filesystem::path& folder);

}  // namespace cls::match
