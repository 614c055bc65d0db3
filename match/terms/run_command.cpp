// Replaces placeholders of the shell command, and finds a name in it.
#include "match/terms/run_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "base/text/suggestion.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;

constexpr std::array<std::string_view, 4> kPlaceholders = {"port", "side", "name", "seed"};

// Replaces each {word} of lower-case letters without '$' before it by the result of `visit(word)`.
std::string replaced(std::string_view command,
                     const std::function<std::string(std::string_view)>& visit) {
  std::string result;
  std::size_t i = 0;

  while (i < command.size()) {
    const std::size_t end = command.find('}', i);
    const bool opens = command[i] == '{' && (i == 0 || command[i - 1] != '$');
    const std::string_view word = opens && end != std::string_view::npos
                                      ? command.substr(i + 1, end - i - 1)
                                      : std::string_view();
    const bool is_word =
        !word.empty() && std::ranges::all_of(word, [](char c) { return c >= 'a' && c <= 'z'; });
    if (is_word) {
      result += visit(word);
      i = end + 1;
    } else {
      result += command[i++];
    }
  }
  return result;
}

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::ranges::find(words, word) != std::end(words);
}

// A trainer has no side.
std::string_view side_word(soccer::Side side) {
  return side == soccer::Side::kNeutral ? "trainer" : side_name(side);
}

// "2-5, coach" -> "2-5_coach".
std::string file_part(std::string_view part) {
  std::string text;
  for (const char c : part) {
    if (c == ' ' || c == '\t' || c == '\n') continue;
    text += c == ',' ? '_' : c;
  }
  return text;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \t\n;&|()'\"");
    if (begin == std::string_view::npos) return words;
    const std::size_t end = std::min(text.find_first_of(" \t\n;&|()'\"", begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    text.remove_prefix(end);
  }
}

// "/opt/team/playmaker.py" -> "playmaker".
std::string stem_of(std::string_view word) {
  return std::filesystem::path(std::string(word)).stem().string();
}

// Commands that start the program.
bool is_launcher(std::string_view word) {
  constexpr std::string_view kLaunchers[] = {
      "bash",  "cd",  "deno",   "dotnet",  "env",  "exec", "go", "java", "nice", "node",
      "nohup", "npm", "python", "python3", "ruby", "run",  "sh", "time", "uv"};
  return contains(kLaunchers, stem_of(word));
}

// "./run", "../old/run": the script of a project of `cls new`.
bool is_project_script(std::string_view word) {
  const std::filesystem::path path(word);
  return path.has_parent_path() && path.filename() == "run";
}

}  // namespace

Result<void> check_run_command(std::string_view command) {
  if (command.find_first_not_of(" \t") == std::string_view::npos) {
    return Error{"no command after 'run:'"};
  }

  bool has_port = false;
  std::string mistake;
  replaced(command, [&](std::string_view word) {
    has_port = has_port || word == "port";
    const std::string_view near =
        base::nearest_name(word, {kPlaceholders.begin(), kPlaceholders.end()});
    if (!contains(kPlaceholders, word) && !near.empty() && mistake.empty()) {
      mistake = fmt::format("unknown placeholder {{{}}}; did you mean {{{}}}?", word, near);
    }
    return std::string();
  });

  if (!mistake.empty()) return Error{mistake};
  if (!has_port) {
    return Error{
        "the command needs {port}, the port on which the Playmaker listens (or start "
        "it yourself and use HOST:PORT)"};
  }
  return {};
}

std::string fill_in(std::string_view command, const RunValues& values) {
  return replaced(command, [&](std::string_view word) {
    if (word == "port") return std::to_string(values.port);
    if (word == "side") return std::string(side_word(values.side));
    if (word == "name") return process::shell_quoted(values.team_name);
    if (word == "seed") return std::to_string(values.seed);
    return fmt::format("{{{}}}", word);
  });
}

std::string playmaker_name(soccer::Side side, std::string_view part) {
  return part.empty() ? fmt::format("{} Playmaker", side_word(side))
                      : fmt::format("{} Playmaker ({})", side_word(side), part);
}

process::CommandPlan run_plan(std::string_view command, const RunValues& values,
                              const std::filesystem::path& folder) {
  const std::string name = playmaker_name(values.side, values.part);
  process::CommandPlan plan = process::shell_command(name, fill_in(command, values));
  const std::string suffix = values.part.empty() ? "" : "-" + file_part(values.part);
  plan.log = folder / fmt::format("{}-playmaker{}.log", side_word(values.side), suffix);
  // Python buffers output to a pipe; the last lines of a killed process would be lost.
  plan.environment.push_back({"PYTHONUNBUFFERED", "1"});
  return plan;
}

std::string program_in(std::string_view command) {
  bool skip = false;
  for (const std::string_view word : words_of(command)) {
    if (!skip && is_project_script(word)) return {};
    const bool is_folder = std::exchange(skip, word == "cd");
    const bool is_option = word.starts_with("-") || word.find('{') != std::string_view::npos;
    const bool is_assignment = word.find('=') != std::string_view::npos;
    if (is_folder || is_option || is_assignment || is_launcher(word)) continue;
    return stem_of(word);
  }
  const std::vector<std::string_view> words = words_of(command);
  return words.empty() ? std::string() : stem_of(words.front());
}

std::string folder_in(std::string_view command) {
  std::filesystem::path folder;
  bool changes = false;
  for (const std::string_view word : words_of(command)) {
    if (std::exchange(changes, word == "cd")) folder /= word;
    if (!is_project_script(word)) continue;
    return (folder / std::filesystem::path(word).parent_path()).string();
  }
  return ".";
}

}  // namespace cls::match
