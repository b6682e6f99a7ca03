#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# lint_tidy.sh BUILD [all]: clang-tidy (.clang-tidy) over the sources of BUILD/compile_commands.json that make the
# product, host/ and hls/; with `all` over tests and simulators' harnesses, too, which takes three times as long.
# Exit status: 0 nothing found, 1 findings.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
log=$1/clang-tidy.log
scope='/(host|hls)/'
[[ ${2:-} != all ]] || scope='/'
if ! run-clang-tidy -quiet -p "$1" -j "${JOBS:-1}" "$PWD$scope" >"$log" 2>"$log.errors"; then
    grep -vE '^(clang-tidy|/.*/clang-tidy|[0-9]+ warnings)' "$log" >&2 || true
    echo "lint_tidy: findings; the whole log is $log" >&2
    exit 1
fi
echo "lint_tidy: $(grep '"file":' "$1/compile_commands.json" | sort -u | grep -cE "$PWD$scope") sources, no finding"
