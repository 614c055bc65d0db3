// The other host needs sh, tar, gzip, sha256sum and mkfifo, and no installation.
//
// There, ROOT/objects/HASH are teams and programs: a copy that breaks off has another hash and is
// not used. ROOT/jobs/TOKEN/JOB is the folder of one match, a small tournament of its own in which
// `cls tournament work` plays. It stays until its result is on this host, so that a connection or a
// process that ends at any moment loses at most a match that was being played.
#include "tournament/run/hosts_scripts.h"

#include <fmt/format.h>

#include "process/command_plan.h"

namespace cls::tournament {

const char* const kPackScript = R"(
set -eu
mkdir -p hosts/objects
new=hosts/objects/.new.$$
trap 'rm -f "$new"' EXIT
for what; do
  if [ -d "$what" ]; then
    tar -I 'gzip -n -1' --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner \
      -C "$what" -cf "$new" .
  else
    cp "$what" "$new"
  fi
  hash=$(sha256sum <"$new")
  hash=${hash%% *}
  sync "$new" 2>/dev/null || sync
  mv "$new" "hosts/objects/$hash"
  echo "object $hash"
done
)";

namespace {

// After the assignment of unreachable and no_result, the exit codes.
constexpr const char* kPlayScript = R"(
set -u
job=$1 token=$2 remote=$3 root=$4 label=$5
shift 5
there=$root/jobs/$token/$job
tmp=unfinished/$job.$label
index=${job%%.*}

on_host() { sh -c "$remote \"\$1\"" sh "$1"; }
unreachable() { echo "cls: $1" >&2; rm -rf "$tmp"; exit $unreachable; }

mkdir -p "$tmp" results matches

# An object of another content (a power cut, a foreign hand) is copied again.
present=$(on_host "mkdir -p $root/objects $there && cd $root/objects && for hash in $*; do
  [ -f \$hash ] || continue
  echo \"\$hash  \$hash\" | sha256sum -c --status && echo \$hash || rm -f \$hash
done" </dev/null) || unreachable "cannot be reached"
for hash; do
  case "
$present
" in *"
$hash
"*) continue ;; esac
  on_host "cd $root/objects && cat >.$hash.$job && echo '$hash  .$hash.$job' | sha256sum -c --status && chmod +x .$hash.$job && { sync .$hash.$job 2>/dev/null || sync; } && mv .$hash.$job $hash" <"hosts/objects/$hash" ||
    unreachable "the copy of a team or of cls failed"
done
tar -C "hosts/$job" -cf - . | on_host "tar -C $there -xf -" || unreachable "the copy of the job failed"

# An end of this script ends the match there: its stdin is open as long as this.
mkfifo "$tmp/hold"
exec 3<>"$tmp/hold"
on_host "cd $there && sh ./run.sh" <&3 >"$tmp/result.tgz"
code=$?
exec 3>&-
[ $code -eq 0 ] || { rm -rf "$tmp"; [ $code -eq $no_result ] && exit $no_result; echo "cls: the connection ended with exit code $code" >&2; exit $unreachable; }

# Links, devices and pipes are no results, and no program of this host gets rights by one.
list=$(tar -tvzf "$tmp/result.tgz") || unreachable "the result did not arrive as a whole"
strange=$(printf '%s\n' "$list" | grep -v '^[-d]' | head -n 1)
[ -z "$strange" ] || unreachable "the result holds what is neither a file nor a folder: $strange"
tar -C "$tmp" -xzf "$tmp/result.tgz" || unreachable "the result did not arrive as a whole"
chmod -R u=rwX,g-sw,o-w "$tmp/results" "$tmp/matches" 2>/dev/null || :
[ -s "$tmp/results/$job.json" ] || unreachable "the result did not arrive"
if [ ! -e "results/$job.json" ]; then
  for folder in "$tmp/matches/$index"-*; do
    [ -d "$folder" ] || continue
    rm -rf "matches/${folder##*/}"
    mv "$folder" matches/
  done
  sync "$tmp/results/$job.json" 2>/dev/null
  mv "$tmp/results/$job.json" "results/$job.json"
fi
rm -rf "$tmp"
on_host "rm -rf $there" </dev/null || :
)";

// {0}: number, {1}: attempt, {2}: commands that unpack teams, {3}: hash of the program, {4}: the
// name of the result, {5}: kNoResult.
constexpr const char* kHostScript = R"(#!/bin/sh
# Plays match {0} in this folder, and sends its result to the host that has started it.
root=../../..
if [ ! -s results/{4} ]; then
  rm -rf unfinished teams match-events.jsonl
  mkdir teams
{2}
  mkfifo match-events.jsonl
  cat match-events.jsonl >&2 &
  events=$!
  exec 3<&0 4>match-events.jsonl
  "$root/objects/{3}" tournament work . --index {0} --attempt {1} </dev/null >work.log 2>&1 3<&- 4>&- &
  work=$!
  (while read -r line <&3; do :; done; kill "$work") >/dev/null 2>&1 4>&- &
  watch=$!
  wait "$work"
  kill "$watch" 2>/dev/null
  exec 3<&- 4>&-
  wait "$events"
fi
[ -s results/{4} ] || {{ tail -n 1 work.log >&2; exit {5}; }}
set -- results
[ ! -d matches ] || set -- results matches
tar -czf - "$@"
)";

}  // namespace

std::string play_script() {
  return fmt::format("unreachable={} no_result={}{}", kHostUnreachable, kNoResult, kPlayScript);
}

std::string host_script(int index, int attempt, const std::vector<HostObject>& objects) {
  std::string unpack;
  std::string program;
  for (const HostObject& object : objects) {
    if (object.name.empty()) {
      program = object.hash;
      continue;
    }
    const std::string folder = process::shell_quoted("teams/" + object.name);
    unpack += fmt::format("  mkdir {0} && tar -C {0} -xzf \"$root/objects/{1}\" || exit {2}\n",
                          folder, object.hash, kNoResult);
  }
  return fmt::format(fmt::runtime(kHostScript), index, attempt, unpack, program,
                     fmt::format("{:06}.{}.json", index, attempt), kNoResult);
}

}  // namespace cls::tournament
