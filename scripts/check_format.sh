#!/usr/bin/env bash
# Checks that the C++ sources are formatted as .clang-format says; `--fix` formats them.
#
# In:  the folders src, apps and tests of this repository.
# Out: clang-format's complaints, and exit code 1 if there are any.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
mode=(--dry-run -Werror)
[[ ${1-} != --fix ]] || mode=(-i)
find src apps tests -name '*.h' -print0 -o -name '*.cpp' -print0 | xargs -0 -r clang-format "${mode[@]}"
