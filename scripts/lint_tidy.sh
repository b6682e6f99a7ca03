#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# lint_tidy.sh BUILD: clang-tidy (.clang-tidy) over every source of BUILD/compile_commands.json.
# Exit status: 0 nothing found, 1 findings.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
log=$1/clang-tidy.log
if ! run-clang-tidy -quiet -p "$1" -j "${JOBS:-1}" >"$log" 2>"$log.errors"; then
    grep -vE '^(clang-tidy|/.*/clang-tidy|[0-9]+ warnings)' "$log" >&2 || true
    echo "lint_tidy: findings; the whole log is $log" >&2
    exit 1
fi
echo "lint_tidy: $(grep -c '"file":' "$1/compile_commands.json") sources, no finding"
