# shellcheck shell=bash
# What run.sh and test.sh share: install what is missing, build, stop at the first failure with the
# command that failed. Sourced in the repository's root.

program=$(basename "$0")
package_list=scripts/debian_packages.txt

# step COMMAND…: runs it; when it fails, says which command it was and stops with its status.
step() {
    local status=0
    "$@" || status=$?
    if [ "$status" -ne 0 ]; then
        echo "$program: failed: $*" >&2
        exit "$status"
    fi
}

# Prints the packages of the list that are not installed, one a line.
missing_packages() {
    comm -23 \
        <(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$package_list" | LC_ALL=C sort) \
        <(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' |
            sed -n 's/^installed //p' | LC_ALL=C sort -u)
}

# Installs what is missing. Where that is not possible, says what is needed and goes on: the
# libraries may be there under other names, and configuring tells.
install_packages() {
    local missing become_root=()
    if ! command -v apt-get >/dev/null; then
        echo "$program: note: no apt-get here; the Debian packages needed are in $package_list"
        return
    fi
    mapfile -t missing < <(missing_packages)
    if [ "${#missing[@]}" -eq 0 ]; then
        return
    fi
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "$program: note: not root and no sudo, so not installing: ${missing[*]}"
            return
        fi
        become_root=(sudo)
    fi
    echo "$program: installing ${missing[*]}"
    step "${become_root[@]}" apt-get update -q
    step "${become_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# build PRESET TARGET…: configures with a preset of CMakePresets.json and builds the targets.
build() {
    local preset=$1
    shift
    step cmake --preset "$preset"
    step cmake --build --preset "$preset" --target "$@"
}
