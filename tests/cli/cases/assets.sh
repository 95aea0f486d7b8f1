# Assets as other programs write them.
quiet generate sphere ball.ply --vertices 400
quiet encode ball.ply ball.dmsh
quiet decode ball.dmsh plain.glb
quiet decode ball.dmsh plain.gltf
quiet encode plain.glb plain.dmsh
same() { quiet encode "$1" .same.dmsh && cmp .same.dmsh plain.dmsh && say "$1 is read as the plain asset"; rm -f .same.dmsh; }
cp plain.glb longer.glb
printf 'bytes' >>longer.glb
same longer.glb
sed 's/"mesh":0/"mesh":0,"skin":0,"translation":[100,0,0]/' plain.gltf | sed 's/"mesh": *0/"mesh":0,"skin":0,"translation":[100,0,0]/' >skinned.gltf
same skinned.gltf
quiet gltf pack plain.glb parts.gltf
quiet gltf unpack parts.gltf parts_plain.gltf
mv parts_plain.bin 'parts 10%.bin'
sed 's/parts_plain.bin/parts 10%.bin/' parts_plain.gltf >percent.gltf
quiet encode percent.gltf percent.dmsh && say "a name with a percent sign is read"
sed 's/parts_plain.bin/..\/parts.bin/' parts_plain.gltf >unsafe.gltf
run encode unsafe.gltf unsafe.dmsh
sed 's/parts_plain.bin/Stra\xc3\x9fe\xc2\x9b.bin/' parts_plain.gltf >letters.gltf
run encode letters.gltf letters.dmsh
# What a scene does not show is told; without any mesh there is nothing to code.
sed 's/"nodes": *\[0\]/"nodes":[]/' plain.gltf >hidden.gltf
run encode hidden.gltf hidden.dmsh
run encode hidden.gltf hidden.dmsh --keep-unreferenced
# What an asset names goes with it.
mkdir there
printf 'pixels' >t.png
sed 's/"asset": *{/"images":[{"uri":"t.png"}],"asset":{/' parts.gltf >image.gltf
figures gltf unpack image.gltf there/image.glb
cmp t.png there/t.png && say "the image is there"
printf 'other pixels' >there/t.png
run gltf unpack image.gltf there/again.glb
# Where packing does not pay.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >triangle.obj
quiet encode triangle.obj triangle.dmsh
quiet decode triangle.dmsh triangle.glb
figures gltf pack triangle.glb small.glb
[ "$(stat -c %s small.glb)" -le "$(stat -c %s triangle.glb)" ] && say "not larger"
quiet gltf pack plain.glb packed.glb --json
has_keys .out not_smaller copied_files missing_files animation_bytes image_bytes
sed 's/"asset": *{/"images":[{"uri":"data:image\/png;base64,AAAA"}],"asset":{/' plain.gltf >textured.gltf
figures gltf pack textured.gltf textured.glb
