# The JSON files of maps: bounds.json and tiles/plan.json.
cube cube.obj
quiet map split cube.obj cube.map --part-edge 1 --max-error 0.01
quiet tiles plan tiles.map cube.obj --part-edge 1 --max-error 0.01
quiet tiles encode tiles.map 0
quiet tiles finish tiles.map
# Arrays nested to any depth are refused like others.
nested() { printf "%${1}s" | tr ' ' '['; printf "%${1}s" | tr ' ' ']'; }
for depth in 1 200000; do
  nested $depth >cube.map/bounds.json
  run map split cube.obj cube.map --part-edge 1
  printf '{"asked":{"vde":%s},"bounds":{}}' "$(nested $depth)" >cube.map/bounds.json
  run map split cube.obj cube.map --part-edge 1
  nested $depth >tiles.map/tiles/plan.json
  run tiles finish tiles.map
  printf '{"files":["a"],"quality":{"vde":{"a":%s}}}' "$(nested $depth)" >tiles.map/tiles/plan.json
  run tiles finish tiles.map
done
# Names that JSON cannot hold are refused before work begins.
foreign() { capture "$@"; sed 's/\xff/?/g' .err; say "exit $code"; }
foreign map split cube.obj new.map --part-edge 1 --max-error 0.01 --attribute-error $'\xff=1'
foreign tiles plan new.map cube.obj --part-edge 1 --max-error 0.01 --attribute-rms $'a\xff=1'
foreign tiles plan new.map cube.obj $'a\xff.obj' --part-edge 1 --max-error 0.01 2>&1 | sed "s,$PWD/,,"
list
# A plan is read once for all parts that are at fault, however large it is.
quiet generate rooms rooms.ply --vertices 4000
quiet tiles plan many.map rooms.ply --part-edge 0.2 --max-error 0.01
quiet tiles encode many.map 0
quiet tiles finish many.map
rm many.map/parts/*.part
{ echo '{"padding":[0'; yes ,0 | head -n 1000000; echo '],'; tail -n +2 many.map/tiles/plan.json; } >padded.json
mv padded.json many.map/tiles/plan.json
for command in 'verify' 'map info'; do
  (ulimit -t 30; capture $command many.map; say "$command: exit $code"; sed 's/.*; //' .err | uniq)
done
