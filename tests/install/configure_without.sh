#!/usr/bin/env bash
# configure_without.sh SOURCE SCRATCH COMPILER OPTION PACKAGE...: the project is configured with an option where packages are not installed.
set -euo pipefail
source=$1 scratch=$2 compiler=$3 option=$4
shift 4
disabled=()
for package in "$@"; do disabled+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"); done
rm -rf "$scratch"
cmake -S "$source" -B "$scratch" -DCMAKE_CXX_COMPILER="$compiler" "$option" "${disabled[@]}"
