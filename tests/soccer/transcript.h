// Recorded sessions of clients and rcssserver as lists of messages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cls::tests {

enum class Role { kUnknown, kPlayer, kOnlineCoach, kTrainer, kMonitor };

/// One message without its closing NUL, and its client.
struct RecordedMessage {
  bool from_server = false;
  Role role = Role::kUnknown;  ///< of the client
  int version = 0;             ///< of the client; 999 for monitors of version 3 and later
  std::string client;          ///< name in a log of several clients
  std::string text;
  std::string place;  ///< file and line, for failure messages
};

/// Reads a recorded file (gzip), either of the form "S>C<tab>seconds<tab>text" or a log of scripted
/// clients, "seconds client << [port length] b'text'". Skips binary, compressed and truncated
/// messages.
std::vector<RecordedMessage> read_transcript(const std::filesystem::path& path);

}  // namespace cls::tests
