// How values of parameters reach a Playmaker: placeholders, environment, a file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "tournament/tuning/tune_config.h"

namespace cls::tournament {

/// `text` with {NAME} replaced by the value of each parameter; other braces stay.
std::string with_values(std::string_view text, const TuneConfig& config, const Values& values);

/// The SIDE of a Playmaker with these values. {file} is `file`.
std::string side_of(const TuneConfig& config, const Values& values,
                    const std::filesystem::path& file);

/// The text of its file: that of the template, or names and values as JSON or TOML, where "a.b" is
/// member b of a. `file_template` of the configuration is the text of the template here.
std::string file_text(const TuneConfig& config, const Values& values);

/// Names and values as TOML, one line each.
std::string values_text(const TuneConfig& config, const Values& values);

/// Writes the file of a candidate into `folder`, if the configuration has one, and returns its
/// SIDE.
base::Result<std::string> prepare_candidate(const TuneConfig& config, const Values& values,
                                            const std::filesystem::path& folder);

}  // namespace cls::tournament
