// Reads /proc/net and the descriptors of processes.
#include "process/socket_table.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace cls::process {
namespace {

namespace fs = std::filesystem;

// "0100007F:1770"
int split_port(std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return 0;
  const int port = static_cast<int>(std::strtol(text.c_str() + colon + 1, nullptr, 16));
  text.resize(colon);
  return port;
}

}  // namespace

// Lines: "sl local remote state tx:rx tr:when retrans uid timeout inode ...".
std::vector<SocketEntry> bound_sockets(Protocol protocol, int pid) {
  constexpr std::string_view kListening = "0A";
  const std::string name = fmt::format("/proc/{}/net/{}", pid == 0 ? "self" : std::to_string(pid),
                                       protocol == Protocol::kTcp ? "tcp" : "udp");
  std::vector<SocketEntry> entries;

  for (const std::string& path : {name, name + "6"}) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);  // header

    while (std::getline(file, line)) {
      std::array<char, 48> local{};
      std::array<char, 48> remote{};
      std::array<char, 8> state{};
      SocketEntry entry;
      if (std::sscanf(line.c_str(), " %*s %47s %47s %7s %*s %*s %*s %u %*s %lu", local.data(),
                      remote.data(), state.data(), &entry.user, &entry.inode) != 5) {
        continue;
      }

      entry.host = local.data();
      entry.peer_host = remote.data();
      entry.port = split_port(entry.host);
      entry.peer_port = split_port(entry.peer_host);
      entry.listens = state.data() == kListening;
      entries.push_back(std::move(entry));
    }
  }
  return entries;
}

std::set<unsigned long> sockets_of(int pid) {
  std::set<unsigned long> inodes;
  std::error_code code;
  for (fs::directory_iterator fd(fmt::format("/proc/{}/fd", pid), code), end; !code && fd != end;
       fd.increment(code)) {
    std::error_code unreadable;
    const std::string target = fs::read_symlink(fd->path(), unreadable).string();
    unsigned long inode = 0;
    if (std::sscanf(target.c_str(), "socket:[%lu]", &inode) == 1) inodes.insert(inode);
  }
  return inodes;
}

}  // namespace cls::process
