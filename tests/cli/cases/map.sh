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
grep -c '"level"' .out
grep '"color_rms"' .out
quiet map join levels.map coarse.ply --level 5
status map join levels.map coarse.ply --level 25
run map join levels.map coarse.ply --level 6
run map join rooms.map coarse.ply --level 4
rm -r levels.map coarse.ply
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
echo damaged >bounds.map/bounds.json
run map split rooms.ply bounds.map --part-edge 2
rm -r kept.map kept.json none.ply more.ply bounds.map
status map split rooms.ply other.map --part-edge 0
status map split rooms.ply other.map
status map split rooms.ply other.map --part-edge 1 --target-bytes 1000
status map join rooms.map out.xyz
status map join nowhere out.ply
rm "$(ls rooms.map/parts/*.part | head -1)"
status map join rooms.map out.ply
echo damaged >>again.map/map.dmm
status map info again.map
status map
rm -r a.json info.json a.dmsh b.dmsh
list
