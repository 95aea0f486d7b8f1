quiet generate rooms rooms.ply --vertices 4000
figures map split rooms.ply rooms.map --part-edge 2 --max-error 0.004 --color-error 4
figures map info rooms.map
quiet map info rooms.map --json
cp .out info.json
has_keys info.json map_id frame epoch revision lattice_step cell_edge parts part_bytes primer_bytes vertices triangles max_error
quiet map join rooms.map joined.ply
quiet encode rooms.ply a.dmsh --lossless --json
cp .out a.json
quiet encode joined.ply b.dmsh --lossless --json
for key in triangles components; do
  [ "$(grep "\"$key\"" a.json)" = "$(grep "\"$key\"" .out)" ] && say "as many $key"
done
quiet map split rooms.ply levels.map --part-edge 2 --max-error 0.004 --levels 2 --json
cp .out levels.json
grep -c '"level"' .out
grep '"color_rms"' .out
# A coarser level has fewer bytes. Levels of the same parts are one line, and copies count in the bytes.
grep '"part_bytes"' levels.json | tr -dc '0-9\n' | { read -r finest; read -r _; read -r _; read -r _; read -r fourth; read -r fifth
  [ "$fifth" -lt "$fourth" ] && [ "$fourth" -lt "$finest" ] && say "each level has fewer bytes"; }
figures map info levels.map
quiet map join levels.map coarse.ply --level 5
status map join levels.map coarse.ply --level 25
run map join levels.map coarse.ply --level 6
run map join rooms.map coarse.ply --level 4
rm -r levels.map levels.json coarse.ply
cp -r rooms.map again.map
quiet map split rooms.ply again.map --part-edge 2 --max-error 0.004 --color-error 4 --json
grep -E '"(new_parts|revision|epoch)"' .out
figures map diff rooms.map again.map
quiet map split rooms.ply other.map --part-edge 1 --max-error 0.004 --color-error 4
status map diff rooms.map other.map --json
# Without bounds in model units a map keeps those that it began with.
printf 'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n' >none.ply
quiet map split none.ply kept.map --part-edge 2
quiet map split rooms.ply kept.map --part-edge 2
cp kept.map/bounds.json kept.json
quiet generate rooms more.ply --vertices 9000
quiet map split more.ply kept.map --part-edge 2 --json
grep -E '"(revision|epoch)"' .out
cmp kept.json kept.map/bounds.json && say "the same bounds"
# Other bounds are obeyed; without any those from before are kept, and told.
for ask in '--max-error 0.05' '--max-error 0.02%' '--max-error 0.02%' '' '--vde 0.01 --max-error none' '' '--lfe 0.05%'; do
  quiet map split rooms.ply bounds.map --part-edge 2 $ask
  say "$ask ->$(grep '^ *bounds' .out | tr -s ' ')"
done
# So are its number and frame, its levels and the size of its parts, until others are asked for.
quiet map split rooms.ply named.map --part-edge 2 --max-error 0.01 --map-id 7 --frame odom --levels 1 --part-triangles 500
for ask in '' '--levels 0' '' '--frame map'; do
  quiet map split more.ply named.map --part-edge 2 $ask
  say "$ask ->$(grep -E '^ *map ' .out | tr -s ' ')$(grep -o 'coarser copies$' .out)"
  cat named.map/bounds.json
done
# Without bounds.json nothing tells what the map keeps.
rm named.map/bounds.json
run map split more.ply named.map --part-edge 2
run map split more.ply named.map --part-edge 2 --max-error 0.01
quiet map split more.ply named.map --part-edge 2 --max-error 0.01 --color-error 4
# Where bounds.json cannot be written, the map is not written either.
mkdir -p unwritten.map/bounds.json
status map split rooms.ply unwritten.map --part-edge 2 --max-error 0.01
find unwritten.map -type f
mkdir empty
run verify empty
damaged_bounds() { echo "$1" >bounds.map/bounds.json; run map split rooms.ply bounds.map --part-edge 2; }
damaged_bounds damaged
damaged_bounds '{"asked":{"vde":"none"},"bounds":{}}'
damaged_bounds '{"asked":{"max_error":"none"},"bounds":{}}'
damaged_bounds '{"asked":{"lfe":7},"bounds":{}}'
damaged_bounds '{"asked":{},"bounds":{"lfe":"1%"}}'
damaged_bounds '{"asked":{}}'
damaged_bounds '{"asked":{},"bounds":{},"attributes":{"normal_error":181}}'
# Bounds on attributes are kept, too, until there are others.
rm -r bounds.map
for ask in '--color-error 4 --normal-error 2' '' '--color-psnr 30' '--max-error 0.01' ''; do
  quiet map split rooms.ply bounds.map --part-edge 2 $ask
  say "$ask ->$(grep -E '^ *(attribute )?bounds' .out | tr -s ' ' | tr '\n' ';')"
  quiet map split rooms.ply bounds.map --part-edge 2 --json
  grep -E '"(new_parts|attribute_bounds|keeps_attribute_bounds)"' .out
done
rm -r kept.map kept.json none.ply more.ply bounds.map
status map split rooms.ply other.map --part-edge 0
status map split rooms.ply other.map
status map split rooms.ply other.map --part-edge 1 --target-bytes 1000
run map split rooms.ply other.map --part-edge 1 --max-error none
run map split rooms.ply other.map --part-edge 1 --max-error 0
say "an error so small that the lattice does not reach as far:"
run map split rooms.ply fine.map --part-edge 2 --max-error 1e-7
run tiles plan fine.map rooms.ply --part-edge 2 --max-error 1e-7
status map join rooms.map out.xyz
run map join nowhere out.ply
figures map join rooms.map out.ply
run verify rooms.map
run info rooms.map
run decode rooms.map out.ply
# Parts that are missing or damaged are named, and written again.
cp -r rooms.map damaged.map
rm "$(ls damaged.map/parts/*.part | head -1)"
echo >>"$(ls damaged.map/parts/*.part | tail -1)"
for command in "verify damaged.map" "map info damaged.map" "map diff rooms.map damaged.map" "map join damaged.map out.ply"; do
  capture $command
  say "$command: exit $code"
  sed 's/_[0-9]*_[0-9a-f]*.part:/_N.part:/' .err
done
quiet map split rooms.ply damaged.map --part-edge 2 --color-error 4 --json
grep -E '"(new_parts|mended_parts)"' .out
diff -r rooms.map damaged.map && say "the same files"
: >damaged.map/map.dmm
run map split rooms.ply damaged.map --part-edge 2
echo damaged >>again.map/map.dmm
status map info again.map
rm -r damaged.map out.ply
status map
rm -r a.json info.json a.dmsh b.dmsh
list
say "vertices that are dropped are told:"
cube cube.obj
(cat cube.obj; echo "v 9 9 9"; echo "v 9 9 8") >lonely.obj
for mesh in cube lonely; do
  quiet map split $mesh.obj dropped.map --part-edge 2 --max-error 0.01
  grep unused .out
  quiet map split $mesh.obj dropped.map --part-edge 2 --json
  grep unreferenced .out
done
rm -r dropped.map cube.obj lonely.obj
say "what a map is made of is not removed or replaced:"
mkdir -p own.map/parts
cp rooms.ply own.map/parts/x.part.ply
run map split own.map/parts/x.part.ply own.map --part-edge 2
cmp rooms.ply own.map/parts/x.part.ply
rm -r own.map
quiet map split rooms.ply own.map --part-edge 2 --max-error 0.004
run map join own.map own.map/map.dmm --format ply
quiet verify own.map
rm -r own.map
say "one run at a time changes a map:"
quiet map split rooms.ply own.map --part-edge 2 --max-error 0.004
flock own.map "$program" map split rooms.ply own.map --part-edge 2 2>.err
say "exit $?: $(cat .err)"
quiet map split rooms.ply own.map --part-edge 2
run map split nowhere.ply new.map --part-edge 2
[ -e new.map ] || say "no folder is left"
rm -r own.map
