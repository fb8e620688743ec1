# Read by app/run.sh and tests/run.sh: installs the Debian packages that are missing, configures and builds.

build_packages="g++ cmake ninja-build pkg-config python3-glad libglfw3-dev libimgui-dev libglm-dev libtinyobjloader-dev
  libosmesa6-dev libegl-dev libstb-dev zlib1g-dev libfreetype-dev nlohmann-json3-dev libgl1-mesa-dri
  fonts-dejavu-core fonts-ipaexfont-gothic"
test_packages="libgtest-dev libboost-dev xvfb xauth xdotool clang libclang-rt-14-dev clang-format clang-tidy"
peer_packages="libglu1-mesa-dev libcgal-dev libeigen3-dev libqhull-dev"  # what is compared with

# missing_packages NAME... prints those that are not installed.
missing_packages() {
  for package in "$@"; do
    state=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) || state=
    case "$state" in *" installed") ;; *) printf '%s ' "$package" ;; esac
  done
}

# ensure_packages NAME... installs what is missing when it may, otherwise says what is missing and fails.
ensure_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "note: no Debian package system here; these are needed: $*" >&2
    return 0
  fi
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  as_root=
  if [ "$(id -u)" != 0 ]; then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
      as_root=sudo
    else
      echo "missing packages: $missing" >&2
      echo "install them with: sudo apt-get install $missing" >&2
      return 1
    fi
  fi
  echo "installing: $missing" >&2
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q >&2 || true
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing >&2
}

# build FOLDER TARGET... configures once and builds; extra CMake arguments come in $configure_arguments.
build() {
  folder=$1
  shift
  if [ ! -f "$folder/build.ninja" ]; then
    # shellcheck disable=SC2086
    cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release $configure_arguments >&2
  fi
  cmake --build "$folder" --target "$@" >&2
}
