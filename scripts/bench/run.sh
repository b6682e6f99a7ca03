#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# run.sh quick|full BUILD OUT: runs the benchmarks that lie built under BUILD, leaves their JSON files and the plots in
# OUT, and brings the tables of docs/benchmarks.md up to date. Exit status: 0 all ran, 1 one failed, 2 a wrong word.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
extent=$1
build=$2
out=$3
case $extent in
quick) least_seconds=0.1 ;;
full) least_seconds=1 ;;
*)
    echo "bench: BENCH='$extent' must be quick or full" >&2
    exit 2
    ;;
esac

mkdir -p "$out"
for program in kernels_bench setup_bench; do
    "$build/benchmarks/$program" --benchmark_min_time=$least_seconds --benchmark_out="$out/$program.json" \
        --benchmark_out_format=json
done
"$build/throughput" "$extent" "$out/throughput.json"
build/venv/bin/python scripts/bench/plot.py "$out" docs/benchmarks.md docs/images
