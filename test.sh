#!/usr/bin/env bash
# Builds Relievo and runs every test, then the CPU rooms' tests again under the address and
# undefined-behaviour sanitizers. Installs the Debian packages that are missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. scripts/setup.sh

install_packages
build release all
step ctest --preset release -j "$(nproc)"
build asan cpu_tests
step ctest --preset asan -j "$(nproc)"
