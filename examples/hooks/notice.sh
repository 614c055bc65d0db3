#!/bin/sh
# Writes the events of matches to a file and, where there is a desktop, shows them as notices. In cls.toml:
#
#   on_event = "./notice.sh notices.txt"
#
# Without a file name only the desktop shows them.
set -eu

line="$CLS_TIME $CLS_EVENT: ${CLS_MATCH:+match $CLS_MATCH, $CLS_STAGE: }$CLS_TEXT"
[ $# -eq 0 ] || printf '%s\n' "$line" >>"$1"

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] && command -v notify-send >/dev/null; then
  notify-send "$CLS_EVENT" "$CLS_TEXT"
fi
