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
say "heat map: red outward, blue inward, green none"
quiet generate sphere sphere.obj --vertices 500
quiet encode sphere.obj sphere.dmsh --bits 5 --order-out order
figures compare sphere.obj sphere.dmsh --order order --heatmap map.ply
head -c 300 map.ply | grep -a property
quiet compare a.obj b.obj --heatmap map.obj
grep '^v' map.obj
list
