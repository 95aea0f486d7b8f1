# What people see, for every scene and every mesh format.
for scene in rooms terrain sphere torus cad fragments; do
  quiet generate $scene $scene.ply --vertices 1500 --seed 3
  quiet encode $scene.ply $scene.dmsh --bits 8 --order-out $scene.order
  quiet verify $scene.dmsh
  quiet decode $scene.dmsh $scene.back.ply
  run compare $scene.ply $scene.back.ply --order $scene.order --json | grep corresponding
  for suffix in ply obj stl off glb gltf; do
    quiet decode $scene.dmsh back.$suffix
    quiet encode back.$suffix back.dmsh
  done
done
cube cube.obj
figures encode cube.obj cube.dmsh
figures encode cube.obj cube.dmsh --step 0.01 --anchor-density 2 --anchor-bits 16 --profile zstd
figures info cube.dmsh
run verify cube.dmsh
run decode cube.dmsh cube.off
(cat cube.obj; echo "v 9 9 9") >lonely.obj
figures encode lonely.obj lonely.dmsh
run decode lonely.dmsh lonely.off
figures encode lonely.obj lonely.dmsh --keep-unreferenced
run decode lonely.dmsh lonely.off
