#!/usr/bin/env bash
# run.sh PUBLISHER SUBSCRIBER: both for a few seconds, over loopback, and once more for a minute where that was not enough for a busy
# machine; fails unless the subscriber gets the whole map.
set -euo pipefail
port_file=$(mktemp)
publisher=
stop() { kill "$publisher" 2>/dev/null || true; }
trap 'stop; rm -f "$port_file"' EXIT
for seconds in 10 60; do
  "$1" 0 $((seconds + 2)) >"$port_file" &
  publisher=$!
  for _ in {1..50}; do
    [ -s "$port_file" ] && break
    sleep 0.1
  done
  shown=$("$2" "$(cat "$port_file")" "$seconds")
  echo "$shown"
  if grep -q ' 32768 triangles, [1-9]' <<<"$shown"; then exit 0; fi
  stop
done
exit 1
