# --json prints one object to standard output and nothing else there.
stream="vertices triangles components bytes bits_per_vertex connectivity_bytes geometry_bytes anchor_bytes attribute_bytes
        container_bytes geometry bits step anchors anchor_density cycles vde_rms lfe_rms max_error vde_paper lfe_paper diagonal attributes"
quiet generate torus torus.ply --vertices 800
quiet encode torus.ply torus.dmsh --json
cp .out encode.json
has_keys encode.json input_vertices unreferenced_vertices dropped_lengths left_out encode_seconds $stream
quiet info torus.dmsh --json
cp .out info.json
has_keys info.json chunks origin keeps_order format_version $stream
quiet compare torus.ply torus.dmsh --json
cp .out compare.json
has_keys compare.json corresponding reordered matched_faces unmatched_faces_a unmatched_faces_b attributes vde_rms lfe_rms max_error vde_paper lfe_paper surface_rms surface_max left_out_a left_out_b \
  normal_angle_mean normal_angle_p95 diagonal measured_vertices
grep -E 'corresponding|measured_vertices' compare.json
quiet encode torus.ply torus.dmsh --step 0.001 --json
grep '"bits":' .out
run encode none.ply none.dmsh --json
run info none.dmsh --json
sum=0
for part in connectivity geometry anchor attribute container; do
  sum=$((sum + $(sed -nE "s/.*\"${part}_bytes\": ([0-9]+).*/\1/p" encode.json)))
done
[ "$sum" = "$(sed -nE 's/.*"bytes": ([0-9]+).*/\1/p' encode.json)" ] && say "the parts add up"
