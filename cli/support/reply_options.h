// Options about the replies of a Playmaker that several commands have.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cls::cli {

/// --on-late and --batch. The values have been checked; they are parsed by proxy::parse_on_late()
/// and proxy::parse_batch_mode().
inline void add_reply_options(CLI::App& command, std::string& on_late, std::string& batch) {
  command
      .add_option("--on-late", on_late, "commands after a missed decision: hold, last or default")
      ->capture_default_str()
      ->check(CLI::IsMember({"hold", "last", "default"}));
  command
      .add_option("--batch", batch,
                  "one call per team and cycle: auto, never or always (docs/wire.md)")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "never", "always"}));
}

}  // namespace cls::cli
