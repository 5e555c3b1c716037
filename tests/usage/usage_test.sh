#!/bin/sh
# Installs the libraries, and builds and runs a project that finds them there. Then installs the
# program, and looks for what belongs to it.
#
#     usage_test.sh BUILD_FOLDER CMAKE C++_COMPILER
set -eu
export LC_ALL=C
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
rind=$folder/program/bin/rind
"$rind" --version
(cd "$folder/program" && find . -type f | sed 's|^\./||; s|\.gz$||' | sort) >"$folder/there"
for page in $("$rind" manual); do
  echo "share/man/man${page##*.}/$page"
done >"$folder/expected"
cat >>"$folder/expected" <<'END'
bin/rind
lib/systemd/user/rind@.service
lib/udev/rules.d/60-rind.rules
share/applications/rind.desktop
share/bash-completion/completions/rind
share/doc/rind/CHANGELOG.md
share/doc/rind/LICENSE
share/doc/rind/README.md
share/fish/vendor_completions.d/rind.fish
share/metainfo/org.rind.rind.metainfo.xml
share/mime/packages/rind.xml
share/zsh/site-functions/_rind
END
sort "$folder/expected" | diff - "$folder/there"
# What was installed is what this program prints.
"$rind" completion bash | cmp - "$folder/program/share/bash-completion/completions/rind"
gzip -dcf "$folder/program/share/man/man1/rind-print.1"* >"$folder/page"
"$rind" manual rind-print.1 | cmp - "$folder/page"
