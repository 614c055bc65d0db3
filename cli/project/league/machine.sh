# Functions of start and kill; $here is the folder of the package.

# The folder with what is known of the Playmaker of this machine: in the package, else in that for
# temporary files. Hosts and containers may share either, so its name is that of the running kernel and
# of its network. Sets state; empty: both are read-only.
find_state() {
  machine=$({ cat /proc/sys/kernel/random/boot_id; readlink /proc/self/ns/net; pwd; } 2>/dev/null | cksum)
  state=
  for folder in "$here/run" "${TMPDIR:-/tmp}/cls-team-$(id -u)"; do
    if mkdir -p "$folder" 2>/dev/null && [ -O "$folder" ] && [ -w "$folder" ]; then
      state=$folder/${machine%% *}
      return
    fi
  done
}

# The processes that a process has started.
children_of() {
  for stat in /proc/[0-9]*/stat; do
    # PID (NAME) STATE PARENT ...: the name may have spaces and parentheses.
    read -r line 2>/dev/null <"$stat" || continue
    rest=${line##*) }
    rest=${rest#* }
    [ "${rest%% *}" != "$1" ] || echo "${line%% *}"
  done
}

# Children first: the command of the Playmaker may be a script.
end_tree() {
  for child in $(children_of "$1"); do end_tree "$child"; done
  kill "$1" 2>/dev/null || true
}
