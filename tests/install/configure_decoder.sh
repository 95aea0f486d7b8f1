#!/usr/bin/env bash
# configure_decoder.sh SOURCE SCRATCH COMPILER: the decoder alone is configured where only its own dependencies are installed.
set -euo pipefail
source=$1 scratch=$2 compiler=$3
disabled=()
for package in Eigen3 nlohmann_json TinyGLTF CLI11 GTest benchmark draco meshoptimizer; do
  disabled+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
rm -rf "$scratch"
cmake -S "$source" -B "$scratch" -DCMAKE_CXX_COMPILER="$compiler" -DDELTAMESH_DECODER_ONLY=ON "${disabled[@]}"
