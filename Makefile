# GearStudio: make run, make test. Both set up everything they need in .venv the first time.
PY := .venv/bin/python
unexport PYTHONDONTWRITEBYTECODE PYTHONHOME PYTHONPATH
export PYTHONFAULTHANDLER := 1
.NOTPARALLEL:
.PHONY: help run test lint format unit bench bundle clean

help:
	@echo "make run     open the window (without a display: a picture and the comparison in out/)"
	@echo "make test    import contracts, style, types, then all tests, with real windows on a virtual screen"
	@echo "make bench   the timed promises, each with its target"
	@echo "make bundle  a folder dist/gearstudio that runs without Python, tried on a virtual screen"
	@echo "make format  put the code into the house style"
	@echo "make clean   remove .venv and everything made"

run:
	@bash tools/bootstrap.sh run
	@bash tools/run.sh

test: lint unit

lint:
	@bash tools/bootstrap.sh dev
	$(PY) -c "from importlinter.cli import lint_imports_command; lint_imports_command(['--no-logo'])"
	$(PY) -m ruff check .
	$(PY) -m ruff format --check .
	$(PY) -m mypy

# All tests on all cores. Some only, one after the other: make unit T="tests/theory -k cone"
unit:
	@bash tools/bootstrap.sh dev
	bash tools/screen.sh $(PY) -m pytest $(or $(T),-n auto --dist worksteal)

format:
	@bash tools/bootstrap.sh dev
	$(PY) -m ruff check --fix .
	$(PY) -m ruff format .

bench:
	@bash tools/bootstrap.sh bench
	bash tools/screen.sh $(PY) -m benchmarks
	bash tools/screen.sh $(PY) -m benchmarks.memory

bundle:
	@bash tools/bootstrap.sh bundle
	$(PY) -m PyInstaller --noconfirm --log-level ERROR --distpath dist --workpath build packaging/gearstudio.spec
	bash tools/screen.sh dist/gearstudio/gearstudio --demo out
	@du -sh dist/gearstudio

clean:
	rm -rf .venv out build dist *.egg-info .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis
