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
# Bounds are for attributes that the mesh has, and kept ones too.
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
property float intensity
element face 2
property list uchar int vertex_indices
end_header
0 0 0 0 0 1 0.25
1 0 0 0 0 1 7.5
1 1 0 0 0 1 1.125
0 1 0 0 0 1 -3.0625
3 0 1 2
3 0 2 3
PLY
ask='--part-edge 1 --max-error 0.01'
run map split cube.obj new.map $ask --attribute-error nosuch=1
run map split quad.ply new.map $ask --attribute-rms nosuch=1
run tiles plan new.map quad.ply $ask --attribute-error nx=1
run tiles plan new.map cube.obj quad.ply $ask --attribute-error intensity=1
[ -e new.map ] && say "a map was made of wrong bounds"
quiet map split quad.ply quad.map $ask --attribute-error intensity=0.5
run map split cube.obj quad.map $ask
run tiles plan quad.map cube.obj $ask
quiet map split cube.obj quad.map $ask --normal-error 1
named() { # the map with these bounds for names
  printf '{"asked":{},"bounds":{},"attributes":{"normal_error":1,"uv_error":1,"weight_error":1,"named":[%s]}}' "$1" \
    >quad.map/bounds.json
  run map split quad.ply quad.map $ask
}
named '["",1,false]'
named '["intensity",1,false],["intensity",2,true]'
# Tiles that replace a map keep its bounds on attributes until there are others.
rm -r quad.map
quiet map split quad.ply quad.map $ask --attribute-error intensity=0.5 --normal-error 2
for asked in '' '--normal-error 1'; do
  run tiles plan quad.map quad.ply $ask $asked
  grep -A5 '"named"' quad.map/tiles/plan.json
  quiet tiles encode quad.map 0
  quiet tiles finish quad.map
  cat quad.map/bounds.json
done
