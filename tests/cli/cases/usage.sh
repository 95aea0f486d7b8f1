# Every way to get the command line wrong ends with exit code 2 and a line that says why.
status
status --help
for command in encode decode info verify compare generate "gltf pack" "gltf unpack"; do
  status $command --help
  grep -q "Usage: deltamesh $command" .out || say "no usage line"
  status $command
done
"$program" --help | grep -A 20 '^Exit codes'
"$program" --version | sed -E 's/[0-9]+/N/g'
run polish
cube cube.obj
run encode cube.obj
run encode cube.obj cube.dmsh --bits 8 --step 0.1
run encode cube.obj cube.dmsh --anchors 3 --anchor-density 5
run encode cube.obj cube.dmsh --bits eight
run encode cube.obj cube.dmsh --bits 99
run encode cube.obj cube.dmsh --step -1
run encode cube.obj cube.dmsh --vde much
run encode cube.obj cube.dmsh --max-error 0.001%
run encode cube.obj cube.dmsh --max-error far
run encode cube.obj cube.dmsh --anchor-density 0
run encode cube.obj cube.dmsh --anchor-bits 30
run encode cube.obj cube.dmsh --profile best
run encode cube.obj cube.dmsh --anchors -3
run encode cube.obj cube.dmsh --fast
run encode cube.xyz cube.dmsh
run encode cube.dmsh cube.dmsh
run decode cube.dmsh cube.txt
run decode cube.dmsh cube
run compare cube.obj cube.obj --heatmap map.png
run generate castle castle.ply
run generate sphere sphere.jpeg
run generate sphere sphere.ply --vertices 3
list
