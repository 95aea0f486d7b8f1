# Outputs that cannot be written end with exit code 4; what was there before stays, and no temporary file does.
cube cube.obj
quiet encode cube.obj cube.dmsh
run encode cube.obj /dev/full
run decode cube.dmsh none/cube.ply
run encode cube.obj cube2.dmsh --order-out /dev/full
run encode cube.obj cube2.dmsh --order-out none/cube2.order
run encode cube.obj none/cube2.dmsh --order-out cube2.order
mkdir folder folder.ply
run encode cube.obj folder
run decode cube.dmsh folder.ply
"$program" info cube.dmsh >/dev/full 2>.err
say "info to a full device: exit $?"
cat .err
say "a disk that is full after one block:"
quiet generate sphere sphere.ply --vertices 5000
printf 'before' >old.dmsh
printf 'before' >old.ply
(
  trap '' XFSZ
  ulimit -f 1
  "$program" encode sphere.ply old.dmsh >/dev/null 2>&1
  say "exit $?"
  "$program" generate sphere old.ply --vertices 5000 >/dev/null 2>&1
  say "exit $?"
)
cat old.dmsh old.ply
say
say "a mesh is not replaced by what is made of it:"
cp cube.obj same.obj
run encode same.obj same.obj
run encode same.obj same.dmsh --order-out cube.ply
run encode same.obj same.dmsh --order-out ./same.dmsh
ln -s cube.dmsh also_cube.dmsh
run encode same.obj cube.dmsh --order-out also_cube.dmsh
run compare cube.obj same.obj --heatmap ./same.obj
run compare cube.obj same.obj --heatmap heat.stl
cp cube.obj cube.text
run encode cube.text ./cube.text --format obj
run encode cube.obj same.dmsh --order-out -
run encode cube.text same.dmsh --order-out cube.text --format obj
run decode cube.dmsh cube.dmsh --format obj
run decode cube.dmsh other.dmsh
quiet encode cube.obj cube.dmsh
run generate sphere -
cmp cube.obj same.obj
cmp cube.obj cube.text
say "nor are the files that it names:"
quiet decode cube.dmsh cube.glb
quiet gltf pack cube.glb parts.gltf --fallback
quiet gltf unpack parts.gltf plain.gltf
cp plain.bin before.bin
sed 's/"asset": *{/"images":[{"uri":"skin%20of.png"}],"asset":{/' plain.gltf >skinned.gltf
run encode skinned.gltf ./plain.bin
run encode skinned.gltf skinned.dmsh --order-out plain.bin
run encode skinned.gltf 'skin of.png'
sed 's/plain.bin/heat.ply/' plain.gltf >heat.gltf
cp plain.bin heat.ply
run compare cube.obj heat.gltf --heatmap heat.ply
mkdir -p own.map/parts
cp skinned.gltf own.map
sed -i 's/plain.bin/parts\/plain.bin/' own.map/skinned.gltf
cp plain.bin own.map/parts
run map split own.map/skinned.gltf own.map --part-edge 1
printf 'mtllib a b.mtl\n' | cat - cube.obj >with.obj
run encode with.obj 'a b.mtl'
printf 'mtllib own.map/parts/gone.mtl\n' | cat - cube.obj >with.obj
status map split with.obj own.map --part-edge 1
cmp plain.bin before.bin
rm -r own.map heat.* parts.gltf parts.bin plain.gltf plain.bin before.bin skinned.gltf with.obj
rm also_cube.dmsh
ln -s cube.dmsh link.dmsh
status encode cube.obj link.dmsh
[ -L link.dmsh ] && say "the link is still one"
mkdir away
ln -s away/new.dmsh chain.dmsh
ln -s chain.dmsh dangling.dmsh
status encode cube.obj dangling.dmsh
[ -L dangling.dmsh ] && [ -L chain.dmsh ] && cmp away/new.dmsh cube.dmsh && say "links to nowhere are followed"
ln -s none/new.dmsh nowhere.dmsh
run encode cube.obj nowhere.dmsh
[ -L nowhere.dmsh ] && say "the link is still one"
ln -s loop.dmsh loop.dmsh
run encode cube.obj loop.dmsh
rm -r away chain.dmsh dangling.dmsh nowhere.dmsh loop.dmsh
chmod 640 cube.dmsh
quiet encode cube.obj cube.dmsh
say "mode $(stat -c %a cube.dmsh)"
list
