// Messages with descriptors over SOCK_SEQPACKET, and plans as bytes.
#include "process/packet.h"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace cls::process {
namespace {

constexpr std::size_t kMaxPacket = 256 * 1024;
constexpr std::size_t kMaxFds = 8;

// A sequence of NUL-terminated strings.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  std::string text() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) {
      good_ = false;
      return {};
    }

    std::string field(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return field;
  }

  std::vector<FileLink> links() {
    std::vector<FileLink> all;
    for (int left = number(); left > 0 && good_; --left) {
      FileLink link{text(), {}};
      link.target = text();
      all.push_back(std::move(link));
    }
    return all;
  }

  std::vector<std::filesystem::path> paths() {
    std::vector<std::filesystem::path> all;
    for (int left = number(); left > 0 && good_; --left) all.emplace_back(text());
    return all;
  }

  int number() { return std::atoi(text().c_str()); }
  bool good() const { return good_; }

 private:
  std::string_view rest_;
  bool good_ = true;
};

void add(std::string& bytes, std::string_view field) {
  bytes += field;
  bytes += '\0';
}

void add_paths(std::string& bytes, const std::vector<std::filesystem::path>& paths) {
  add(bytes, std::to_string(paths.size()));
  for (const auto& path : paths) add(bytes, path.string());
}

}  // namespace

std::optional<std::pair<base::UniqueFd, base::UniqueFd>> make_socket_pair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return {};
  return std::pair(base::UniqueFd(ends[0]), base::UniqueFd(ends[1]));
}

bool send_packet(int socket, std::string_view bytes, const std::vector<int>& fds) {
  iovec part{const_cast<char*>(bytes.data()), bytes.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;

  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * kMaxFds)> control{};

  if (!fds.empty()) {
    const std::size_t size = sizeof(int) * fds.size();
    message.msg_control = control.data();
    message.msg_controllen = CMSG_SPACE(size);
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(size);
    std::memcpy(CMSG_DATA(header), fds.data(), size);
  }

  ssize_t sent = -1;
  do {
    sent = ::sendmsg(socket, &message, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent == static_cast<ssize_t>(bytes.size());
}

Packet receive_packet(int socket) {
  Packet packet;
  packet.bytes.resize(kMaxPacket);
  iovec part{packet.bytes.data(), packet.bytes.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * kMaxFds)> control{};

  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();

  ssize_t got = -1;
  do {
    got = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
  } while (got < 0 && errno == EINTR);

  packet.bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  if (got < 0) return packet;

  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr;
       header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
    std::array<int, kMaxFds> fds{};
    const std::size_t size = header->cmsg_len - CMSG_LEN(0);
    std::memcpy(fds.data(), CMSG_DATA(header), size);
    for (std::size_t i = 0; i < size / sizeof(int); ++i) packet.fds.emplace_back(fds[i]);
  }
  return packet;
}

bool send_report(int socket, const KeeperReport& report, int program) {
  return send_plain(socket, report, program < 0 ? std::vector<int>() : std::vector<int>{program});
}
bool send_request(int socket, const KeeperRequest& request) { return send_plain(socket, request); }

std::optional<KeeperReport> read_report(const Packet& packet) {
  return read_plain<KeeperReport>(packet);
}
std::optional<KeeperRequest> read_request(const Packet& packet) {
  return read_plain<KeeperRequest>(packet);
}

std::string encode(const CommandPlan& plan) {
  std::string bytes;
  add(bytes, plan.name);
  add(bytes, plan.folder.string());
  add(bytes, std::to_string(plan.argv.size()));

  for (const std::string& word : plan.argv) add(bytes, word);
  add(bytes, std::to_string(plan.environment.size()));
  for (const EnvironmentChange& change : plan.environment) {
    add(bytes, change.name);
    add(bytes, change.value ? "=" + *change.value : "");
  }

  add(bytes, std::to_string(plan.cpus.size()));
  for (const int cpu : plan.cpus) add(bytes, std::to_string(cpu));
  add(bytes, std::to_string(plan.limits.memory));
  add(bytes, std::to_string(plan.limits.cpu_seconds));
  add(bytes, std::to_string(plan.limits.processes));
  add(bytes, plan.empty_environment ? "1" : "0");
  add(bytes, plan.confined ? "1" : "0");
  add(bytes, plan.connections_trapped ? "1" : "0");
  add(bytes, std::to_string(plan.passed.size()));
  add(bytes, plan.files ? "1" : "0");

  if (!plan.files) return bytes;
  add_paths(bytes, plan.files->readable);
  add_paths(bytes, plan.files->writable);
  add_paths(bytes, plan.files->own);
  add(bytes, std::to_string(plan.files->links.size()));
  for (const FileLink& link : plan.files->links) {
    add(bytes, link.path.string());
    add(bytes, link.target.string());
  }
  add_paths(bytes, plan.files->covered);
  return bytes;
}

std::optional<CommandPlan> decode_plan(std::string_view bytes) {
  Fields fields(bytes);
  CommandPlan plan;
  plan.name = fields.text();
  plan.folder = fields.text();

  for (int left = fields.number(); left > 0 && fields.good(); --left) {
    plan.argv.push_back(fields.text());
  }
  for (int left = fields.number(); left > 0 && fields.good(); --left) {
    EnvironmentChange change{fields.text(), std::nullopt};
    const std::string value = fields.text();
    if (!value.empty()) change.value = value.substr(1);
    plan.environment.push_back(std::move(change));
  }
  for (int left = fields.number(); left > 0 && fields.good(); --left) {
    plan.cpus.push_back(fields.number());
  }

  plan.limits.memory = std::strtoull(fields.text().c_str(), nullptr, 10);
  plan.limits.cpu_seconds = fields.number();
  plan.limits.processes = fields.number();
  plan.empty_environment = fields.number() != 0;
  plan.confined = fields.number() != 0;
  plan.connections_trapped = fields.number() != 0;
  plan.passed.resize(static_cast<std::size_t>(std::max(0, fields.number())), -1);
  if (fields.number() != 0) {
    FileAccess& files = plan.files.emplace();
    files.readable = fields.paths();
    files.writable = fields.paths();
    files.own = fields.paths();
    files.links = fields.links();
    files.covered = fields.paths();
  }

  if (!fields.good() || plan.argv.empty()) return std::nullopt;
  return plan;
}

}  // namespace cls::process
