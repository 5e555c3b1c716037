#!/bin/sh
# Installs the libraries, and builds and runs a project that finds them there.
#
#     usage_test.sh BUILD_FOLDER CMAKE C++_COMPILER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$2" --install "$1" --component development --prefix "$folder/installed" >/dev/null
"$2" -S "$here" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/installed" \
  -DCMAKE_CXX_COMPILER="$3" >/dev/null
"$2" --build "$folder/build" >/dev/null
printed=$("$folder/build/two_squares")
[ "$printed" = "150.0 mm2" ] || { echo "printed \"$printed\", not \"150.0 mm2\"" >&2; exit 1; }
"$2" --install "$1" --component program --prefix "$folder/program" >/dev/null
"$folder/program/bin/rind" --version
