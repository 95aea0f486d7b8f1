# Text and binary files as other programs write them. Every line that ends in a colon is a kind of input; the files below are relatives
# of it: other formats, other writers, other numbers.
same() { # PLAIN FILE...: every file holds the mesh of PLAIN
  quiet encode "$1" plain.dmsh
  for file in "${@:2}"; do
    quiet encode "$file" same.dmsh
    cmp plain.dmsh same.dmsh && say "$file is read as $1"
  done
}
lost() { # FILE...: what is left out of each
  for file in "$@"; do
    quiet encode "$file" lost.dmsh --lossless
    say "$file:$(sed -nE 's/^  left out +/ /p' .out | sed -E '/lengths/d; s/ +/ /g')"
  done
}
area() { # FILE...: of their triangles, which lie in a plane of constant z
  for file in "$@"; do
    quiet encode "$file" area.dmsh --lossless
    quiet decode area.dmsh area.obj
    awk -v file="$file" '$1 == "v" { x[++n] = $2; y[n] = $3 }
      $1 == "f" { a = (x[$3] - x[$2]) * (y[$4] - y[$2]) - (x[$4] - x[$2]) * (y[$3] - y[$2]); sum += a < 0 ? -a : a }
      END { print file ": area " sum / 2 }' area.obj
  done
}
points='0 0 0\n1 0 0\n0 1 0\n'
v='v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n'
ply() { # VERTICES FACES: properties of both, beside x, y, z and the list
  printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n%belement face 1\nproperty list uchar int vertex_indices\n%bend_header\n' "$1" "$2"
}
facet='facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n'
printf "${v}f 1 2 3\n" >face.obj
printf "OFF\n3 1 0\n${points}3 0 1 2\n" >face.off
(ply '' ''; printf "${points}3 0 1 2\n") >face.ply
printf "solid x\n${facet}endsolid x\n" >face.stl
say "byte order mark, line ends, zeros at the end:"
for format in obj off ply stl; do
  (printf '\xef\xbb\xbf'; cat face.$format) >mark.$format
  sed 's/$/\r/' face.$format >crlf.$format
  tr '\n' '\r' <face.$format >cr.$format
  (cat face.$format; printf '\0\0\0') >zeros.$format
  same face.$format mark.$format crlf.$format cr.$format zeros.$format
done
say "no number:"
for word in '-1.#IND' 1,5 0x10 1e999; do
  for format in obj off ply stl; do
    sed "s/1 0 0/1 0 $word/" face.$format >number.$format
    run encode number.$format number.dmsh
  done
done
say "empty indices, comments behind:"
i=0
for face in 'f 1/ 2/ 3/' 'f 1// 2// 3//' 'f 1 2/ 3//' 'f 1 2 3 # comment' 'f -4 -3 \\\n -2'; do
  printf "${v}$face\n" >"face$((++i)).obj"
done
printf "OFF # comment\n3 1 0 # counts\n${points}3 0 1 2 # face\n" >comment.off
sed 's/^element face/comment 1 2\nobj_info x\nelement face/' face.ply >comment.ply
same face.obj face?.obj
same face.off comment.off
same face.ply comment.ply
say "values on some:"
printf "${v}vn 0 0 1\nf 1//1 2//1 3//1\nf 2 4 3\n" >normals.obj
printf "${v}vn 0 0 1\nf 1//1 2//1 3\n" >corner.obj
printf "${v}vt 1 1\nf 1/1 2/1 3/1\nf 2 4 3\n" >uvs.obj
printf 'v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >colors.obj
printf "OFF\n4 2 0\n${points}1 1 0\n3 0 1 2 255 0 0\n3 1 3 2\n" >colors.off
(ply '' 'property list uchar float texcoord\n'; printf "${points}3 0 1 2 0\n") >uvs.ply
lost normals.obj corner.obj uvs.obj colors.obj colors.off uvs.ply
say "objects, groups and materials:"
printf "mtllib x.mtl\no one\ng left\nusemtl red\n${v}f 1 2 3\no two\ng right\nusemtl blue\ns 1\nf 2 4 3\n" >all.obj
printf "usemtl red\n${v}f 1 2 3\nusemtl blue\nf 2 4 3\n" >materials.obj
printf "${v}g a b\nf 1 2 3\ng c\nf 2 4 3\n" >groups.obj
printf "${v}o one\nf 1 2 3\no two\nf 2 4 3\n" >objects.obj
lost all.obj materials.obj groups.obj objects.obj
for file in all materials groups objects; do
  for way in obj glb; do
    quiet encode $file.obj a.dmsh
    quiet decode a.dmsh a.$way
    quiet encode a.$way a.dmsh
    quiet decode a.dmsh a.obj
    say "$file by $way:" $(grep -E '^(o|g|usemtl)' a.obj)
  done
done
say "concave polygons:"
u='0 0 0\n10 0 0\n10 10 0\n9 10 0\n9 1 0\n1 1 0\n1 10 0\n0 10 0\n'
printf "$u" | sed 's/^/v /' >u.obj
cp u.obj turned.obj
echo 'f 1 2 3 4 5 6 7 8' >>u.obj
echo 'f 8 7 6 5 4 3 2 1' >>turned.obj
printf "OFF 8 1 0\n${u}8 3 4 5 6 7 0 1 2\n" >u.off
(ply '' '' | sed 's/vertex 3/vertex 8/'; printf "${u}8 0 1 2 3 4 5 6 7\n") >u.ply
printf 'v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nf 1 2 3 4\n' >arrow.obj
area u.obj turned.obj u.off u.ply arrow.obj
say "counts of binary STL:"
binary() { # COUNT FACETS, COUNT as four bytes
  printf '%80s' ''
  printf "$1"
  for ((f = 0; f < $2; ++f)); do
    printf '%b' '\x0\x0\x0\x0\x0\x0\x0\x0\x0\x0\x80\x3f\x0\x0\x0\x0\x0\x0\x0\x0\x0\x0\x0'"\\x$((10 * f))"'\x0\x0\x80\x3f\x0\x0\x0\x0\x0\x0\x0\x0\x0\x0\x0\x0\x0\x0\x80\x3f\x0\x0\x0\x0\x0\x0'
  done
}
binary '\x4\x0\x0\x0' 4 >right.stl
binary '\x0\x0\x0\x0' 4 >zero.stl
binary '\x2\x0\x0\x0' 4 >small.stl
binary '\xff\xff\xff\xff' 4 >unknown.stl
binary '\x5\x0\x0\x0' 4 >cut.stl
lost right.stl zero.stl small.stl unknown.stl
same right.stl zero.stl small.stl unknown.stl
run encode cut.stl cut.dmsh
say "text STL by words alone:"
printf "solid x\n$(printf "$facet" | tr '\n' ' ')\nendsolid x\n" >line.stl
printf "solid a b\n${facet}" >end.stl
printf "solid x\n${facet}endsolid x\n" | tr a-z A-Z >capitals.stl
printf "solid\n${facet/normal 0 0 1/normal -1.#IND 0 0}endsolid" >normal.stl
same face.stl line.stl end.stl capitals.stl normal.stl
lost line.stl end.stl capitals.stl
say "counts behind OFF:"
printf "OFF3 1 0\n${points}3 0 1 2\n" >together.off
printf "OFF 3 1\n${points}3 0 1 2\n" >blank.off
printf "# ModelNet\nOFF\n\n3 1 0\n${points}3 0 1 2\n" >before.off
printf 'COFF3 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n' >coff.off
same face.off together.off blank.off before.off
lost coff.off
say "properties of faces:"
(ply '' 'property list uchar float texcoord\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty int texnumber\n'; printf "${points}3 0 1 2 6 0 0 1 0 0 1 9 8 7 5\n") >face_colors.ply
printf "OFF 3 1 0\n${points}3 0 1 2 9 8 7\n" >face_colors.off
printf "OFF 3 1 0\n${points}3 0 1 2 5\n" >color_map.off
(ply '' 'property float quality\n'; printf "${points}3 0 1 2 0.5\n") >quality.ply
lost face_colors.ply face_colors.off color_map.off quality.ply
for file in face_colors.ply face_colors.off; do
  quiet encode $file a.dmsh
  quiet decode a.dmsh a.off
  sed -n 1,3p a.off
done
say "colours as comments, and as 0 and 1:"
printf "${v}#MRGB ffff0000ff00ff00ff0000ffffffffff\nf 1 2 3\nf 2 4 3\n" >polypaint.obj
printf 'COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n3 0 1 2\n' >ones.off
lost polypaint.obj ones.off
quiet encode ones.off a.dmsh
quiet decode a.dmsh a.obj
grep '^v ' a.obj
say "vertices that are not finite:"
printf "v nan 0 0\n${v}f 2 3 4\n" >unused.obj
printf "OFF 4 1 0\n${points}inf 0 0\n3 0 1 2\n" >unused.off
(ply '' '' | sed 's/vertex 3/vertex 4/'; printf "${points}0 -inf nan\n3 0 1 2\n") >unused.ply
lost unused.obj unused.off unused.ply
for format in obj off ply stl; do
  sed -E 's/^((v|vertex) )?0 0 0/\1nan 0 0/' face.$format >used.$format
  run encode used.$format used.dmsh
  status encode used.$format used.dmsh --drop-invalid --keep-unreferenced
done
