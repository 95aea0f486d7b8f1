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
status encode cube.obj cube_percent.dmsh --max-error 0.001%
rm cube_percent.dmsh
run encode cube.obj cube.dmsh --max-error far
run encode cube.obj cube.dmsh --normal-error -1
run encode cube.obj cube.dmsh --uv-error 1/0
run encode cube.obj cube.dmsh --uv-error 1/many
run encode cube.obj cube.dmsh --color-error 3%
run encode cube.obj cube.dmsh --color-error 256
run encode cube.obj cube.dmsh --normal-error 181
run encode cube.obj cube.dmsh --max-error inf
run encode cube.obj cube.dmsh --max-error none
quiet encode cube.obj cube.dmsh --max-error 1/3%
run encode cube.obj cube.dmsh --weight-error inf
run encode cube.obj cube.dmsh --tangent-error
run encode cube.obj cube.dmsh --attribute-error intensity
run encode cube.obj cube.dmsh --attribute-error =1
run encode cube.obj cube.dmsh --attribute-error intensity=much
run encode cube.obj cube.dmsh --attribute-error intensity=1 --attribute-error intensity=2
run encode cube.obj cube.dmsh --lossless --attribute-rms intensity=1
run encode cube.obj cube.dmsh --attribute-error intensity=1
run encode cube.obj cube.dmsh --lossless --color-error 2
run encode cube.obj cube.dmsh --color-rms 0
run encode cube.obj cube.dmsh --color-rms 2 --color-error 2
run encode cube.obj cube.dmsh --color-psnr 40 --color-rms 2
run encode cube.obj cube.dmsh --lossless --color-psnr 40
run gltf pack cube.glb packed.glb --normal-error nan
run gltf pack cube.glb packed.glb --lossless --uv-error 0
run encode cube.obj cube.dmsh --anchor-density 0
run encode cube.obj cube.dmsh --anchor-bits 30
run encode cube.obj cube.dmsh --profile best
run encode cube.obj cube.dmsh --anchors -3
run encode cube.obj cube.dmsh --target-bytes -4
run encode cube.obj cube.dmsh --fast
run encode cube.xyz cube.dmsh
run encode cube.dmsh cube.dmsh
run decode cube.dmsh cube.txt
run decode cube.dmsh cube
run compare cube.obj cube.obj --heatmap map.png
run generate castle castle.ply
run generate sphere sphere.jpeg
run generate sphere sphere.ply --vertices 3
run generate sphere sphere.ply --seed -1
run tiles encode city -1
list
