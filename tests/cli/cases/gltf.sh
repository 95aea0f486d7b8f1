quiet generate cad plain.glb --vertices 600
figures gltf pack plain.glb packed.glb
figures gltf pack plain.glb fallback.glb --fallback
figures gltf unpack packed.glb unpacked.glb
run compare unpacked.glb fallback.glb
run encode packed.glb packed.dmsh
status encode fallback.glb fallback.dmsh
[ "$(stat -c %s packed.glb)" -lt "$(stat -c %s plain.glb)" ] && say "packed is smaller"
quiet gltf pack plain.glb text.gltf
ls text.*
quiet gltf unpack text.gltf text_unpacked.glb
cmp text_unpacked.glb unpacked.glb
cp plain.glb same.glb
quiet gltf pack same.glb same.glb
cmp same.glb packed.glb && say "in and out may be one file"
status gltf pack plain.glb packed.ply
status gltf pack plain.glb /dev/full
status gltf
head -c 100 packed.glb >cut.glb
status gltf unpack cut.glb out.glb
status gltf pack cut.glb out.glb
list
