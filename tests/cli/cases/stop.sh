# A stop signal leaves neither an output nor a temporary file.

# Runs the program, which writes to the folder out, and stops it after $1 seconds, or sooner where it was done by then.
stopped() {
  local longest=$1
  shift
  for pause in $longest 0.1 0.05 0.02; do
    rm -rf out
    mkdir out
    timeout --signal=INT $pause "$program" "$@" >/dev/null 2>&1
    code=$?
    [ $code = 0 ] || break
  done
  say "exit $code, files left: $(ls out | wc -l)"
}

stopped 0.05 generate rooms out/rooms.ply --vertices 2000000
stopped 0.3 generate rooms out/rooms.ply --vertices 2000000
quiet generate sphere sphere.ply --vertices 200000
stopped 0.1 encode sphere.ply out/sphere.dmsh --lfe 0.001% --effort 2 --order-out out/sphere.order
stopped 0.5 encode sphere.ply out/sphere.dmsh --lfe 0.001% --effort 2 --order-out out/sphere.order
