# The same seed gives the same bytes, another seed others.
for scene in rooms terrain sphere torus cad fragments; do
  figures generate $scene a.ply --vertices 2000 --seed 5
  quiet generate $scene b.ply --vertices 2000 --seed 5
  quiet generate $scene c.ply --vertices 2000 --seed 6
  cmp -s a.ply b.ply && say "same seed, same mesh"
  cmp -s a.ply c.ply || say "other seed, other mesh"
done
