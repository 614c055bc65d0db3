// Starts xdg-open.
#include "cli/support/browser.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <utility>

#include "base/io/whole_file.h"
#include "base/text/percent_encoding.h"
#include "base/text/xml.h"

namespace cls::cli {
namespace {

bool has_display() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return true;
  }
  return false;
}

}  // namespace

std::string file_url(const std::filesystem::path& file) {
  std::error_code code;
  const std::filesystem::path whole = std::filesystem::absolute(file, code).lexically_normal();
  return "file://" + base::percent_encoded(whole.string());
}

bool open_in_browser(const std::string& url) {
  if (!has_display()) return false;

  posix_spawn_file_actions_t quiet;
  if (posix_spawn_file_actions_init(&quiet) != 0) return false;
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&quiet, descriptor, "/dev/null", O_RDWR, 0);
  }

  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t ignored;
  sigemptyset(&ignored);
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&ignored, signal);
  posix_spawnattr_setsigdefault(&attributes, &ignored);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);

  std::string program = "xdg-open";
  std::string argument = url;
  std::array<char*, 3> arguments = {program.data(), argument.data(), nullptr};

  pid_t process = 0;
  const int failed =
      posix_spawnp(&process, program.c_str(), &quiet, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&quiet);
  return failed == 0;
}

std::unique_ptr<process::ScratchFolder> open_privately(const std::string& url) {
  if (!has_display()) return nullptr;
  auto folder = process::ScratchFolder::create();
  if (!folder) return nullptr;

  const std::filesystem::path page = folder->path() / "watch.html";
  const std::string text = fmt::format(
      "<!doctype html><meta charset=\"utf-8\"><meta name=\"referrer\" content=\"no-referrer\">"
      "<meta http-equiv=\"refresh\" content=\"0; url={0}\"><a href=\"{0}\">the match</a>\n",
      base::escape_xml(url));
  std::error_code code;
  const bool written = base::write_file(page, text).ok();
  std::filesystem::permissions(page, std::filesystem::perms(0600), code);
  if (!written || code || !open_in_browser(file_url(page))) return nullptr;
  return std::make_unique<process::ScratchFolder>(*std::move(folder));
}

}  // namespace cls::cli
