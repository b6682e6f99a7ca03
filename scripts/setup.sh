#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# setup.sh packages   installs the Debian packages of tools.txt that doctor.sh finds missing (as root or with sudo)
# setup.sh python     makes the Python environment build/venv from requirements.txt
# setup.sh fpga       adds requirements-fpga.txt to build/venv: placement and routing for ECP5, for `make fpga` alone
# setup.sh ac_types   puts the ac_types headers, releases 4.0 and 4.8, under build/ac_types/
#
# Each is idempotent and leaves what is already right alone. PYTHON names the interpreter of the environment.
# Exit status: 0 done, 1 something could not be had; the last line says what to do.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
readonly attempts=4

fail() {
    echo "setup: $*" >&2
    exit 1
}

# retry COMMAND...: networks fail; tries a few times, waiting longer each time.
retry() {
    local attempt
    for ((attempt = 1; attempt <= attempts; attempt++)); do
        "$@" && return 0
        echo "setup: attempt $attempt of $attempts failed: $*" >&2
        [[ $attempt -lt $attempts ]] && sleep $((attempt * 5))
    done
    return 1
}

setup_packages() {
    local -a packages as_root=()
    mapfile -t packages < <(scripts/doctor.sh --missing)
    if [[ ${#packages[@]} -eq 0 ]]; then
        echo "setup: every system package is there"
        return 0
    fi
    local by_hand="apt-get update && apt-get install -y ${packages[*]}"
    command -v apt-get >/dev/null || fail "no apt-get here; install the counterparts of: ${packages[*]}"
    if [[ $(id -u) -ne 0 ]]; then
        command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [[ -t 0 ]]; } ||
            fail "packages are missing; as root, run:  $by_hand"
        as_root=(sudo)
    fi
    as_root+=(env DEBIAN_FRONTEND=noninteractive)
    echo "setup: installing ${packages[*]}"
    retry "${as_root[@]}" apt-get -q update || fail "apt-get update failed; as root, run:  $by_hand"
    retry "${as_root[@]}" apt-get -qy install --no-install-recommends "${packages[@]}" ||
        fail "apt-get install failed; as root, run:  $by_hand"
    mapfile -t packages < <(scripts/doctor.sh --missing)
    [[ ${#packages[@]} -eq 0 ]] || fail "still missing or too old: ${packages[*]}; \`make doctor\` tells the versions"
}

setup_python() {
    local python=build/venv/bin/python
    "$python" -c '' 2>/dev/null || "${PYTHON:-python3}" -m venv --clear build/venv
    echo "setup: Python packages into build/venv"
    retry "$python" -m pip install --quiet --disable-pip-version-check --requirement scripts/requirements.txt ||
        fail "pip could not install scripts/requirements.txt"
}

setup_fpga() {
    local python=build/venv/bin/python
    echo "setup: tools for ECP5 into build/venv"
    retry "$python" -m pip install --quiet --disable-pip-version-check --requirement scripts/requirements-fpga.txt ||
        fail "pip could not install scripts/requirements-fpga.txt"
}

# The headers travel in a Python package, as templates of its code generators. Both hashes are checked: the package's
# before anything is taken out of it, the headers' before anything is told that they are there.
setup_ac_types() {
    local wheel=hls4ml-1.3.0-py3-none-any.whl
    local wheel_sha256=01bf1de2cd9bca56699b9fe3385cb1735026b022f9580fe1d73faf192dfb90f2
    mkdir -p build/ac_types build/setup
    if (cd build/ac_types && sha256sum --check --status ../../scripts/ac_types.sha256 2>/dev/null); then
        echo "setup: ac_types 4.0 and 4.8 are there"
        return 0
    fi
    echo "setup: ac_types 4.0 and 4.8 out of $wheel"
    retry build/venv/bin/python -m pip download --quiet --disable-pip-version-check --no-deps --only-binary :all: \
        --dest build/setup hls4ml==1.3.0 || fail "pip could not download hls4ml==1.3.0; or set AC_TYPES=folder of ac_fixed.h"
    echo "$wheel_sha256  build/setup/$wheel" | sha256sum --check --status ||
        fail "build/setup/$wheel has another SHA-256 than $wheel_sha256; remove it and try again"
    build/venv/bin/python - "build/setup/$wheel" build/ac_types <<'EXTRACT'
import pathlib
import sys
import zipfile

sources = {
    "4.0": "hls4ml/templates/quartus/ac_types/",
    "4.8": "hls4ml/templates/catapult/ac_types/include/",
}
with zipfile.ZipFile(sys.argv[1]) as wheel:
    for release, source in sources.items():
        folder = pathlib.Path(sys.argv[2]) / release
        folder.mkdir(parents=True, exist_ok=True)
        for name in wheel.namelist():
            if name.startswith(source) and name.endswith(".h"):
                (folder / name[len(source):]).write_bytes(wheel.read(name))
EXTRACT
    (cd build/ac_types && sha256sum --check --quiet ../../scripts/ac_types.sha256) ||
        fail "the headers under build/ac_types/ differ from scripts/ac_types.sha256"
    rm "build/setup/$wheel"
}

case ${1:-} in
packages | python | fpga | ac_types) "setup_$1" ;;
*)
    echo "usage: setup.sh packages|python|fpga|ac_types" >&2
    exit 2
    ;;
esac
