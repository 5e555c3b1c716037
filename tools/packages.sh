# Sourced by tools/run, tools/test, tools/check and .ci/run: the Debian packages that each needs, in one place.
# Change the lists here and nowhere else.

build_packages=(
  g++ cmake ninja-build pkg-config ccache
  libboost-dev libserialport-dev libcli11-dev libinih-dev libfmt-dev libspdlog-dev
  nlohmann-json3-dev libfast-float-dev libexpat1-dev libzip-dev zlib1g-dev
)

# Clipper and printrun are compared with rind; qemu runs the kernel of test_uart, with a real UART.
test_packages=(
  clang lld doctest-dev libbenchmark-dev libpolyclipping-dev python3 printrun-common
  qemu-system-x86 busybox-static cpio
)

# The cross compiler only reads: what core and firmware_link need to be for 32 bits.
check_packages=(clang-format clang-tidy g++-arm-linux-gnueabihf git)

# tools/package/build: what makes and judges a Debian package.
deb_packages=(dpkg-dev file gzip lintian git)

# Runs apt-get as root. It waits up to ten minutes for another program that installs packages.
run_apt_get() {
  local root=()
  [ "$EUID" -eq 0 ] || root=(sudo)
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600 "$@" \
    >/dev/null
}

# Asks for root only when something is missing.
install_missing() {
  local package missing=()
  for package in "$@"; do
    dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q '^install ok installed$' ||
      missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "installing ${missing[*]}"
  run_apt_get update
  run_apt_get install -y --no-install-recommends "${missing[@]}"
}

# Lets the compiler cache work across folders and with precompiled headers.
export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$PWD}
export CCACHE_NOHASHDIR=1
export CCACHE_SLOPPINESS=pch_defines,time_macros
cmake_options=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
