#!/usr/bin/env bash
# Builds volsurf, with warnings as errors, and runs its tests, from nothing but a clone and Debian 12.
#
# In:  options for ctest, for example `-R io`. May be run from any folder, as root or as a user who may use sudo (for
#      the packages only). Tests labelled `slow` are left out; `ctest --preset release` runs them too.
# Out: what ctest says, its closing line last, and its exit code.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/install_packages.sh" --test --render
cd "$root"
cmake --preset release -DVOLSURF_BUILD_TESTS=ON
cmake --build --preset release --parallel
scripts/fetch_data.sh build/release/real-data || echo "test.sh: without real volumes; the tests that need them are skipped"
exec ctest --preset release --label-exclude slow "$@"
