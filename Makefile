# SPDX-License-Identifier: BSD-3-Clause
# `make stand` and `make test` do everything on a fresh machine; nothing leaves this folder.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
export PATH := $(CURDIR)/$(BIN):$(PATH)
export MUJOCO_GL ?= egl
CXX_SOURCES := $(shell find controller bindings/src cmake tests/cpp -type f) CMakeLists.txt bindings/CMakeLists.txt
PY_SOURCES := $(shell find bindings/surefoot models -type f -name '*.py' -o -name '*.toml' -path 'models/*')

.PHONY: install stand test lint clean

$(VENV)/.tools: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install -q --upgrade pip
	$(BIN)/python -m pip install -q "libpinocchio[build]==4.1.0" cmake ninja "scikit-build-core>=0.11,<2" \
	  "nanobind>=2.9,<4" "proxsuite[build]==0.8.0"
	touch $@

$(VENV)/.installed: $(VENV)/.tools $(CXX_SOURCES) $(PY_SOURCES) pyproject.toml
	$(BIN)/python -m pip install -q --no-build-isolation ".[all,dev]"
	touch $@

install: $(VENV)/.installed

stand: install
	$(BIN)/surefoot stand --robot go1 --duration 10 --sensors real --push lateral:5.0:0.1@3.0 \
	  --push forward:7.0:0.1@6.0 --report out/stand

clean:
	rm -rf build out
