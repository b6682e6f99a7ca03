#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# lint_headers.sh AC_TYPES...: compiles every public header alone with clang, all warnings errors; the kernels' with each
# of the given ac_types. So a header includes what it needs, and a second compiler reads the kernels.
# Exit status: 0 nothing found, 1 findings.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

# check_header AC_TYPES HEADER
check_header() {
    "${CLANG:-clang++}" -std=c++17 -fsyntax-only -Wall -Wextra -Wconversion -Wshadow -Werror -Ihost/include \
        -Ihls/include -isystem "$1" -x c++ -include "$2" /dev/null
}
export -f check_header

for ac_types in "$@"; do
    find hls/include -name '*.hpp' -print0 |
        xargs -0 -I{} -P "${JOBS:-1}" bash -c 'check_header "$@"' check "$ac_types" {}
done
find host/include -name '*.hpp' -print0 | xargs -0 -I{} -P "${JOBS:-1}" bash -c 'check_header "$@"' check "$1" {}
echo "lint_headers: $(find host/include hls/include -name '*.hpp' | wc -l) headers, each alone, no warning"
