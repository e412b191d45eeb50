# What a fresh checkout needs is made on the way; the second time it costs nothing.
PYTHON ?= python3
BIN := .venv/bin

.PHONY: verify quick deep crosscheck mutants test check portable bench readme lock clean

verify: .venv/.ready
	$(BIN)/freewheel verify

quick: .venv/.ready
	$(BIN)/freewheel verify --quick

# Maps, regions and error budgets that take longer than a run may: what was measured is kept in verify/measured.
deep: .venv/.ready
	$(BIN)/freewheel deep

# Second solvers on the same meshes and loads. A failed install of theirs is told, and no error.
crosscheck: .venv/.ready .venv-crosscheck/.ready
	$(BIN)/freewheel crosscheck

# What the suite catches of mistakes made on purpose; ALL=1 tries every mutant, for hours.
mutants: .venv/.ready
	$(BIN)/freewheel mutants $(if $(ALL),--all)

# Every row on emulated machines: other BLAS kernels, threads, instruction sets, perturbed inputs.
portable: .venv/.ready
	$(BIN)/freewheel portable

# One BLAS thread a worker, as `verify` has it: two workers of two threads each wait for each other.
# A file is one worker's, so that what its tests share is solved once (pytest 9.2 tells xdist 3.8 no groups).
test: .venv/.ready
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BIN)/pytest -n 2 --dist loadfile --no-loadscope-reorder

check: .venv/.ready
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

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

# The table of verdicts in README.md, from the last run of `make verify`.
readme: verify
	$(BIN)/python tools/readme.py

.venv/.ready: requirements.txt pyproject.toml tools/system-check
	PYTHON=$(PYTHON) tools/system-check
	$(PYTHON) -m venv .venv
	$(BIN)/pip install --quiet --disable-pip-version-check --require-hashes -r requirements.txt
	$(BIN)/pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
	touch $@

# The lock is whole, so that nothing is resolved; without the solvers, why is kept in failed.txt.
.venv-crosscheck/.ready: requirements-crosscheck.txt
	rm -rf .venv-crosscheck && mkdir .venv-crosscheck
	{ $(PYTHON) -m venv .venv-crosscheck && .venv-crosscheck/bin/pip install --quiet \
		--disable-pip-version-check --no-deps --require-hashes -r $<; } 2> .venv-crosscheck/said.txt \
		|| { grep -m 1 -i error .venv-crosscheck/said.txt > .venv-crosscheck/failed.txt; \
		rm -rf .venv-crosscheck/bin; }
	touch $@

# Needs uv, which the project itself does not.
lock:
	uv pip compile --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
		--no-header --group build --group dev pyproject.toml -o requirements.txt
	uv pip compile --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
		--no-header requirements-crosscheck.in -o requirements-crosscheck.txt

clean:
	rm -rf .venv .venv-crosscheck .cache reports/out
