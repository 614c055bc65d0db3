#!/bin/sh
# Posts the events of matches to a chat, with curl. In cls.toml:
#
#   on_event = "WEBHOOK_URL=https://chat.example/hooks/KEY ./webhook.sh"
#
# The message is {"text": "RED 2:1 BLUE, goal by RED (cycle 1234)"}, as Slack, Mattermost and Rocket.Chat take it; WEBHOOK_FIELD=content
# is for Discord. EVENTS="start goal end" chooses events; without it all are posted.
set -eu

: "${WEBHOOK_URL:?is not set; example: WEBHOOK_URL=https://chat.example/hooks/KEY}"

case " ${EVENTS:-$CLS_EVENT} " in
  *" $CLS_EVENT "*) ;;
  *) exit 0 ;;
esac

# A number and stage where it is a match of a tournament.
text="${CLS_MATCH:+match $CLS_MATCH, $CLS_STAGE: }$CLS_TEXT"
escaped=$(printf '%s' "$text" | sed 's/\\/\\\\/g; s/"/\\"/g')

printf '{"%s": "%s"}' "${WEBHOOK_FIELD:-text}" "$escaped" |
  curl --silent --show-error --fail --max-time 10 --retry 2 \
    --header 'Content-Type: application/json' --data-binary @- --output /dev/null "$WEBHOOK_URL"
