# Pilotage from a fresh machine: `make demo` and `make test`. Needs python3, a C++17 compiler and make.

PYTHON ?= python3
PRESET ?= default
JOBS ?= $(shell nproc)
VENV := $(CURDIR)/.venv
PIP := $(VENV)/bin/python -m pip --disable-pip-version-check
# For `make fuzz`: of each target.
SECONDS := 60
# Thread sanitizers of some years do not know the addresses that newer kernels give at random.
FIXED_ADDRESSES = $(shell setarch -R true 2>/dev/null && echo setarch -R)
# Recipes find the virtual environment's cmake, ninja and python3 first.
IN_VENV := PATH="$(VENV)/bin:$$PATH"

SOURCES := $(shell find cpp bindings lcmtypes configs python cmake CMakeLists.txt pyproject.toml \
                        -type f ! -name '*.pyc')
BUILD_REQUIRES := $(shell sed -n 's/^requires = \[\(.*\)\]/\1/p' pyproject.toml | tr ',' ' ')
CPP_FILES = $(shell find cpp bindings tests bench examples -name '*.[ch]pp' 2>/dev/null)

.PHONY: help demo test test-cpp test-python lint format tidy stubs wheel bench sanitize fuzz soak clean
.NOTPARALLEL:

help:
	@echo 'make demo      install into .venv, simulate a drive, localize it live, draw it'
	@echo 'make test      all C++ and Python tests'
	@echo 'make lint      formatting, style, types      make format   put formatting right'
	@echo 'make tidy      clang-tidy (slow)             make stubs    write _core.pyi anew'
	@echo 'make wheel     a wheel in dist/              make bench    benchmarks'
	@echo 'make sanitize  C++ tests under address, undefined-behaviour and thread sanitizers'
	@echo 'make fuzz      engine and file readers fed by libFuzzer (SECONDS=60)'
	@echo 'make soak      two hours of traffic through a live node, in four minutes'
	@echo 'make clean     remove what was built, and .venv'

$(VENV)/.made: pyproject.toml
	@PYTHON="$(PYTHON)" tools/prepare-machine
	$(PYTHON) -m venv $(VENV)
	$(PIP) install -q 'cmake>=3.22' ninja $(BUILD_REQUIRES)
	@touch $@

# Without isolation, so that the build in build/ is kept and only what changed is compiled.
$(VENV)/.installed: $(VENV)/.made $(SOURCES)
	$(IN_VENV) $(PIP) install -q --no-build-isolation .
	@touch $@

$(VENV)/.tools: pyproject.toml | $(VENV)/.installed
	$(IN_VENV) $(PIP) install -q --no-build-isolation '.[test,dev]'
	@touch $@

demo: $(VENV)/.installed
	$(VENV)/bin/pilotage demo

test: test-cpp test-python

test-cpp: $(VENV)/.made
	@PYTHON="$(PYTHON)" tools/prepare-machine tests
	$(IN_VENV) cmake --preset $(PRESET) -G Ninja
	$(IN_VENV) cmake --build --preset $(PRESET) -j $(JOBS)
	$(IN_VENV) ctest --preset $(PRESET) -j $(JOBS)

test-python: $(VENV)/.tools
	$(IN_VENV) python -m pytest -n $(JOBS) --dist worksteal $(PYTEST)

lint: $(VENV)/.tools
	$(IN_VENV) ruff check
	$(IN_VENV) ruff format --check
	$(IN_VENV) mypy
	$(IN_VENV) clang-format --dry-run --Werror $(CPP_FILES)

format: $(VENV)/.tools
	$(IN_VENV) ruff check --fix
	$(IN_VENV) ruff format
	$(IN_VENV) clang-format -i $(CPP_FILES)

tidy: $(VENV)/.made
	$(PIP) install -q "$$(sed -n 's/^tidy = \["\(.*\)"\]/\1/p' pyproject.toml)"
	$(IN_VENV) cmake --preset default -G Ninja
	$(IN_VENV) cmake --build build/cpp --target pilotage_lcmtypes_headers
	find cpp -name '*.cpp' | $(IN_VENV) xargs -n 1 -P $(JOBS) clang-tidy --quiet -p build/cpp

stubs: $(VENV)/.tools
	$(IN_VENV) pybind11-stubgen pilotage._core -o build/stubs
	cp build/stubs/pilotage/_core.pyi python/pilotage/_core.pyi

wheel: $(VENV)/.made
	$(IN_VENV) $(PIP) wheel --no-build-isolation --no-deps -w dist .

bench: $(VENV)/.installed
	$(IN_VENV) $(PIP) install -q --no-build-isolation '.[bench]'
	$(IN_VENV) cmake --preset bench -G Ninja
	$(IN_VENV) cmake --build --preset bench -j $(JOBS)
	$(IN_VENV) python bench/run.py

sanitize: $(VENV)/.made
	@PYTHON="$(PYTHON)" tools/prepare-machine tests clang
	for preset in asan tsan; do \
	    $(IN_VENV) cmake --preset $$preset -G Ninja && \
	    $(IN_VENV) cmake --build --preset $$preset -j $(JOBS) && \
	    $(IN_VENV) $(FIXED_ADDRESSES) ctest --preset $$preset -j $(JOBS) || exit 1; \
	done

fuzz: $(VENV)/.made
	@PYTHON="$(PYTHON)" tools/prepare-machine clang
	$(IN_VENV) cmake --preset fuzz -G Ninja
	$(IN_VENV) cmake --build --preset fuzz -j $(JOBS)
	for what in engine files; do tests/fuzz/run $$what $(SECONDS) || exit 1; done

soak: $(VENV)/.tools
	$(IN_VENV) PYTHONPATH=tests/python python tests/soak/soak.py

clean:
	rm -rf build dist $(VENV)
