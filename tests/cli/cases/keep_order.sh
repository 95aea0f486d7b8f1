# --keep-order gives back the same faces over the same vertices; without it --order-out tells the way back.
quiet generate fragments a.off --vertices 900
quiet encode a.off a.dmsh --keep-order --keep-unreferenced --order-out a.order
quiet decode a.dmsh b.off
faces() { grep -E '^3 [0-9]+ [0-9]+ [0-9]+ *$' "$1"; }
[ "$(faces a.off | wc -l)" -gt 100 ] && cmp <(faces a.off) <(faces b.off) && say "faces are equal"
[ "$(stat -c %s a.order)" = $((4 * $(sed -n 2p b.off | cut -d' ' -f1))) ] && say "one index per vertex"
od -An -v -tu4 -w4 a.order | awk '$1 != NR - 1 { different = 1 } END { print different ? "reordered" : "in order" }'
quiet encode a.off a.dmsh --order-out a.order
quiet decode a.dmsh b.off
od -An -v -tu4 -w4 a.order | awk '$1 != NR - 1 { different = 1 } END { print different ? "reordered" : "in order" }'
run compare a.off b.off --order a.order --json | grep corresponding
say "any number of threads decodes the same bytes:"
quiet generate rooms c.ply --vertices 3000
quiet encode c.ply c.dmsh
for threads in 1 2 4 0; do
  quiet decode c.dmsh "c$threads.ply" --threads "$threads"
  cmp c1.ply "c$threads.ply"
done
run decode c.dmsh c.ply --threads many
say "numbers are those of the file where a vertex that is not finite is dropped:"
quiet generate fragments a.off --vertices 900
awk 'NR == 2 { print $1 + 1, $2, 0; print "nan 0 0"; next } /^3 [0-9]+ [0-9]+ [0-9]+ *$/ { print 3, $2 + 1, $3 + 1, $4 + 1; next } { print }' a.off >nan.off
quiet encode nan.off a.dmsh --order-out a.order
od -An -v -tu4 -w4 a.order | sort -n | sed -n '1p;$p' | tr -d ' ' | tr '\n' ' '
say "of $(sed -n 2p nan.off | cut -d' ' -f1)"
run compare nan.off a.dmsh --order a.order --json | grep corresponding
say "OBJ names a group wherever it changes, so its faces come group by group:"
awk '/^3 [0-9]+ [0-9]+ [0-9]+ *$/ { print n++ % 2 ? "g left" : "g right"; print "f", $2 + 1, $3 + 1, $4 + 1; next } NR > 2 { print "v", $0 }' a.off >a.obj
for order in --keep-order ''; do
  quiet encode a.obj a.dmsh $order
  quiet decode a.dmsh b.obj
  say "${order:-without}: $(grep -c '^g ' b.obj) for $(grep -c '^g ' a.obj)"
done
