cube a.obj
sed 's/^v 1 1 1/v 1 1 1.5/' a.obj >b.obj
run compare a.obj a.obj
run compare a.obj b.obj
run compare a.obj b.obj --json | grep -v normal
sed 's/^f 5 6 7 8/f 8 7 6 5/' a.obj >turned.obj
run compare a.obj turned.obj
printf '\0\0\0\0\1\0\0\0\2\0\0\0\3\0\0\0\4\0\0\0\5\0\0\0\6\0\0\0\7\0\0\0' >order
run compare a.obj b.obj --order order
run compare a.obj turned.obj --order order
sed 's/^f 1 2 6 5/f 1 3 6 5/' a.obj >other.obj
run compare a.obj other.obj --json | grep -v normal
(sed -n '/^v/p' a.obj | tac; printf 'f %s\n' '8 5 6 7' '4 3 2 1' '8 7 3 4' '7 6 2 3' '6 5 1 2' '5 8 4 1') >back.obj
run compare a.obj back.obj
say "attributes"
quads() { # coloured squares whose corners have texture coordinates of their own; $1: u of the first corner, $2: names
  printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'property float %s\nproperty float %s\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n' $2
  printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n'
  printf '0 0 0 %s 0 9 9 9\n2 0 0 1 0 9 9 9\n2 1 0 1 1 9 9 %s\n0 1 0 0 1 9 9 9\n4 0 1 2 3\n' $1
}
quads '0 9' 's t' >first.ply
quads '0.25 14' 's t' >second.ply
quads '0 9' 'quality age' >third.ply
run compare first.ply second.ply
run compare first.ply third.ply
run compare first.ply a.obj
run compare first.ply second.ply --json | sed -n '/"attributes"/,$p'
say "heat map: red outward, blue inward, green none"
quiet generate sphere sphere.obj --vertices 500
quiet encode sphere.obj sphere.dmsh --bits 5 --order-out order
figures compare sphere.obj sphere.dmsh --order order --heatmap map.ply
head -c 300 map.ply | grep -a property
quiet compare a.obj b.obj --heatmap map.obj
grep '^v' map.obj
say "heat map of colours: green none, red much"
squares() {
  printf 'OFF\n4 2 0\n0 0 0 %s\n1 0 0 255 0 0 255\n1 1 0 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2\n3 0 2 3\n' "$1" |
    sed 's/^OFF/COFF/'
}
squares '200 200 200 255' >grey.off
squares '210 190 200 255' >tinted.off
run compare grey.off tinted.off --color-heatmap colors.obj
grep '^v' colors.obj
run compare a.obj b.obj --color-heatmap colors.obj
run compare grey.off tinted.off --heatmap same.obj --color-heatmap same.obj
list
