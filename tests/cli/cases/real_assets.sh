# Assets as other programs write them. Every line that ends in a colon is a kind of input; the files below are relatives of it.
number() { sed -nE "s/^ *\"$1\": ([^,]*),?$/\1/p" .out | head -n 1; }
quiet generate cad cad.ply --vertices 600
quiet encode cad.ply cad.dmsh
quiet decode cad.dmsh cad.gltf
same() { # FILE...: every file holds the mesh of cad.gltf
  quiet encode cad.gltf plain.dmsh
  for file in "$@"; do
    quiet encode "$file" same.dmsh
    cmp plain.dmsh same.dmsh && say "$file is read as cad.gltf"
  done
}
say "texture coordinates that materials stretch:"
stretched() { sed "s/\"mode\":4/\"mode\":4,$2/; s/^{/{\"textures\":[{}],\"materials\":[$1],/" cad.gltf; }
transform() { echo "{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{\"scale\":$1}}}"; }
stretched "{\"pbrMetallicRoughness\":{\"baseColorTexture\":$(transform '[50,50]')}}" '"material":0' >base_50.gltf
stretched "{\"normalTexture\":$(transform '[1,20]')}" '"material":0' >normal_20.gltf
stretched "{\"extensions\":{\"KHR_materials_clearcoat\":{\"clearcoatTexture\":$(transform '[-10,3]')}}}" '"material":0' >coat_10.gltf
stretched "{},{\"emissiveTexture\":$(transform '[4,4]')}" '"material":0,"extensions":{"KHR_materials_variants":{"mappings":[{"variants":[0],"material":1}]}}' >variant_4.gltf
stretched "{\"emissiveTexture\":$(transform '[0.25,0.25]')}" '"material":0' >shrunk.gltf
uv_error() { sed -n '/"attributes": \[/,/^  \]/p' .out | grep -A 9 -E 'TEXCOORD_0|"uv"|texture coordinates' | sed -nE 's/.*"(max_)?error": ([^,]*),?$/\2/p' | head -n 1; }
for file in base_50 normal_20 coat_10 variant_4 shrunk; do
  scale=${file#*_}
  [ $file = shrunk ] && scale=1
  quiet encode $file.gltf a.dmsh --uv-error 1/4096 --json
  awk -v e="$(uv_error)" -v s="$scale" -v told="$(number uv_scale)" -v name="$file" \
    'BEGIN { print name (e > 0 && e * s <= 1.0001 / 4096 && told == s ? ": within 1/4096 behind the transform" : ": " e " times " told) }'
  quiet gltf pack $file.gltf a.glb --uv-error 1/4096 --json
  awk -v e="$(uv_error)" -v s="$scale" -v name="$file" \
    'BEGIN { print name (e > 0 && e * s <= 1.0001 / 4096 ? ": packed within 1/4096" : ": packed, " e) }'
done
quiet encode base_50.gltf a.dmsh
grep '^  textures' .out | sed -E 's/ +/ /g'
quiet map split base_50.gltf stretched.map --part-edge 1000 --max-error 0.1 --uv-error 1/4096
grep '^  textures' .out | sed -E 's/ +/ /g'
quiet map split cad.gltf plain.map --part-edge 1000 --max-error 0.1 --uv-error 1/204800
cmp stretched.map/parts/* plain.map/parts/* && say "base_50: the map of cad.gltf with a fiftieth of the bound"
quiet tiles plan stretched.tiles shrunk.gltf base_50.gltf --part-edge 1000 --max-error 0.1 --uv-error 1/4096
grep '^  textures' .out | sed -E 's/ +/ /g'
awk -F '[:,]' '/"quality"/ { coded = 1 } coded && /"uv_error"/ { print "tiles: " ($2 * 50 * 4096 == 1 ? "a fiftieth of the bound" : $2) }' stretched.tiles/tiles/plan.json
say "skinned meshes, whatever moves their node:"
moves=('"translation":[100,0,0]' '"rotation":[0,0,1,0]' '"scale":[3,3,3]' '"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,5,5,1]')
for i in 0 1 2 3; do
  sed "s/\"nodes\":\[{\"mesh\":0}\]/\"nodes\":[{\"mesh\":0,\"skin\":0,${moves[i]}}],\"skins\":[{\"joints\":[0]}]/" cad.gltf >"skinned_$i.gltf"
done
sed 's/"nodes":\[{"mesh":0}\]/"nodes":[{"children":[1],"translation":[7,8,9]},{"mesh":0,"skin":0}],"skins":[{"joints":[0]}]/' cad.gltf >skinned_child.gltf
same skinned_?.gltf skinned_child.gltf
say "meshes that are shown several times:"
quiet generate cad few.ply --vertices 60
quiet encode few.ply few.dmsh
quiet decode few.dmsh few.gltf
vertices=$(sed -nE 's/.*"accessors":\[\{[^}]*"count":([0-9]+).*/\1/p' few.gltf)
placed() { sed "s/\"nodes\":\[{\"mesh\":0}\],\"scene\":0,\"scenes\":\[{\"nodes\":\[0\]}\]/\"nodes\":[$1],\"scenes\":[{\"nodes\":[$2]}]/" few.gltf; }
placed '{"mesh":0},{"mesh":0,"translation":[100,0,0]}' 0,1 >two_nodes.gltf
placed '{"children":[1,2]},{"mesh":0},{"mesh":0,"scale":[-1,1,1]}' 0 >children.gltf
placed '{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}}' 0 >instances.gltf
placed '{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}},{"mesh":0}' 0,1 >both.gltf
for file in two_nodes children instances both; do
  quiet encode $file.gltf a.dmsh --geometry predictive --effort 0 --json
  say "$file: $(number input_vertices | awk -v n="$vertices" '{ print ($1 == 2 * n ? "2" : $1 == n * n ? "n" : $1 == n * n + n ? "n + 1" : $1) }') times"
done
say "names of files:"
quiet gltf pack cad.gltf packed.gltf
quiet gltf unpack packed.gltf named.gltf
for name in 'a 10%' 'a b' 'ä' 'sub/a'; do
  mkdir -p sub
  cp named.bin "$name.bin"
  sed "s|named.bin|$name.bin|" named.gltf >name.gltf
  quiet encode name.gltf name.dmsh && say "$name.bin is read"
done
sed 's|named.bin|a%20b.bin|' named.gltf >name.gltf
quiet encode name.gltf name.dmsh && say "a%20b.bin is a b.bin"
for name in ../named /named %2e%2e/named 'C:\\named' http://x/named; do
  sed "s|named.bin|$name.bin|" named.gltf >unsafe.gltf
  run encode unsafe.gltf unsafe.dmsh
done
say "bytes behind a GLB:"
quiet decode cad.dmsh cad.glb
for more in x 'xxxx' "$(printf '%64s' '')"; do
  (cat cad.glb; printf '%s' "$more") >longer.glb
  same longer.glb
done
say "packing that does not pay:"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >triangle.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no a\nf 1 2 3\no b\nf 2 4 3\n' >quad.obj
for file in triangle quad; do
  quiet encode $file.obj a.dmsh
  for format in glb gltf; do
    quiet decode a.dmsh $file.$format
    quiet gltf pack $file.$format small.$format --json
    say "$file.$format: $(number converted) packed, $(number not_smaller) not smaller, $([ $format = gltf ] || [ "$(stat -c %s small.glb)" -gt "$(stat -c %s $file.glb)" ] || echo "no larger")"
  done
done
run gltf pack triangle.glb small.glb | grep note
say "files beside an asset:"
mkdir -p from to
printf pixels >from/a.png
printf more >'from/b c.jpg'
sed 's/^{/{"images":[{"uri":"a.png"},{"uri":"b%20c.jpg"}],/' cad.gltf >from/images.gltf
cp named.bin from/
sed 's/^{/{"images":[{"uri":"a.png"}],/' named.gltf >from/buffer.gltf
sed 's/^{/{"images":[{"uri":"none.png"}],/' cad.gltf >from/missing.gltf
sed 's/^{/{"images":[{"uri":"..\/up.png"}],/' cad.gltf >from/up.gltf
for file in images buffer missing up; do
  quiet_or_not=$("$program" gltf pack from/$file.gltf to/$file.glb 2>&1 >.out)
  say "$file: exit $? $quiet_or_not" $(grep -E '^  (copied|missing)' .out | sed -E 's/ +/ /g')
done
(cd to && ls)
