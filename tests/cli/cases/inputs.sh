# Missing, unreadable, empty and broken inputs end with exit code 3, and write nothing.
mkdir folder.ply folder.dmsh
for command in "encode none.ply out.dmsh" "decode none.dmsh out.ply" "info none.dmsh" "verify none.dmsh" \
               "compare none.ply none.ply" "gltf pack none.glb out.glb" "gltf unpack none.glb out.glb"; do
  run $command
done
run encode folder.ply out.dmsh
run decode folder.dmsh out.ply
for suffix in ply stl off glb gltf; do
  : >empty.$suffix
  status encode empty.$suffix out.dmsh
done
say "an OBJ file without any line is an empty mesh:"
: >nothing.obj
run encode nothing.obj nothing.dmsh --json | grep -E 'exit|"vertices"'
run decode nothing.dmsh nothing.ply
printf 'ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n' >liar.ply
status encode liar.ply out.dmsh
printf 'v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n' >nan.obj
status encode nan.obj out.dmsh
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >range.off
status encode range.off out.dmsh
say "coordinates from 1e-40 to 3e38, which the solver copes with:"
state=1
for ((y = 0; y < 70; ++y)); do
  for ((x = 0; x < 70; ++x)); do
    state=$((state * 1103515245 + 12345 & 0x7fffffff))
    size=$((state >> 16 & 1 ? 34 : -44))
    echo "v $((428 * x))e$size $((428 * y))e$size $((state >> 17))e$size"
    ((x > 0 && y > 0)) && echo "f $((70 * y + x + 1)) $((70 * y + x)) $((70 * y + x - 69))"
  done
done >uneven.obj
run encode uneven.obj uneven.dmsh --bits 8 --json | grep -E 'exit|"vertices"'
cube cube.obj
: >empty.order
printf 'abc' >odd.order
printf '\x09\x00\x00\x00' >short.order
run compare cube.obj cube.obj --order none.order
run compare cube.obj cube.obj --order empty.order
run compare cube.obj cube.obj --order odd.order
run compare cube.obj cube.obj --order short.order
run compare cube.obj empty.ply
rm -f ./*.order
list
# A vertex far away that no face uses costs the others nothing.
printf 'v 1e8 1e8 1e8\nv 100000001 1e8 1e8\nv 1e8 100000001 1e8\nv 1e38 0 0\nf 1 2 3\n' >far.obj
quiet encode far.obj far.dmsh
"$program" compare far.obj far.dmsh | grep 'max error'
# Where it is kept, what it loses is told.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 123456789.1 0 0\nf 1 2 3\n' >unused.obj
run encode unused.obj unused.dmsh --keep-unreferenced --lossless --strict
run encode unused.obj unused.dmsh --lossless --strict | grep exit
