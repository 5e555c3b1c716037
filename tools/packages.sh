# Sourced by tools/run and tools/test: the Debian packages that each needs, in one place.
# Change the lists here and nowhere else.

build_packages=(
  g++ cmake ninja-build pkg-config
  libboost-dev libserialport-dev libcli11-dev libinih-dev libfmt-dev libspdlog-dev
  nlohmann-json3-dev libfast-float-dev libexpat1-dev libzip-dev libtbb-dev
)

# Clipper and printrun judge our work; qemu, with a kernel that test_uart fetches, has a real UART.
test_packages=(
  clang doctest-dev libbenchmark-dev libpolyclipping-dev python3 printrun-common
  qemu-system-x86 busybox-static cpio
)

# Asks for root only when something is missing.
install_missing() {
  local package missing=()
  for package in "$@"; do
    dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q '^install ok installed$' ||
      missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "installing ${missing[*]}"
  local root=()
  [ "$EUID" -eq 0 ] || root=(sudo)
  "${root[@]}" apt-get update -qq
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# Options for cmake: a compiler cache, where there is one.
cmake_options=()
if command -v ccache >/dev/null; then
  cmake_options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
