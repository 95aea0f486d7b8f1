# The same seed gives the same bytes, another seed others.
for scene in rooms terrain sphere torus cad fragments; do
  figures generate $scene a.ply --vertices 2000 --seed 5
  quiet generate $scene b.ply --vertices 2000 --seed 5
  quiet generate $scene c.ply --vertices 2000 --seed 6
  cmp -s a.ply b.ply && say "same seed, same mesh"
  cmp -s a.ply c.ply || say "other seed, other mesh"
done

# A drive is a folder of updates, the same for the same seed.
quiet generate rooms --sequence a --steps 3 --vertices 5000
quiet generate rooms --sequence b --steps 3 --vertices 5000
figures generate rooms --sequence c --steps 3 --vertices 5000 --seed 2
cmp -s a/sequence.json b/sequence.json && cmp -s a/step_02_changed.ply b/step_02_changed.ply && say "same seed, same drive"
cmp -s a/step_02_changed.ply c/step_02_changed.ply || say "other seed, other drive"
run generate sphere --sequence d
run generate rooms
run generate rooms e.ply --steps 3
