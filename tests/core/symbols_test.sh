#!/bin/sh
# core must not ask the C library for functions whose last bit differs from one system to the next.
#
#     symbols_test.sh NM LIBCORE
set -eu
inexact='sin cos tan asin acos atan atan2 sinh cosh tanh exp exp2 expm1 log log2 log10 log1p pow cbrt
  hypot sincos fma tgamma lgamma erf erfc'
symbols=$("$1" -u --format=posix "$2" | sed -n 's/^\([a-z0-9_]*\)\(@.*\)\? U.*/\1/p' | sort -u)
[ -n "$symbols" ] || { echo "no symbols found in $2" >&2; exit 1; }
found=
for name in $inexact; do
  for spelled in "$name" "${name}f" "${name}l"; do
    if echo "$symbols" | grep -qx "$spelled"; then found="$found $spelled"; fi
  done
done
[ -z "$found" ] || { echo "core uses$found: core/trigonometry.h has its own" >&2; exit 1; }
