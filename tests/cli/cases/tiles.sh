quiet generate rooms a.ply --vertices 12000 --seed 1
quiet generate rooms b.ply --vertices 12000 --seed 2
ask="--part-edge 2 --max-error 0.004 --color-error 4 --part-triangles 2000 --tile-triangles 8000"
quiet tiles plan whole.map a.ply b.ply $ask
cp -r whole.map killed.map
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
status tiles encode nowhere 0
status tiles plan other.map a.ply --part-edge 2
status tiles plan other.map a.ply --part-edge 2 --max-error 0.1%
status tiles plan other.map missing.ply --part-edge 2 --max-error 0.1
echo damaged >whole.map/tiles/plan.json
run tiles finish whole.map
