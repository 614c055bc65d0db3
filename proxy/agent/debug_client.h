// Sends decisions to soccerwindow2's debug server, and writes the files that it reads.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "base/io/byte_sink.h"
#include "base/system/udp_socket.h"
#include "proxy/agent/debug_options.h"
#include "proxy/agent/decision_listener.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// For the players of one team. Packets to a server that does not listen are lost, as over any
/// network. Each file is created with its first line.
class DebugClient : public DecisionListener {
 public:
  explicit DebugClient(DebugOptions options);

  void on_decision(const Decision& decision) override;

  /// Writes the rest of the files. Returns the first error, or an empty string.
  std::string close();

 private:
  struct Files {
    std::unique_ptr<base::FileSink> log;
    std::unique_ptr<base::FileSink> view;
    std::size_t log_bytes = 0;
  };

  void send_view(const Decision& decision, Files& files);
  void write_log(const Decision& decision, Files& files);
  base::FileSink* open(std::unique_ptr<base::FileSink>& file, const std::string& folder,
                       const std::string& extension, const PlayerAgent& agent);

  DebugOptions options_;
  std::optional<base::UdpSocket> socket_;
  std::array<Files, kAgentNumbers> files_;
  std::string error_;
  std::string text_;  // reused
};

}  // namespace cls::proxy
