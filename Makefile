# SPDX-License-Identifier: BSD-3-Clause
# `make stand`, `make walk` and `make test` do everything on a fresh machine. Nothing leaves this folder, but that
# `make test` as root with apt installs a browser, for the one test that needs it.
PYTHON ?= python3
BIN := .venv/bin
# CMake's cache must not be shared between different checkouts or interpreters of the same folder.
BUILD = $(shell ls -d build/cp3* 2>/dev/null | head -n 1)
export PATH := $(CURDIR)/$(BIN):$(PATH)
export MUJOCO_GL ?= egl
# Two heavy translation units at a time: each may take 2 GB.
export CMAKE_BUILD_PARALLEL_LEVEL ?= 2

SOURCES := CMakeLists.txt bindings/CMakeLists.txt README.md LICENSE \
  $(shell find controller bindings/src bindings/surefoot benchmarks cmake models -type f -not -name '*.pyc')
BUILD_NEEDS := "libpinocchio[build]==4.1.0" "proxsuite[build]==0.8.0" "scikit-build-core>=0.11,<2" \
  "nanobind>=2.9,<4" "cmake>=3.22" "ninja>=1.11"

.PHONY: install stand walk test docs tests-cpp check generate lint sanitize fuzz clean

.venv/.tools: pyproject.toml
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install -q --upgrade pip
	$(BIN)/python -m pip install -q $(BUILD_NEEDS)
	touch $@

.venv/.installed: .venv/.tools $(SOURCES)
	$(BIN)/python -m pip install -q --no-build-isolation ".[all,dev]"
	touch $@

install: .venv/.installed

# The main job: a go1 stands on torques alone, with real sensors and two pushes.
stand: install
	$(BIN)/surefoot stand --robot go1 --duration 10 --sensors real \
	  --push lateral:50%:0.1@2.0 --push forward:50%:0.1@6.0 --report out/stand

# A go1 walks, is pushed, turns and stops, with the sensor errors and soft soles of a walk.
walk: install
	$(BIN)/surefoot walk --robot go1 --duration 10 --velocity 0.5,0,0@1 --velocity 0.3,0,1@4 \
	  --velocity 0,0,0@7 --push lateral:20%:0.1@3.0 --report out/walk

# For the test of the live page, where apt and its rights are there; that test is skipped without.
.venv/.browser: .venv/.installed
	@if [ -z "$$(command -v chromium-headless-shell chromium google-chrome)" ] \
	  && command -v apt-get > /dev/null && [ "$$(id -u)" = 0 ]; then \
	  (apt-get -qq update && apt-get -qq install -y --no-install-recommends chromium-headless-shell \
	    || apt-get -qq install -y --no-install-recommends chromium) > build/browser.log 2>&1 \
	    || echo "no browser installed (build/browser.log): the live page is not tested in one"; \
	fi
	@if [ -n "$$(command -v chromium-headless-shell chromium google-chrome)" ]; then touch $@; fi

# Tests that keep real time do so on a clock that waits while this machine stands still.
STALL_TOLERANT = rm -f build/stall_tolerant_clock; STALL_TOLERANT_CLOCK=$(CURDIR)/build/stall_tolerant_clock \
  LD_PRELOAD=$(CURDIR)/$(BUILD)/tests/cpp/libstall_tolerant_clock.so

# The site's packages; Doxygen too, where apt and its rights are there.
.venv/.docs: .venv/.tools pyproject.toml
	$(BIN)/python -m pip install -q --group docs
	@if ! command -v doxygen > /dev/null && command -v apt-get > /dev/null && [ "$$(id -u)" = 0 ]; then \
	  (apt-get -qq update && apt-get -qq install -y --no-install-recommends doxygen) \
	    > .venv/doxygen.log 2>&1 || echo "doxygen not installed (.venv/doxygen.log)"; \
	fi
	touch $@

# Cyclone DDS 0.10.2 for the tests of mixed versions, where apt and its rights are there; those tests
# are skipped without. Tests make environments of the vendor's Python classes in .venv-peers.
.venv/.dds: .venv/.tools
	@if ! ls /usr/lib/*-linux-gnu/libddsc.so.0debian > /dev/null 2>&1 \
	  && command -v apt-get > /dev/null && [ "$$(id -u)" = 0 ]; then \
	  (apt-get -qq update && apt-get -qq install -y --no-install-recommends \
	    cyclonedds-dev cyclonedds-tools libddsc0debian) > .venv/dds.log 2>&1 \
	    || echo "Cyclone DDS 0.10.2 not installed (.venv/dds.log): mixed versions are not tested"; \
	fi
	touch $@

# The documentation site, out/docs/index.html, and every code block of its pages. The blocks keep
# real time over UDP: they need the machine for themselves.
docs: install .venv/.docs
	$(BIN)/python docs/tools/build_site.py
	$(BIN)/python docs/tools/run_blocks.py

tests-cpp: install
	$(BIN)/cmake -S . -B $(BUILD) -DSUREFOOT_TESTS=ON -DSUREFOOT_GENERATOR=ON > build/configure.log 2>&1 \
	  || (cat build/configure.log; false)
	$(BIN)/cmake --build $(BUILD) --target surefoot_tests surefoot_allocations surefoot_fuzz \
	  surefoot_dds_tests surefoot_dds_fuzz surefoot_dds_allocations stall_tolerant_clock \
	  surefoot_print_leg_source
	cd $(BUILD) && ctest --output-on-failure

test: .venv/.dds tests-cpp .venv/.browser .venv/.docs
	$(BIN)/python -m pytest -n 2 --dist worksteal -m "not real_time"; status=$$?; \
	  $(STALL_TOLERANT) $(BIN)/python -m pytest -m real_time && exit $$status

# Generate the committed code of a tick's dynamics, controller/src/dynamics/generated; a C++ test compares them.
generate: install
	$(BIN)/cmake -S . -B $(BUILD) -DSUREFOOT_GENERATOR=ON > build/configure.log 2>&1 || (cat build/configure.log; false)
	$(BIN)/cmake --build $(BUILD) --target surefoot_generate

# Before every commit: lint, types, and the tests that take seconds; tests/README.md has the marks.
check: lint tests-cpp
	$(BIN)/python -m pytest -n 2 --dist worksteal -m "not (slow or build or real_time)"

lint: install
	$(BIN)/ruff check . && $(BIN)/ruff format --check .
	$(BIN)/clang-format --dry-run --Werror $(shell find controller bindings benchmarks tests examples -name '*.?pp')
	$(BIN)/mypy bindings/surefoot examples

# The C++ tests once more under AddressSanitizer and UndefinedBehaviorSanitizer.
sanitize: install
	$(BIN)/cmake -S . -B build/sanitize -G Ninja -DSUREFOOT_SANITIZE=ON -DSUREFOOT_TESTS=ON \
	  -DSUREFOOT_PYTHON=OFF -DPython_EXECUTABLE=$(CURDIR)/$(BIN)/python -DCMAKE_BUILD_TYPE=Release
	$(BIN)/cmake --build build/sanitize --target surefoot_tests
	build/sanitize/tests/cpp/surefoot_tests

# Ten million random and mutated datagrams through the decoders, under the sanitizers.
fuzz: install
	$(BIN)/cmake -S . -B $(BUILD) -DSUREFOOT_TESTS=ON > build/configure.log 2>&1 || (cat build/configure.log; false)
	$(BIN)/cmake --build $(BUILD) --target surefoot_fuzz
	$(BUILD)/tests/cpp/surefoot_fuzz 10000000

clean:
	rm -rf build out
