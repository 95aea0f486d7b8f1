# What is asked of attributes, and what is told of them.
cat >quad.ply <<PLY
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property float intensity
element face 2
property list uchar int vertex_indices
end_header
0 0 0 0 0 1 10 20 30 0.25
1 0 0 0 0.6 0.8 10 20 35 7.5
1 1 0 0.6 0 0.8 10 25 30 1.125
0 1 0 0 0 1 15 20 30 -3.0625
3 0 1 2
3 0 2 3
PLY
# Lines of attributes; how exact they come out is the coders' affair.
attributes() { figures "$@" | grep -E '^ (normals|colours|intensity)' | sed -E 's/(exact|max error N.*)$/ERROR/'; }
attributes encode quad.ply quad.dmsh --geometry predictive --bits 12
quiet encode quad.ply bounds.dmsh --geometry predictive --bits 12 --normal-error 5 --attribute-error intensity=0.5
attributes info bounds.dmsh
quiet info bounds.dmsh --json
sed -n '/"attributes"/,/^  \]/p' .out | grep -vE 'bytes|bits|max_error'
quiet info quad.dmsh --json
grep -B 6 '"255ths"' .out | grep max_error
run encode quad.ply none.dmsh --attribute-error Intensity=1
run encode quad.ply none.dmsh --attribute-error normal=1
run encode quad.ply none.dmsh --attribute-rms Intensity=1
run encode quad.ply none.dmsh --attribute-rms intensity=0
run encode quad.ply none.dmsh --attribute-rms intensity=1 --attribute-error intensity=1
say "one number a vertex at a mean error"
{
  printf 'ply\nformat ascii 1.0\nelement vertex 900\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'property float intensity\nelement face 1682\nproperty list uchar int vertex_indices\nend_header\n'
  awk 'BEGIN {
    for (i = 0; i < 900; ++i) print i % 30, int(i / 30), 0, 3 * (i % 30) + int(i / 30) * (i % 7)
    for (y = 0; y < 29; ++y) for (x = 0; x < 29; ++x) { v = 30 * y + x; print 3, v, v + 1, v + 30; print 3, v + 1, v + 31, v + 30 }
  }'
} >sensed.ply
quiet encode sensed.ply sensed.dmsh --attribute-rms intensity=4
"$program" info sensed.dmsh --json | awk '/"rms"/ { exit !($2 > 3.9 && $2 <= 4.001) }' && echo "met within 2.5 %"
# Normals of any length keep their directions alone, and that is said; lossless keeps all.
sed 's/^0 0 0 0 0 1 /0 0 0 0 0 2 /; s/^1 1 0 0.6 0 0.8 /1 1 0 6 0 8 /' quad.ply >long.ply
quiet encode long.ply long.dmsh
grep -E '^  left out' .out | sed -E 's/ +/ /g'
quiet encode long.ply long.dmsh --lossless
grep -E '^  left out' .out | sed -E 's/ +/ /g'
quiet encode long.ply long.dmsh --json
grep dropped_lengths .out
run encode long.ply strict.dmsh --strict
quiet encode long.ply strict.dmsh --strict --lossless
say "an angle that no coding needs is no dearer:"
quiet encode long.ply wide.dmsh --normal-error 60
quiet encode long.ply wider.dmsh --normal-error 170
cmp wide.dmsh wider.dmsh && say "equal"
list
awk 'BEGIN {
  print "ply\nformat ascii 1.0\nelement vertex 1600\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity"
  print "element face 1521\nproperty list uchar int vertex_indices\nend_header"
  for (i = 0; i < 1600; ++i) print i % 40, int(i / 40), 0, sin(i * i)
  for (i = 0; i < 1560; ++i) if (i % 40 < 39) print 3, i, i + 1, i + 40
}' >scan.ply
figures encode scan.ply scan.dmsh --target-bytes 2000
status encode scan.ply scan.dmsh --target-bytes 2000 --attribute-error intensity=0.1
# Nothing is said of colours: photographs are kept to a mean error, labels exactly.
quiet generate rooms rooms.ply --vertices 3000
attributes encode rooms.ply rooms.dmsh
attributes info rooms.dmsh
attributes encode rooms.ply rooms.dmsh --color-error 0
attributes encode rooms.ply rooms.dmsh --lossless
awk 'BEGIN {
  print "ply\nformat ascii 1.0\nelement vertex 1600\nproperty float x\nproperty float y\nproperty float z"
  print "property uchar red\nproperty uchar green\nproperty uchar blue"
  print "element face 3042\nproperty list uchar int vertex_indices\nend_header"
  for (i = 0; i < 1600; ++i) print i % 40, int(i / 40), 0, int(i % 40 / 10) * 70, int(i / 400) * 70, 9
  for (i = 0; i < 1560; ++i) if (i % 40 < 39) print 3, i, i + 1, i + 40 "\n" 3, i + 1, i + 41, i + 40
}' >labels.ply
attributes encode labels.ply labels.dmsh
attributes info labels.dmsh
quiet encode labels.ply labels.dmsh --json
grep '"labels"' .out
