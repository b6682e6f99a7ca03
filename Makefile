# SPDX-License-Identifier: MIT
#
# The one door to Sheen: `make` lists what there is. Everything built lies under build/; every target that needs tools
# sets them up first, so that each works on a fresh clone.

PYTHON   ?= python3
GHDL     ?= ghdl
CLANG    ?= clang++
AC_TYPES ?= build/ac_types/4.8
JOBS     ?= $(shell nproc)
PREFIX   ?= /usr/local
DESTDIR  ?=
DEMO     ?= full
BENCH    ?= quick
CORE     ?=
PART     ?=
BOARD    ?=
SEEDS    ?= 5
UPDATE   ?= 0
SANITIZE ?= 0
TIDY     ?=
ifeq ($(origin CXX),default)
CXX := g++
endif

.DEFAULT_GOAL := help
.NOTPARALLEL:
.DELETE_ON_ERROR:
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
export PYTHON GHDL CXX AC_TYPES JOBS

VENV := build/venv/bin
# With the user's own ac_types nothing is fetched and the kernels are tested with these alone.
ifeq ($(AC_TYPES),build/ac_types/4.8)
AC_TYPES_OLD := build/ac_types/4.0
SETUP := build/setup/packages build/setup/python build/setup/ac_types
else
AC_TYPES_OLD :=
SETUP := build/setup/packages build/setup/python
endif
VERSION := $(shell sed -n 's/^project.sheen VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
AC_TYPES_ALL := $(AC_TYPES) $(AC_TYPES_OLD)

CONFIGURE = cmake -G Ninja -S . -Wno-dev --log-level=WARNING -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$(CXX)" \
    -DAC_TYPES="$(abspath $(AC_TYPES))" -DAC_TYPES_OLD="$(abspath $(AC_TYPES_OLD))"
define build_release
@$(CONFIGURE) -B build/release
@cmake --build build/release -j $(JOBS) --target
endef
CTEST = ctest --parallel $(JOBS) --output-on-failure --no-tests=error

##### Help

.PHONY: help
help:
	@echo "Sheen: Phong-quality shading at the price of Gouraud shading"
	@echo
	@echo "Targets:"
	@echo "  setup         install the tools: Debian packages, build/venv, build/ac_types"
	@echo "  doctor        list every tool: version found, version needed, how to get it"
	@echo "  build         library, command, tests, in build/release"
	@echo "  demo          shade a mesh on every device, compare the devices, say where the pictures are"
	@echo "  generate      write the generated VHDL packages, rtl_vhdl/generated, anew"
	@echo "  test          native tests, VHDL benches, co-simulation, fresh generated files; SANITIZE=1: native tests, sanitized"
	@echo "  test-full     test, all pictures on GHDL too, the native tests under sanitizers, and the installed package"
	@echo "  cosim         VHDL against kernels: every unit's vectors, whole pictures, random packets; says how many"
	@echo "  test-install  install under build/ and build a small project on the installed package"
	@echo "  lint          format, warnings, VHDL style, synthesizability; nothing may be found"
	@echo "  format        bring all C++ into the project's format"
	@echo "  test-ip       each core of make ip in a folder of its own: Icarus, Verilator, GHDL"
	@echo "  fpga          cores on FPGAs: area, clock, bitstreams in build/fpga, table in docs/fpga.md; BOARD=: its bitstream"
	@echo "  formal        proves that architectures for FPGA families equal the plain ones"
	@echo "  test-area     area of every unit and core against tests/area; UPDATE=1 records it"
	@echo "  bench         pixels per clock, speed of devices, kernels and host: tables in docs/benchmarks.md, plots in build/bench"
	@echo "  paper         what the papers show, made anew: pictures in build/paper, tables in docs/paper-results.md"
	@echo "  ip            cores to take away, in build/ip: one Verilog file, VHDL, example, FuseSoC file each"
	@echo "  install       headers, libsheen, CMake package, pkg-config file and command into PREFIX"
	@echo "  clean         remove what was built, keep what setup fetched; distclean removes that, too"
	@echo
	@echo "Variables:"
	@echo "  PREFIX        where install puts things; default = $(PREFIX)"
	@echo "  DESTDIR       staging folder before PREFIX, for packagers; default = $(DESTDIR)"
	@echo "  DEMO          small or full pictures; default = $(DEMO)"
	@echo "  BENCH         quick or full measurements; default = $(BENCH)"
	@echo "  CORE          cores of make ip (scripts/ip/cores.txt) or make fpga (scripts/fpga/designs.py); default = all"
	@echo "  PART          parts of make fpga: ecp5-85k-6 ecp5-85k-8 ice40-hx8k ice40-up5k; default = all"
	@echo "  BOARD         board of make fpga: ulx3s, hx8k_breakout or icebreaker; default = none, cores are built"
	@echo "  SEEDS         runs of placement and routing a core and part; default = $(SEEDS)"
	@echo "  SANITIZE      1: test under the address and undefined-behaviour sanitizers; default = $(SANITIZE)"
	@echo "  TIDY          all: clang-tidy looks at the tests, too, not at host and hls alone; default = none"
	@echo "  AC_TYPES      folder of ac_fixed.h; default = $(AC_TYPES)"
	@echo "  CXX           C++ compiler; default = $(CXX)"
	@echo "  CLANG         clang++ of the synthesizability check; default = $(CLANG)"
	@echo "  GHDL          VHDL simulator; default = $(GHDL)"
	@echo "  PYTHON        interpreter that build/venv is made with; default = $(PYTHON)"
	@echo "  JOBS          parallel jobs; default = $(JOBS)"
	@echo
	@echo "Example:"
	@echo "  make build && build/release/sheen render builtin:teapot --shininess 50 -o teapot.png"

##### Tools

.PHONY: setup doctor
setup: $(SETUP)
	@echo "setup: done"

doctor:
	@scripts/doctor.sh

build/setup/packages: scripts/tools.txt
build/setup/python: scripts/requirements.txt build/setup/packages
build/setup/ac_types: scripts/ac_types.sha256 build/setup/python
$(SETUP): build/setup/%: scripts/setup.sh
	@scripts/setup.sh $*
	@mkdir -p build/setup && touch $@

##### Building

.PHONY: build install generate check-generated bench paper ip
build: $(SETUP)
	$(build_release) all product

install: $(SETUP)
	$(build_release) product
	@DESTDIR="$(DESTDIR)" cmake --install build/release --prefix "$(PREFIX)"

generate: $(SETUP)
	$(build_release) generators
	@scripts/generate.sh build/release/generators rtl_vhdl/generated

check-generated: $(SETUP)
	$(build_release) generators
	@scripts/generate.sh --check build/release/generators rtl_vhdl/generated build/generated-check

bench: $(SETUP)
	$(build_release) benchmarks
	@scripts/bench/run.sh $(BENCH) build/release build/bench

paper: $(SETUP)
	$(build_release) paper_results
	@build/release/paper_results build/paper
	@$(VENV)/python scripts/paper/make_page.py build/paper docs/paper-results.md docs/images

ip: $(SETUP)
	$(build_release) make_ip_example
	@$(VENV)/python scripts/ip/make_ip.py build/ip build/release/make_ip_example $(VERSION) $(CORE)

# The tools of `make fpga` alone are large, so they come when it first needs them.
build/setup/fpga: scripts/setup.sh scripts/requirements-fpga.txt build/setup/packages build/setup/python
	@scripts/setup.sh fpga
	@touch $@

.PHONY: fpga test-area
fpga: $(SETUP) build/setup/fpga
	@$(VENV)/python scripts/fpga/make_fpga.py --core "$(CORE)" --part "$(PART)" --board "$(BOARD)" --seeds "$(SEEDS)" \
	    --jobs "$(JOBS)"

test-area: $(SETUP)
	@$(VENV)/python scripts/fpga/test_area.py --update "$(UPDATE)" --jobs $(JOBS)

.PHONY: demo
demo: $(SETUP)
	$(build_release) product
	@scripts/demo.sh $(DEMO)

##### Tests

.PHONY: test test-native test-vhdl test-sanitize test-install test-ip test-full
IP_TEST ?= quick
ifeq ($(SANITIZE),1)
test: test-sanitize
else
test: check-generated test-native test-vhdl test-pictures test-ip
	@echo "test: generated files are fresh; native tests, VHDL benches, pictures on all devices, cores to take away passed"
endif

test-native: build
	@$(CTEST) --test-dir build/release

test-vhdl: build
	@$(VENV)/python testbench/run.py --output-path build/vunit -p $(JOBS)

# Architectures of one entity for several families: proofs that they are equal.
.PHONY: formal
formal: $(SETUP)
	@scripts/formal.sh

.PHONY: cosim test-pictures test-pictures-full
cosim: test-vhdl test-pictures

test-pictures: build
	@build/release/cosim_pictures

test-pictures-full: build
	@build/release/cosim_pictures --full

test-sanitize: $(SETUP)
	@$(CONFIGURE) -B build/sanitize -DSHEEN_SANITIZE=ON -DAC_TYPES_OLD=
	@cmake --build build/sanitize -j $(JOBS) --target all product
	@$(CTEST) --test-dir build/sanitize

test-install: build
	@scripts/test_install.sh build/install-test

test-ip: ip
	@scripts/ip/test_ip.sh $(IP_TEST) build/ip

test-full: IP_TEST := full
test-full: test test-pictures-full test-sanitize test-install

##### Lint

.PHONY: lint lint-files lint-format lint-vhdl lint-kernels lint-headers lint-tidy format
lint: lint-files lint-format lint-kernels lint-vhdl check-generated lint-headers build lint-tidy
	@echo "lint: nothing found"

lint-files:
	@scripts/check_files.sh

CPP_FILES = $(shell find host hls tests constraints testbench -name '*.cpp' -o -name '*.hpp')
lint-format: $(SETUP)
	@clang-format --dry-run -Werror $(CPP_FILES)

format: $(SETUP)
	@clang-format -i $(CPP_FILES)

lint-kernels: $(SETUP)
	@$(PYTHON) scripts/check_synthesizable.py --clang "$(CLANG)" --out build/lint/ir $(AC_TYPES_ALL:%=--ac-types %) \
	    hls/tops/*.cpp

lint-vhdl: $(SETUP)
	@scripts/lint_vhdl.sh build/lint/vhdl

lint-headers: $(SETUP)
	@CLANG="$(CLANG)" scripts/lint_headers.sh $(AC_TYPES_ALL)

lint-tidy: $(SETUP)
	@$(CONFIGURE) -B build/lint/tidy -DAC_TYPES_OLD=
	@scripts/lint_tidy.sh build/lint/tidy $(TIDY)

##### Cleaning

.PHONY: clean distclean
clean:
	@if [ -d build ]; then \
	    find build -mindepth 1 -maxdepth 1 ! -name setup ! -name venv ! -name ac_types -exec rm -rf {} +; fi

distclean:
	@rm -rf build
