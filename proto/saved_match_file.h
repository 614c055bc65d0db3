// Reads and writes files of saved matches (saved_match.proto).
#pragma once

#include <string>

#include "proto/saved_match.pb.h"

namespace cls::proto {

/// The version of the files that are written; those of newer versions are refused.
constexpr int kSavedMatchVersion = 1;

/// Sets format and version and writes the file. Returns the error, or an empty string.
std::string write_saved_match(const std::string& path, saved::SavedMatch match);

/// Returns why the file is not a saved match that this version reads, or an empty string.
std::string read_saved_match(const std::string& path, saved::SavedMatch& out);

}  // namespace cls::proto
