// Thread that reads reports and output of all children.
#include "process/process_host_core.h"

#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <string>
#include <utility>

namespace cls::process {
namespace {

constexpr std::size_t kReadSize = 64 * 1024;
constexpr int kMaxReadsPerTurn = 16;  // of one child, before the next one is read

// Reads what is in the pipe. False when it was closed by its last writer.
bool read_output(ChildRecord& record) {
  std::array<char, kReadSize> bytes;
  for (int i = 0; i < kMaxReadsPerTurn; ++i) {
    const ssize_t got = ::read(record.output.get(), bytes.data(), bytes.size());
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    if (got == 0) return false;
    record.log.add({bytes.data(), static_cast<std::size_t>(got)});
  }
  return true;
}

// The number here of the process that a descriptor stands for; 0: it has exited.
int process_of(const base::UniqueFd& descriptor) {
  std::ifstream information("/proc/self/fdinfo/" + std::to_string(descriptor.get()));
  for (std::string word; information >> word;) {
    int number = 0;
    if (word == "Pid:" && information >> number) return std::max(number, 0);
  }
  return 0;
}

void drain_output(ChildRecord& record) {
  if (record.output && !read_output(record)) record.output.reset();
}

}  // namespace

ProcessHostCore::ProcessHostCore(std::size_t limit, base::UniqueFd wake_event)
    : log_limit(limit), wake_(std::move(wake_event)) {
  // Other threads of cls handle signals.
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { run(); });
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

ProcessHostCore::~ProcessHostCore() { stop(); }

void ProcessHostCore::add(std::shared_ptr<ChildRecord> record) {
  {
    const std::lock_guard lock(mutex);
    records.push_back(std::move(record));
  }
  wake();
}

void ProcessHostCore::wake() const {
  const std::uint64_t one = 1;
  while (::write(wake_.get(), &one, sizeof one) < 0 && errno == EINTR) {
  }
}

void ProcessHostCore::stop() {
  {
    const std::lock_guard lock(mutex);
    stopping_ = true;
  }
  wake();
  if (thread_.joinable()) thread_.join();
}

void ProcessHostCore::notify_change() {
  ++changes;
  changed.notify_all();
}

void ProcessHostCore::handle_report(ChildRecord& record) {
  const Packet packet = receive_packet(record.control.get());
  if (packet.bytes.empty()) {  // the keeper was killed, and the program with it
    if (!record.status.exit) record.status.exit = ProcessExit{true, SIGKILL};
    return mark_gone(record);
  }

  const auto report = read_report(packet);
  if (!report) return;
  record.cpu_seconds = std::max(record.cpu_seconds, report->cpu_seconds);
  record.delayed_seconds = std::max(record.delayed_seconds, report->delayed_seconds);
  record.status.at_cpu_limit = record.status.at_cpu_limit || report->at_cpu_limit;

  switch (report->kind) {
    case KeeperReport::Kind::kStarted:
    case KeeperReport::Kind::kFailed:
      record.first_report = *report;
      record.status.pid = packet.fds.empty() ? report->pid : process_of(packet.fds.front());
      break;
    case KeeperReport::Kind::kExited:
      drain_output(record);  // complete the output before reporting the exit
      record.status.exit = ProcessExit{report->by_signal, report->number};
      record.status.living = report->living;
      break;
    case KeeperReport::Kind::kUsage:
      ++record.usage_answers;
      break;
    case KeeperReport::Kind::kCpuLimit:
      break;
    case KeeperReport::Kind::kGone:
      return mark_gone(record);
  }
  notify_change();
}

void ProcessHostCore::mark_gone(ChildRecord& record) {
  drain_output(record);
  record.log.finish();
  record.output.reset();
  record.control.reset();
  record.status.gone = true;
  notify_change();
}

void ProcessHostCore::poll_child(ChildRecord& record) {
  std::array<pollfd, 2> waits{
      {{record.output.get(), POLLIN, 0}, {record.control.get(), POLLIN, 0}}};
  if (::poll(waits.data(), waits.size(), 0) <= 0) return;
  if (waits[0].revents != 0) drain_output(record);
  if (waits[1].revents != 0) handle_report(record);
}

void ProcessHostCore::run() {
  std::vector<pollfd> waits;
  std::unique_lock lock(mutex);
  while (!stopping_) {
    waits.assign(1, {wake_.get(), POLLIN, 0});
    for (const auto& record : records) {
      waits.push_back({record->control.get(), POLLIN, 0});
      if (record->output) waits.push_back({record->output.get(), POLLIN, 0});
    }

    lock.unlock();
    ::poll(waits.data(), waits.size(), -1);
    std::uint64_t ignored = 0;
    while (::read(wake_.get(), &ignored, sizeof ignored) > 0) {
    }

    lock.lock();
    for (const auto& record : records) poll_child(*record);
    std::erase_if(records, [](const auto& record) { return record->status.gone; });
  }
  for (const auto& record : records) mark_gone(*record);
  records.clear();
}

}  // namespace cls::process
