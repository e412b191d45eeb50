# Every target does the set-up that it needs; where that is done it costs nothing.
PYTHON ?= python3
BIN := .venv/bin

.PHONY: setup verify quick deep crosscheck mutants test soak check portable docs bench readme release lock clean

setup: .venv/.ready

verify: .venv/.ready
	$(BIN)/freewheel verify

quick: .venv/.ready
	$(BIN)/freewheel verify --quick

# Maps, regions and error budgets that take longer than a run may: results are stored in verify/measured.
deep: .venv/.ready
	$(BIN)/freewheel deep

# Second solvers on the same meshes and loads. A failed install of them is reported, and no error.
crosscheck: .venv/.ready .venv-crosscheck/.ready
	$(BIN)/freewheel crosscheck

# Fault detection: deliberate faults and what detects them; ALL=1 tries every mutant, for hours.
mutants: .venv/.ready
	$(BIN)/freewheel mutants $(if $(ALL),--all)

# Every row on emulated machines: other BLAS kernels, threads, instruction sets, perturbed inputs.
portable: .venv/.ready
	$(BIN)/freewheel portable

# One BLAS thread a worker, as `verify` has it: two workers of two threads each wait for each other.
# A file is one worker's, so that what its tests share is solved once (pytest 9.2 tells xdist 3.8 no groups).
test: .venv/.ready
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BIN)/pytest -n 2 --dist loadfile --no-loadscope-reorder

# Tests that take minutes each: kills at random moments, full disks, whole cases, other machines.
soak: .venv/.ready
	HYPOTHESIS_PROFILE=default OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BIN)/pytest -n 2 --dist loadfile -m "soak or not soak"

check: .venv/.ready
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python -m tools.words

# Pages for a browser in docs/_build/html, without a network; a warning is an error.
docs: .venv/.ready .venv-docs/.ready
	rm -rf docs/_build docs/*/_generated
	.venv-docs/bin/python -m sphinx -W --keep-going -q -j 2 docs docs/_build/html
	@echo "docs/_build/html/index.html"

bench: .venv/.ready
	$(BIN)/python -m benchmarks.plane
	$(BIN)/python -m benchmarks.contact
	$(BIN)/python -m benchmarks.freewheel
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BIN)/python -m benchmarks.strips
	$(BIN)/python -m benchmarks.half_space
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BIN)/python -m benchmarks.engagement
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BIN)/python -m benchmarks.optimum
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BIN)/python -m benchmarks.points
	$(BIN)/python -m benchmarks.sweep

# Tables of the documents and the verdicts of record, from a run of `make verify`.
readme:
	-$(MAKE) verify
	$(BIN)/python tools/readme.py

# `make release VERSION=1.0.2`: raises the version, stores the rows of a full run, commits and tags.
release: .venv/.ready
	@test -n "$(VERSION)" || { echo "make release needs a version: make release VERSION=1.0.2"; exit 2; }
	$(MAKE) check test
	$(BIN)/python tools/release.py $(VERSION)

# System libraries, then packages, in groups: what an interrupted set-up had downloaded is not downloaded again.
.venv/.ready: requirements.txt pyproject.toml
	@PYTHON=$(PYTHON) tools/system-check
	@$(PYTHON) -m verify.core.virtual_environment .venv requirements.txt --project

# Also where the folder was moved, its Python is gone, or PYTHON was given and is of another version.
ifneq ($(shell tools/is-ready $(if $(filter file,$(origin PYTHON)),,$(PYTHON)) && echo yes),yes)
.PHONY: .venv/.ready
endif

# Solvers that cannot be installed stop nothing: failed.txt has the reason, and the next run tries again.
.venv-crosscheck/.ready: requirements-crosscheck.txt .venv/.ready
	@.venv/bin/python -m verify.core.virtual_environment .venv-crosscheck requirements-crosscheck.txt --shared .venv \
		|| echo "without tamaas and ROSS"

.venv-docs/.ready: requirements-docs.txt .venv/.ready
	@.venv/bin/python -m verify.core.virtual_environment .venv-docs requirements-docs.txt --shared .venv

# Needs uv, which the project itself does not.
lock:
	uv pip compile --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
		--no-header --all-extras --group build --group dev -c requirements-docs.txt pyproject.toml -o requirements.txt
	uv pip compile --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
		--no-header requirements-crosscheck.in -o requirements-crosscheck.txt
	uv pip compile --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
		--no-header --group docs -c requirements.txt -o requirements-docs.txt

clean:
	rm -rf .venv .venv-crosscheck .venv-docs .cache reports/out docs/_build docs/*/_generated
