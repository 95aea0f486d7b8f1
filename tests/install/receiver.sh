#!/usr/bin/env bash
# receiver.sh PUBLISHER SCRATCH SOURCE COMPILER: installs what only reads into SCRATCH, then builds the example's subscriber against it, by CMake
# package and by pkg-config, and lets it receive the map of PUBLISHER.
set -euo pipefail
publisher=$1 scratch=$2 source=$3 compiler=$4
example=$source/examples/map_udp
rm -rf "$scratch"
mkdir -p "$scratch"
# Not optimised: nothing is timed, and compiling takes a third of the time.
cmake -S "$source" -B "$scratch/build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 \
  -DCMAKE_UNITY_BUILD=ON -DDELTAMESH_DECODER_ONLY=ON -DDELTAMESH_DEVELOPER_MODE=OFF >/dev/null
cmake --build "$scratch/build" --parallel 2 >/dev/null
cmake --install "$scratch/build" --prefix "$scratch/prefix" >/dev/null

# The two libraries, and no header that needs one that is not installed.
find "$scratch/prefix" -name '*.a' -printf '%f\n' | sort | diff - <(printf '%s\n' libdeltamesh_decoder.a libdeltamesh_receiver.a)
find "$scratch/prefix/include" -name '*.h' -printf '#include <%P>\n' | sort >"$scratch/headers.cpp"
grep -q 'deltamesh/map/receiver.h' "$scratch/headers.cpp"
"$compiler" -std=c++20 -fsyntax-only -I "$scratch/prefix/include" "$scratch/headers.cpp"

cmake -S "$source/tests/install/receiver" -B "$scratch/receiver" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Release -DSUBSCRIBER="$example/subscriber.cpp" >/dev/null
cmake --build "$scratch/receiver"
nm -C "$scratch/receiver/subscriber" >"$scratch/symbols"
grep -q 'deltamesh::MapReceiver::apply(' "$scratch/symbols"
if grep -E 'deltamesh::(encode\(|MapSender|MapCodec::encode|encode_part|CompactWriter)|meshopt_' "$scratch/symbols"; then
  echo "a receiver has symbols of what encodes or sends"
  exit 1
fi
"$example/run.sh" "$publisher" "$scratch/receiver/subscriber"

PKG_CONFIG_PATH=$(find "$scratch/prefix" -name pkgconfig -type d)
export PKG_CONFIG_PATH
# shellcheck disable=SC2046
"$compiler" -std=c++20 "$example/subscriber.cpp" -o "$scratch/pkg_subscriber" $(pkg-config --cflags --libs deltamesh-receiver)

# Whoever asks for more than is installed is told.
if cmake -S "$example" -B "$scratch/example" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_COMPILER="$compiler" >"$scratch/refused" 2>&1; then
  echo "a component that is not installed is found"
  exit 1
fi
grep -q 'deltamesh' "$scratch/refused"
