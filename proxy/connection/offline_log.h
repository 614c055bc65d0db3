// Messages of the server to the players of a team, as files for librcsc's offline clients.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/io/byte_sink.h"
#include "soccer/channel.h"

namespace cls::proxy {

/// FOLDER/TEAM-NUMBER.ocl: a message a line, from the reply to init on. In real time a line
/// "(think)" stands where the player sent its commands; in synchronous mode the server sends it.
/// Lives longer than its channels' last message.
class OfflineLogs {
 public:
  OfflineLogs(std::string folder, std::string team)
      : folder_(std::move(folder)), team_(std::move(team)) {}

  /// `inner`, recorded. `unum` is that of a player that reconnects, which the server does not
  /// repeat; 0: the server assigns it.
  std::unique_ptr<soccer::Channel> record(std::unique_ptr<soccer::Channel> inner, int unum = 0);

  /// Writes the rest of the files. Returns the first error, or an empty string.
  std::string close();

  class File;

 private:
  std::string folder_;
  std::string team_;
  std::vector<std::shared_ptr<File>> files_;
};

}  // namespace cls::proxy
