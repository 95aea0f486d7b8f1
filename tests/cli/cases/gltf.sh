quiet generate cad plain.glb --vertices 600
figures gltf pack plain.glb packed.glb
figures gltf pack plain.glb fallback.glb --fallback
figures gltf unpack packed.glb unpacked.glb
run compare unpacked.glb fallback.glb
figures compare plain.glb unpacked.glb
quiet gltf pack plain.glb coarse.glb --max-error 0.2% --normal-error 3 --uv-error 1/256
[ "$(stat -c %s coarse.glb)" -lt "$(stat -c %s packed.glb)" ] && say "coarser is smaller"
quiet gltf pack plain.glb coarse.glb --max-error 0.2% --normal-error 3 --uv-error 1/256 --json
cp .out pack.json
has_keys pack.json primitives converted streams vertices triangles stream_bytes input_bytes output_bytes max_error \
  max_error_percent attributes
"$program" gltf pack plain.glb coarse.glb --attribute-error _HEAT=1 2>&1 >/dev/null
rm coarse.glb pack.json
run encode packed.glb packed.dmsh
status encode fallback.glb fallback.dmsh
[ "$(stat -c %s packed.glb)" -lt "$(stat -c %s plain.glb)" ] && say "packed is smaller"
quiet gltf pack plain.glb text.gltf
ls text.*
quiet gltf unpack text.gltf text_unpacked.glb
cmp text_unpacked.glb unpacked.glb
cp plain.glb same.glb
run gltf pack same.glb ./same.glb
run gltf unpack packed.glb packed.glb
cmp same.glb plain.glb && say "the asset is not replaced"
run gltf pack same.glb -
run gltf pack plain.glb small.glb --target-bytes 100
quiet gltf pack plain.glb parts.gltf --lossless
sed 's/parts.bin/other.bin/' parts.gltf >renamed.gltf
cp parts.bin other.bin
run gltf pack renamed.gltf other.gltf
cmp parts.bin other.bin
sed 's/"asset": *{/"images":[{"uri":"image.bin"}],"asset":{/' parts.gltf >pictured.gltf
cp parts.bin image.bin
run gltf pack pictured.gltf image.gltf
cmp parts.bin image.bin
rm pictured.gltf image.bin renamed.gltf other.bin parts.bin
run gltf pack parts.gltf whole.glb
run encode parts.gltf whole.dmsh
rm parts.gltf
status gltf pack plain.glb packed.ply
status gltf pack plain.glb /dev/full
status gltf
head -c 100 packed.glb >cut.glb
status gltf unpack cut.glb out.glb
status gltf pack cut.glb out.glb
list
