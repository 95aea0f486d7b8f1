quiet generate rooms a.ply --vertices 12000 --seed 1
quiet generate rooms b.ply --vertices 12000 --seed 2
ask="--part-edge 2 --max-error 0.004 --color-error 4 --part-triangles 2000 --tile-triangles 8000"
quiet tiles plan whole.map a.ply b.ply $ask
say "a plan for which there is no room leaves the one before:"
cp -r whole.map killed.map
(
  trap '' XFSZ
  ulimit -f 1
  "$program" tiles plan whole.map a.ply $ask >/dev/null 2>&1
  say "exit $?"
)
diff -r whole.map killed.map && say "unchanged"
tiles=$(($(grep -c '"triangles"' whole.map/tiles/plan.json) - 1))
status tiles finish whole.map
for tile in $(seq 0 "$tiles"); do quiet tiles encode whole.map "$tile"; done
quiet tiles finish whole.map
figures map info whole.map
# Each is killed after a longer time, the last ones not before they are done; the others are run again.
delay=0
for tile in $(seq "$tiles" -1 0); do
  "$program" tiles encode killed.map "$tile" >.out 2>.err &
  sleep "0.0$((delay % 10))"
  kill -9 $! 2>/dev/null
  wait $! 2>/dev/null
  delay=$((delay + 3))
done
for tile in $(seq 0 "$tiles"); do quiet tiles encode killed.map "$tile"; done
quiet tiles finish killed.map
diff -r whole.map killed.map && say "killed and run again: the same bytes"
quiet map join killed.map joined.ply
status tiles encode whole.map 1000
run tiles encode nowhere 0
run tiles finish nowhere
run tiles plan other.map a.ply --part-edge 2
run tiles plan other.map a.ply --part-edge 2 --max-error 0.1%
run tiles plan other.map a.ply --part-edge 2 --max-error 0.1 --tile-triangles 10000
status tiles plan other.map missing.ply --part-edge 2 --max-error 0.1
# Of a finished map `map split` makes the same parts within the same bounds; tiles begin a new epoch of it.
ask="--part-edge 2 --color-error 4 --part-triangles 2000"
quiet tiles plan one.map a.ply $ask --max-error 0.004
quiet tiles encode one.map 0
quiet tiles finish one.map
quiet map split a.ply one.map $ask --json
grep -E '"(epoch|revision|new_parts|keeps_bounds)"' .out
quiet map split b.ply one.map $ask
run tiles finish one.map
quiet tiles plan one.map a.ply $ask --vde 0.002 --max-error none
run tiles finish one.map
quiet tiles encode one.map 0
quiet tiles finish one.map
quiet map info one.map --json
grep -E '"(epoch|revision)"' .out
cat one.map/bounds.json
# Without it nothing tells which bounds on attributes the map keeps.
mv one.map/bounds.json kept.json
run tiles plan one.map a.ply --part-edge 1 --max-error 0.01
mv kept.json one.map/bounds.json
quiet verify one.map
# Parts that are missing or damaged are told with what makes them again.
part=$(ls one.map/parts/*.part | head -1)
nameless() { sed "s,${part##*/},PART,g"; }
cp "$part" kept.part
for damage in missing damaged; do
  rm -f "$part"
  [ $damage = damaged ] && echo damaged >"$part"
  for command in 'tiles finish' verify 'map info'; do
    capture $command one.map
    say "$command: exit $code"
    nameless <.err
  done
done
cp kept.part "$part"
quiet tiles finish one.map
cp one.map/tiles/0.tile other.tile
quiet tiles plan one.map a.ply $ask --vde 0.002 --max-error none
cp other.tile one.map/tiles/0.tile
run tiles finish one.map
echo damaged >one.map/tiles/0.tile
run tiles finish one.map
cp one.map/tiles/plan.json plan.json
for change in 's/"geometry": 0/"geometry": 99/' 's/"effort": 1/"effort": -1/' 's/"vde": "0.002"/"vde": "-1"/' \
  's/"vde": "0.002"/"vde": "0.1%"/' 's/"normal_error": 0.5/"normal_error": "0.5"/' 's/"revision": 4/"revision": 1e30/' \
  's/"drop_invalid": false/"drop_invalid": 0/' 's/"triangles": [0-9]*/"triangles": null/' 's/"effort"/"effect"/'; do
  sed "$change" plan.json >one.map/tiles/plan.json
  run tiles finish one.map
done
# Files that do not fit together, or are others than planned with.
cube cube.obj
sed '/^f/i vn 0 0 1' cube.obj | sed -E '/^f/s/([0-9]+)/\1\/\/1/g' >normals.obj
run tiles plan other.map normals.obj cube.obj --part-edge 2 --max-error 0.1
(cat cube.obj; echo "v 9 9 9") >lonely.obj
run tiles plan lonely.map lonely.obj cube.obj lonely.obj --part-edge 2 --max-error 0.1
quiet tiles plan other.map cube.obj --part-edge 2 --max-error 0.1
sed -i '/^v/s/1/0.99/' cube.obj
capture tiles encode other.map 0
say "exit $code: $(sed "s,$PWD/,," .err)"
printf 'v nan 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 2 3 4\n' >nan.obj
run tiles plan other.map nan.obj --part-edge 2 --max-error 0.1
quiet tiles plan other.map nan.obj --part-edge 2 --max-error 0.1 --drop-invalid
run tiles encode other.map 0
echo damaged >whole.map/tiles/plan.json
run tiles finish whole.map
