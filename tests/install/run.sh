#!/usr/bin/env bash
# run.sh BUILD SCRATCH SOURCE COMPILER: installs into SCRATCH, then builds and runs the README's example against what is installed.
set -euo pipefail
build=$1 scratch=$2 source=$3 compiler=$4
consumer=$source/tests/install/consumer
rm -rf "$scratch"
mkdir -p "$scratch"
awk '/^```cpp$/ {inside = 1; next} /^```$/ {inside = 0} inside' "$source/README.md" >"$scratch/main.cpp"
grep -q deltamesh::encode "$scratch/main.cpp"
cmake --install "$build" --prefix "$scratch/prefix" >/dev/null

# Only the public interface is installed, and the program.
test -x "$scratch/prefix/bin/deltamesh"
find "$scratch/prefix/include" -type f | sed "s|$scratch/prefix/include/||" | sort >"$scratch/headers"
if grep -vE '^deltamesh/(map/)?[a-z_]+\.h$' "$scratch/headers"; then
  echo "a header outside deltamesh/ is installed"
  exit 1
fi
# None of the libraries underneath shows in an installed header.
if grep -rnE '#include [<"](Eigen|zstd|draco|tiny_gltf|nlohmann|xxhash)' "$scratch/prefix/include"; then
  echo "an installed header includes a third-party one"
  exit 1
fi

cmake -S "$consumer" -B "$scratch/consumer" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Release -DEXAMPLE="$scratch/main.cpp" >/dev/null
cmake --build "$scratch/consumer"
"$scratch/consumer/consumer"
"$scratch/consumer/all_libraries"
"$scratch/consumer/decoder_alone" "$source"/tests/golden/grid.bits6.*.dmsh

# The example of maps needs nothing but its component, which needs no library of glTF.
cmake -S "$source/examples/map_udp" -B "$scratch/map_udp" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_DISABLE_FIND_PACKAGE_TinyGLTF=ON -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON >/dev/null
cmake --build "$scratch/map_udp"
"$source/examples/map_udp/run.sh" "$scratch/map_udp/map_udp_publisher" "$scratch/map_udp/map_udp_subscriber"

PKG_CONFIG_PATH=$(find "$scratch/prefix" -name pkgconfig -type d | head -n 1)
export PKG_CONFIG_PATH
# shellcheck disable=SC2046
"$compiler" -std=c++20 "$scratch/main.cpp" -o "$scratch/pkg_consumer" $(pkg-config --cflags --libs deltamesh)
"$scratch/pkg_consumer"
# shellcheck disable=SC2046
"$compiler" -std=c++20 "$source/examples/map_udp/publisher.cpp" -o "$scratch/pkg_publisher" $(pkg-config --cflags --libs deltamesh-map)
