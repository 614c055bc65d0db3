// The shell scripts that copy teams to another host, play a match there and bring the result back.
#pragma once

#include <string>
#include <vector>

namespace cls::tournament {

/// A file that other hosts need, named by the hash of its content: hosts/objects/HASH.
struct HostObject {
  std::string name;  ///< of a team; empty: the program `cls`
  std::string hash;  ///< SHA-256, hexadecimal
};

/// Exit codes of play_script().
inline constexpr int kHostUnreachable = 75;
inline constexpr int kNoResult = 70;

/// Prints "HASH" for each of its arguments in sequence and stores them in hosts/objects of the
/// working folder: the first, a program, as it is; folders as archives with equal bytes for equal
/// content. Needs GNU tar, gzip and sha256sum.
extern const char* const kPackScript;

/// Plays one match on a host: `sh -c SCRIPT play JOB TOKEN REMOTE ROOT LABEL OBJECT...` in the
/// tournament's folder. JOB is "000017.1"; REMOTE a shell command that runs its last argument on
/// the host; ROOT a folder there; LABEL the end of a name in unfinished/. hosts/JOB/ has what
/// the match needs but the objects. Afterwards results/JOB.json and the match folder are there, or
/// the exit code says why not.
std::string play_script();

/// hosts/JOB/run.sh, which runs on the host with the job's folder as working folder; events of the
/// match go to stderr, an archive of results to stdout. It ends the match when its stdin ends.
std::string host_script(int index, int attempt, const std::vector<HostObject>& objects);

}  // namespace cls::tournament
