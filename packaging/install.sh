# Sourced by run.sh and test.sh: installs the Debian packages that are missing, and only those.

# The plain BLAS is named because apt would take OpenBLAS for it, which starts a thread a core with 128 MiB each, and asks
# for them for ever where the program's own limit of memory is below that.
build_packages=(
    build-essential cmake ninja-build pkg-config
    qt6-base-dev libqt6opengl6-dev qt6-charts-dev qt6-svg-dev libgl1-mesa-dev
    libquazip1-qt6-dev libeigen3-dev libsundials-dev libsuitesparse-dev libnlopt-cxx-dev libceres-dev libmatio-dev
    nlohmann-json3-dev libfmt-dev libcli11-dev libboost-math-dev libudunits2-dev
    libasmjit-dev libblas-dev liblapack-dev
    zlib1g-dev libgtest-dev libgmock-dev fonts-dejavu-core
)
format_packages=(clang-format)

say() { printf '\n==> %s\n' "$*"; }

is_installed() {
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        echo "error: this step needs root: run the script as root, or install sudo" >&2
        return 1
    fi
}

# install_missing PACKAGE…
install_missing() {
    local missing=() package
    for package in "$@"; do
        is_installed "$package" || missing+=("$package")
    done
    if [ ${#missing[@]} -eq 0 ]; then
        say "All $# Debian packages are installed"
        return
    fi
    if ! command -v apt-get >/dev/null; then
        echo "error: apt-get is not here; install by hand: ${missing[*]}" >&2
        return 1
    fi
    say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
    as_root apt-get update -qq
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}
