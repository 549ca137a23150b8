# setup.sh: what demos/run.sh and tests/run.sh share: Debian packages by name, and how to build. Sourced by bash.

build_packages=(cmake ninja-build g++ pkg-config
    libglm-dev libtbb-dev libtinyobjloader-dev libdeflate-dev libstb-dev libeigen3-dev
    libcli11-dev nlohmann-json3-dev)
# bunny.obj; spider.obj and many more; cornell_box.obj
model_packages=(glmark2-data assimp-testmodels)
test_packages=(libgtest-dev libgmock-dev doxygen clang libclang-rt-14-dev libosmesa6-dev embree-tools
    python3-jsonschema)

# The stepper page in a browser, and traces against their schema: by npm packages where there is npm, which brings
# node. (Ubuntu's chromium is no package of apt's.)
if command -v npm >/dev/null && grep -qx 'ID=debian' /etc/os-release; then
    test_packages+=(chromium)
else
    test_packages+=(nodejs node-ajv)
fi

bench_packages=(libosmesa6-dev)

# install_packages NAME...: installs those that are missing; says so; does nothing when all are there.
install_packages() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "This is not Debian. Going on; what is needed is what these packages hold: $*" >&2
        return 0
    fi
    local name missing=() as_root=()
    for name in "$@"; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || missing+=("$name")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "$(id -u)" != 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "error: these Debian packages are missing, and there is neither root nor sudo to install them. As root:" >&2
            echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
            return 1
        fi
        as_root=(sudo)
    fi
    echo "Installing Debian packages: ${missing[*]}"
    "${as_root[@]}" apt-get -qq update || echo "apt-get update failed; trying with the lists at hand" >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -qq install -y --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}" >/dev/null
}

# processor_has FLAG...: as /proc/cpuinfo names them.
processor_has() {
    local flag
    for flag; do
        grep -qw "$flag" /proc/cpuinfo 2>/dev/null || return 1
    done
}
# Whether this processor runs x86-64-v3 programs (AVX2, FMA, BMI), and x86-64-v4 programs (AVX-512).
has_x86_64_v3() { processor_has avx2 fma bmi1 bmi2 movbe f16c abm; }
has_x86_64_v4() { has_x86_64_v3 && processor_has avx512f avx512bw avx512cd avx512dq avx512vl; }

# configure PRESET [CMAKE-OPTION...]: of build/PRESET, quietly unless it fails.
configure() {
    local preset=$1 log
    shift
    command -v ccache >/dev/null && set -- -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "$@"
    log=$(mktemp)
    if ! cmake --preset "$preset" "$@" >"$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        return 1
    fi
    rm -f "$log"
}

# build PRESET [OPTION...]: the options are those of `cmake --build`.
build() {
    local preset=$1
    shift
    cmake --build --preset "$preset" -j "$(nproc)" "$@"
}

# configure_and_build PRESET [CMAKE-OPTION...]
configure_and_build() {
    configure "$@" && build "$1"
}
