#!/usr/bin/env bash
# run_case.sh PROGRAM CASE SCRATCH: runs the script CASE in the empty folder SCRATCH and compares what it prints with the
# file of the same name that ends in .expected. With UPDATE=1 in the environment that file is rewritten instead.
#
# A case calls these functions:
#   run ARGUMENT...     prints the command, its standard output, its standard error and its exit code
#   figures ARGUMENT... the same with every number as N, for output that names sizes and errors
#   status ARGUMENT...  prints the command and its exit code only
#   quiet ARGUMENT...   prints nothing, stops the case on failure
#   has_keys FILE KEY... checks that FILE is one JSON object with these members
#   list                prints the names of the files in the folder
set -u
program=$1
case_script=$2
scratch=$3
here=$(cd "$(dirname "$case_script")" && pwd)
expected=$here/$(basename "$case_script" .sh).expected
export LC_ALL=C

say() { printf '%s\n' "$*"; }
capture() { "$program" "$@" >.out 2>.err; code=$?; }
run() {
  say "\$ deltamesh $*"
  capture "$@"
  cat .out
  sed 's/^/! /' .err
  say "exit $code"
}
figures() {
  say "\$ deltamesh $*"
  capture "$@"
  cat .out .err | sed -E 's/[0-9][0-9.,]*(e[+-]?[0-9]+)?/N/g; s/ +/ /g'
  say "exit $code"
}
status() {
  say "\$ deltamesh $*"
  capture "$@"
  say "exit $code"
}
quiet() {
  capture "$@" && [ "$code" = 0 ] && return
  say "unexpected failure: deltamesh $*"
  cat .out .err
  exit 1
}
has_keys() {
  local file=$1
  shift
  cmake "-DFILE=$file" "-DKEYS=$(IFS=';'; echo "$*")" -P "$here/../json_keys.cmake" 2>&1
}
list() { ls; }
cube() { # a cube of 12 triangles at $1, in OBJ
  cat >"$1" <<OBJ
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
OBJ
}

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch" || exit 1
actual=$(. "$here/$(basename "$case_script")" 2>&1)
if [ "${UPDATE:-}" = 1 ]; then
  printf '%s\n' "$actual" >"$expected"
elif ! diff -u "$expected" <(printf '%s\n' "$actual"); then
  echo "the output of $(basename "$case_script") is not the expected one (- expected, + actual)"
  exit 1
fi
cd / && rm -rf "$scratch"
