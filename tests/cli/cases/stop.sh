# A stop signal leaves neither an output nor a temporary file.
for pause in 0.05 0.3; do
  timeout --signal=INT $pause "$program" generate rooms rooms.ply --vertices 2000000 >/dev/null 2>&1
  say "exit $?"
done
quiet generate sphere sphere.ply --vertices 200000
timeout --signal=INT 0.5 "$program" encode sphere.ply sphere.dmsh --lfe 0.001% --effort 2 --order-out sphere.order >/dev/null 2>&1
say "exit $?"
list
