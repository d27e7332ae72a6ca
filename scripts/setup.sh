# Sourced by scripts/run and scripts/test: installs what is missing, configures by preset and builds.
# Expects `root`, the folder of the sources; sets `build`.
# shellcheck shell=sh disable=SC2154

build=$root/build/release

# missing_packages FILE: those it names that are not installed, on one line.
missing_packages() {
    wanted=$(grep -v '^#' "$1")
    # shellcheck disable=SC2086  # one word a package
    installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' $wanted 2>/dev/null |
        sed -n 's/ installed$//p') || true
    missing=
    for package in $wanted; do
        printf '%s\n' "$installed" | grep -Fqx -e "$package" || missing="$missing $package"
    done
    printf '%s\n' "${missing# }"
}

# quietly COMMAND...: its output replaces the file `log`; when it fails, the output is shown.
quietly() {
    "$@" >"$log" 2>&1 && return 0
    # The lines of progress would hide the reason.
    grep -Ev '^\[[0-9]+/[0-9]+\] (Building|Linking|Embedding|Re-checking|Generating)' "$log" >&2
    echo "The whole log is $log." >&2
    return 1
}

# install_packages PREFIX PACKAGE...: PREFIX is what lends the rights: nothing, or sudo.
install_packages() {
    prefix=$1
    shift
    log=$(mktemp)
    # shellcheck disable=SC2086  # an empty prefix is no word
    quietly $prefix env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 update || return 1
    # shellcheck disable=SC2086
    quietly $prefix env DEBIAN_FRONTEND=noninteractive \
        apt-get -q -y --no-install-recommends -o DPkg::Lock::Timeout=300 install "$@" || return 1
    rm -f "$log"
}

# set_up_packages [FILE]: what the list names, scripts/packages where none is given.
set_up_packages() {
    if ! command -v dpkg-query >/dev/null 2>&1; then
        echo "This is not Debian: the libraries that scripts/packages names must be there already." >&2
        return 0
    fi
    missing=$(missing_packages "${1:-$root/scripts/packages}")
    [ -n "$missing" ] || return 0

    echo "Installing what is missing: $missing" >&2
    # shellcheck disable=SC2086
    if [ "$(id -u)" = 0 ]; then
        install_packages '' $missing </dev/null && return 0
    elif command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
        install_packages sudo $missing && return 0
    fi
    echo "These packages could not be installed from here. As root, type:" >&2
    echo "    apt-get update && apt-get install --no-install-recommends $missing" >&2
    exit 2
}

# build_targets TARGET...: says little unless something fails. On a terminal ninja shows its progress in one line.
build_targets() {
    mkdir -p "$build"
    log=$build/build.log
    # Who configured before may have asked for the tests of minutes, and for files that are compiled one by one.
    fresh=
    [ -f "$build/CMakeCache.txt" ] || fresh='-DPELAGE_LONG_TESTS=OFF -DCMAKE_UNITY_BUILD=ON'
    # shellcheck disable=SC2086  # some words, or none
    quietly cmake -S "$root" --preset release $fresh || exit 2
    if [ -t 2 ]; then
        cmake --build "$build" --target "$@" >&2 || exit 2
    else
        echo "Building in $build; the log is $log" >&2
        quietly cmake --build "$build" --target "$@" || exit 2
    fi
}
