#!/usr/bin/env bash
# run.sh PUBLISHER SUBSCRIBER: both for a few seconds, over loopback; fails unless the subscriber gets the whole map.
set -euo pipefail
port_file=$(mktemp)
"$1" 0 12 >"$port_file" &
publisher=$!
trap 'kill "$publisher" 2>/dev/null || true; rm -f "$port_file"' EXIT
for _ in {1..50}; do
  [ -s "$port_file" ] && break
  sleep 0.1
done
shown=$("$2" "$(cat "$port_file")" 10)
echo "$shown"
grep -q ' 32768 triangles, [1-9]' <<<"$shown"
