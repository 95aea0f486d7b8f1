# Values as other programs write them. Every line that ends in a colon is a kind of input; the files below are relatives of it: other
# formats, other writers, other numbers.
number() { sed -nE "s/^ *\"$1\": ([^,]*),?$/\1/p" .out | head -n 1; }
within() { # LARGEST FACTOR FILE...: the streams of FILEs have at most FACTOR times the bytes of LARGEST's
  quiet encode "$1" within.dmsh "${options[@]}"
  local most
  most=$(stat -c %s within.dmsh)
  for file in "${@:3}"; do
    quiet encode "$file" within.dmsh "${options[@]}"
    awk -v a="$(stat -c %s within.dmsh)" -v b="$most" -v factor="$2" -v name="$file" \
      'BEGIN { print name (a <= factor * b ? ": as small" : ": " a " bytes, not " b) }'
  done
}
options=()
say "numbers of all types:"
ply_head() { # COUNT PROPERTY...
  printf 'ply\nformat ascii 1.0\nelement vertex %s\n' "$1"
  printf 'property %s\n' "${@:2}"
  printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n'
}
(ply_head 3 'float x' 'float y' 'float z' 'char a' 'ushort b' 'int label' 'uint id' 'double t' 'float q'
 printf '0 0 0 -5 65535 -70000 4294967295 1.25 0.5\n1 0 0 5 1 16777217 0 1e30 -1\n0 1 0 1 2 3 4 5 6\n3 0 1 2\n') >types.ply
quiet encode types.ply types.dmsh --keep-order
for format in ply glb gltf obj off stl; do
  run decode types.dmsh "types.$format"
done
quiet compare types.ply types.dmsh
sed -n '/^  attributes/,$s/  */ /gp' .out
for format in glb gltf; do
  quiet encode "types.$format" back.dmsh --keep-order
  quiet decode back.dmsh back.ply
  quiet encode back.ply again.dmsh --keep-order
  say "$format holds:" $(grep -E '^ +_' .out | sed -E 's/ +([^ ]+ +[0-9]+ x [a-z0-9]+).*/\1;/')
done
say "doubles far from the origin, within 0.0005 of the file:"
quiet generate terrain hills.obj --vertices 900
awk '$1 == "v" { printf "v %.9f %.9f %.9f\n", $2 * 100 + 431234.56789, $3 * 100 + 5412345.67891, $4 * 100 + 512.3; next } { print }' hills.obj >utm.obj
awk '$1 == "v" { printf "v %.9f %.9f %.9f\n", $2 * 100 + 4156789.123, $3 * 100 + 671234.5, $4 * 100 + 4774567.8 ; next } { print }' hills.obj >ecef.obj
vertices=$(grep -c '^v ' utm.obj)
(echo "OFF $vertices $(grep -c '^f ' utm.obj) 0"; sed -n 's/^v //p' utm.obj; awk '$1 == "f" { print 3, $2 - 1, $3 - 1, $4 - 1 }' utm.obj) >utm.off
(ply_head "$vertices" 'double x' 'double y' 'double z' | sed "s/face 1/face $(grep -c '^f ' utm.obj)/"; sed 1d utm.off) >utm.ply
for file in utm.obj ecef.obj utm.off utm.ply; do
  quiet encode $file a.dmsh --max-error 0.0005 --json
  told=$(number max_error)
  quiet decode a.dmsh "back.${file#*.}"
  quiet compare $file "back.${file#*.}" --json
  awk -v told="$told" -v found="$(number max_error)" -v name="$file" \
    'BEGIN { print name (told <= 0.0005 && found <= told * 1.001 ? ": within what is told" : ": told " told ", found " found) }'
done
quiet compare utm.ply utm.off --json
[ "$(number max_error)" = 0.0 ] && echo "doubles of two formats: equal"
figures map split utm.ply utm.map --part-edge 100 --max-error 0.01 | grep rounding
figures tiles plan utm.tiles utm.ply --part-edge 100 --max-error 0.01 | grep rounding
say "colours, through linear light and back:"
(ply_head 256 'float x' 'float y' 'float z' 'uchar red' 'uchar green' 'uchar blue' | sed 's/face 1/face 254/'
 for ((i = 0; i < 256; ++i)); do echo "$((i % 16)) $((i / 16)) 0 $i $((255 - i)) 188"; done
 for ((i = 0; i < 254; ++i)); do echo "3 $i $((i + 1)) $((i + 2))"; done) >grey.ply
(echo 'COFF 256 254 0'; sed '1,/end_header/d' grey.ply) >grey.off
awk 'BEGIN { OFS = " " } /end_header/ { body = 1; next } !body { next } NF == 6 { print "v", $1, $2, $3, $4 / 255, $5 / 255, $6 / 255; next }
  { print "f", $2 + 1, $3 + 1, $4 + 1 }' grey.ply >grey.obj
sed 's/uchar \(red\|green\|blue\)/float \1/' grey.ply >float.ply # 0 to 255 as floats
for file in grey.ply grey.off grey.obj float.ply; do
  for way in glb gltf; do
    quiet encode $file a.dmsh --keep-order
    quiet decode a.dmsh light.$way
    quiet encode light.$way light.dmsh --keep-order
    quiet decode light.dmsh back.off
    sed -n '3,258p' back.off | awk '{ f = $0 ~ /\./ ? 255 : 1; printf "%.0f %.0f %.0f\n", f * $4, f * $5, f * $6 }' >back.txt
    sed -n '2,257p' grey.off | cut -d' ' -f4-6 | cmp - back.txt && say "$file by $way: all values are back"
  done
done
say "normals of any length:"
quiet generate terrain unit.ply --vertices 3000
quiet encode unit.ply a.dmsh --lossless
quiet decode a.dmsh unit.obj
sed '/^v[tn] /d; s/^f \([0-9]*\)[^ ]* \([0-9]*\)[^ ]* \([0-9]*\).*/f \1 \2 \3/' unit.obj >bare.obj
awk '$1 == "v" { x[++n] = $2; y[n] = $3; z[n] = $4 }
  $1 == "f" { ++faces; f[faces] = $2 - 1 " " $3 - 1 " " $4 - 1
    ax = x[$3] - x[$2]; ay = y[$3] - y[$2]; az = z[$3] - z[$2]; bx = x[$4] - x[$2]; by = y[$4] - y[$2]; bz = z[$4] - z[$2]
    for (k = 2; k < 5; ++k) { nx[$k] += ay * bz - az * by; ny[$k] += az * bx - ax * bz; nz[$k] += ax * by - ay * bx } }
  END { print "NOFF", n, faces, 0
    for (i = 1; i <= n; ++i) { l = sqrt(nx[i] ^ 2 + ny[i] ^ 2 + nz[i] ^ 2); if (l == 0) l = nz[i] = 1; print x[i], y[i], z[i], nx[i] / l, ny[i] / l, nz[i] / l }
    for (i = 1; i <= faces; ++i) print 3, f[i] }' bare.obj >unit.off
scaled() { awk -v kind="$1" 'NR > 1 && NF == 6 { s = kind == "corners" ? 2.3 + NR % 40 / 10 : kind == "tiny" ? 1e-9 : 1000; print $1, $2, $3, $4 * s, $5 * s, $6 * s; next } { print }' unit.off; }
as_ply() { (ply_head "$1" 'float x' 'float y' 'float z' 'float nx' 'float ny' 'float nz' ${3:+"$3"} | sed "s/face 1/face $2/"; cat); }
vertices=$(awk 'NR == 1 { print $2 }' unit.off) faces=$(awk 'NR == 1 { print $3 }' unit.off)
for kind in corners tiny large; do scaled $kind >$kind.off; done
sed 1d corners.off | as_ply "$vertices" "$faces" >corners.ply
awk 'NR == 1 { next } NF == 6 { print "v", $1, $2, $3; print "vn", $4, $5, $6; next } { for (k = 2; k < 5; ++k) { ++$k; $k = $k "//" $k } $1 = "f"; print }' corners.off >corners.obj
within unit.off 1.01 corners.off tiny.off large.off corners.ply corners.obj
for file in unit.off corners.off corners.ply; do
  quiet encode $file a.dmsh
  say "$file:" $(sed -nE 's/^  left out +[0-9,]+ //p' .out)
  quiet encode $file a.dmsh --lossless
  quiet decode a.dmsh a.ply
  quiet compare $file a.ply
  grep -E '^ +normals .*(exact|identical|degrees)' .out | sed -E 's/ +/ /g; s/^ /  lossless: /' | head -n 1
done
say "one bad value:"
spoil() { awk -v row="$1" -v with="$2" 'NR == row { $4 = with; if (with == 0) $5 = $6 = 0 } { print }' unit.off | sed 1d | as_ply "$vertices" "$faces"; }
spoil 700 nan >nan.ply
spoil 700 0 >zero.ply
spoil 700 -inf >inf.ply
within unit.off 1.02 nan.ply zero.ply inf.ply
intensity() { awk -v with="$1" 'NR == 1 { next } NF == 6 { print $1, $2, $3, $4, $5, $6, NR == 700 ? with : 100 + (NR * 7919 % 1000) / 50; next } { print }' unit.off | as_ply "$vertices" "$faces" 'float intensity'; }
intensity 100 >intensity.ply
for bad in nan inf 1e30 -3e38; do
  intensity $bad >"bad $bad.ply"
done
options=(--attribute-error intensity=0.5)
within intensity.ply 1.02 'bad nan.ply' 'bad inf.ply' 'bad 1e30.ply' 'bad -3e38.ply'
options=()
say "a stray vertex:"
quiet encode bare.obj a.dmsh --json
asked=$(number max_error)
stray() { sed "0,/^v /s/^v .*/v $1 0 0/" bare.obj; }
stray 1e5 >stray5.obj
stray -1e6 >stray6.obj
sed '0,/^v /s/^v .*/v 1e5 0 0\nv 0 1e7 0/; /^f /!b; s/\([0-9]\+\)/\1/g' bare.obj >two.obj
(awk '$1 == "v" { n++ } $1 == "f" { f++ } END { print "OFF", n, f, 0 }' stray5.obj; sed -n 's/^v //p' stray5.obj; awk '$1 == "f" { print 3, $2 - 1, $3 - 1, $4 - 1 }' stray5.obj) >stray.off
for file in stray5.obj stray6.obj two.obj stray.off; do
  quiet encode $file a.dmsh --json
  awk -v a="$asked" -v b="$(number max_error)" -v name="$file" 'BEGIN { print name (b <= 1.05 * a ? ": the bound is that of the rest" : ": " b ", not " a) }'
  quiet info a.dmsh
  grep -E '^ +stray' .out | sed -E 's/ +/ /g; s/of [0-9.]+/of N/'
done
say "maps that grow, shrink, begin empty and get a stray vertex:"
grid() { # ROWS [STRAY]
  awk -v rows="$1" -v stray="${2:-}" 'BEGIN { for (y = 0; y < rows; ++y) for (x = 0; x < 30; ++x) print "v", x / 10, y / 10, sin(x / 7) * cos(y / 5)
    if (stray != "") print "v", stray, 0, 0
    for (y = 0; y + 1 < rows; ++y) for (x = 0; x < 29; ++x) { v = y * 30 + x + 1; print "f", v, v + 1, v + 30; print "f", v + 1, v + 31, v + 30 }
    if (stray != "") print "f", 1, 2, rows * 30 + 1 }'
}
grid 30 >before.obj
grid 50 >grown.obj
grid 20 >shrunk.obj
grid 30 3e3 >stray.obj
printf 'v 0 0 0\n' >empty.obj
sed 's/vertex [0-9]*/vertex 0/; s/face [0-9]*/face 0/; /end_header/q' grey.ply >empty.ply
for file in before.obj grown.obj shrunk.obj stray.obj empty.ply before.obj; do
  quiet map split $file a.map --part-edge 1 --json
  say "$file: epoch $(number epoch), $(awk -v n="$(number new_parts)" -v p="$(number parts)" 'BEGIN { print n == 0 ? "nothing" : n == p ? "everything" : "some parts" }') sent, lattice $(number lattice_step)"
done
