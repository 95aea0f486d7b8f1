# What mesh files lose on their way is told, or is an error; pipes; wrong text names its line.
printf 'mtllib x.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nusemtl blue\nf 2 4 3\nl 1 2\n' >materials.obj
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty int label\nproperty double t\nelement face 1\nproperty list uchar int vertex_indices\nproperty uchar flags\nend_header\n0 0 0 7 1.5\n1 0 0 7 1.5\n0 1 0 7 1.5\n3 0 1 2 9\n' >properties.ply
say "encode:"
figures encode materials.obj materials.dmsh | grep -E 'left out|exit'
run encode properties.ply properties.dmsh --json | sed -n '/left_out/,/\]/p'
run encode materials.obj strict.dmsh --strict
run encode properties.ply strict.dmsh --strict
say "decode:"
for format in ply obj off stl glb; do
  run decode properties.dmsh "out.$format"
done
run decode materials.dmsh groups.obj
grep -c '^usemtl ' groups.obj
run decode properties.dmsh lost.off --strict
run decode properties.dmsh out.obj --json
say "names of groups, through streams and glTF:"
run decode materials.dmsh named.glb
status encode named.glb named.dmsh --strict
quiet decode named.dmsh named.obj
grep usemtl named.obj
say "colours as a screen shows them, and as linear light:"
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 188 1 254\n1 0 0 0 255 2\n0 1 0 188 77 3\n3 0 1 2\n' >grey.ply
quiet encode grey.ply grey.dmsh --keep-order
run decode grey.dmsh grey.glb
quiet encode grey.glb light.dmsh --keep-order
run decode light.dmsh back.off
sed -n '3,5p' back.off
quiet compare grey.ply grey.glb
grep colours .out
say "doubles, and a vertex far away:"
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n10000.0001 0 0\n0 10000.0001 0\n3 0 1 2\n' >wide.ply
run encode wide.ply wide.dmsh --lossless | grep -E 'lossless|max error|exit'
run encode wide.ply wide.dmsh --lossless --strict
run encode wide.ply wide.dmsh --max-error 0.00005
quiet generate terrain hills.obj --vertices 900
(echo 'v 1e7 0 0'; cat hills.obj; echo 'f -1 -2 -900') >stray.obj
quiet encode stray.obj stray.dmsh
figures info stray.dmsh | grep -E 'stray|exit'
say "compare, map:"
run compare materials.obj properties.ply | grep -E 'left out|exit'
quiet compare materials.obj properties.ply --json
cp .out compare.json
has_keys compare.json left_out_a left_out_b
run map split materials.obj small.map --part-edge 10 --max-error 0.01 | grep -E 'left out|exit'
run tiles plan tiles.map materials.obj --part-edge 10 --max-error 0.01
run tiles plan tiles.map materials.obj --part-edge 10 --max-error 0.01 --strict
run map split materials.obj other.map --part-edge 10 --max-error 0.01 --strict
status map join small.map joined.stl
say "points, and vertices that are not finite:"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >points.obj
run encode points.obj points.dmsh
run map split points.obj points.map --part-edge 1
status encode points.obj points.dmsh --keep-unreferenced
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv nan 1 0\nf 1 2 3\nf 2 4 5\n' >nan.obj
run encode nan.obj nan.dmsh
figures encode nan.obj nan.dmsh --drop-invalid | grep -E 'left out|triangles|exit'
run map split nan.obj nan.map --part-edge 1 --max-error 0.01
status map split nan.obj nan.map --part-edge 1 --max-error 0.01 --drop-invalid
say "text at fault:"
printf 'v 0 0 -1.#IND\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >number.obj
run encode number.obj number.dmsh
printf 'OFF3 1 0\n0 0 0\n1 0 0\n0 1,5 0\n3 0 1 2\n' >number.off
run encode number.off number.dmsh
printf 'solid x\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 zero' >number.stl
run encode number.stl number.dmsh
cp materials.obj materials.xyz
run encode materials.xyz x.dmsh
status encode materials.xyz x.dmsh --format obj
run encode materials.xyz x.dmsh --format xyz
run decode materials.dmsh materials.xyz
say "pipes:"
"$program" encode - - --format obj <materials.obj 2>/dev/null >piped.dmsh
cmp materials.dmsh piped.dmsh
"$program" decode - - --format ply <piped.dmsh 2>report | "$program" encode - again.dmsh --format ply >/dev/null
say "exit $?"
cat report
"$program" decode - joined.obj <piped.dmsh
"$program" info - --json <piped.dmsh | grep '"vertices"'
"$program" verify - <piped.dmsh
"$program" compare - materials.obj <piped.dmsh | head -1
run encode - x.dmsh </dev/null
run decode materials.dmsh -
"$program" compare properties.ply - --format obj <materials.obj | head -1
