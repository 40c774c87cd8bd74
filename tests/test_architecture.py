"""The house rules that a machine can check: who imports whom, what stays light, how long a file is."""

from __future__ import annotations

import ast
import json
import statistics
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from importlib.metadata import packages_distributions, version
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parent.parent
SOURCES = sorted([ROOT / "main.py", *ROOT.glob("gearstudio/**/*.py"), *ROOT.glob("ui/**/*.py")])
KERNEL = {"OCP", "build123d", "ocp_gordon", "ocpsvg", "cadquery_ocp_proxy"}
RENDERER = {"vtk", "vtkmodules", "pyvista", "pyvistaqt"}
TOOLKIT = {"PySide6", "shiboken6", "qtpy"}
WIDGETLESS = ("ui/session.py", "ui/controller.py", "ui/runner.py", "ui/undo.py")


def relative(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def imported_modules(path: Path) -> Iterator[str]:
    """Every module that a file names in an import, wherever in the file; ``a.b.c`` for ``from a.b import c`` too."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def modules_after(statement: str) -> set[str]:
    """Top-level names in sys.modules after a statement in a fresh interpreter."""
    program = (
        f"import sys, json\n{statement}\nprint(json.dumps(sorted({{name.split('.')[0] for name in sys.modules}})))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    return set(json.loads(done.stdout.splitlines()[-1]))


def package_modules(package: str) -> list[str]:
    files = (ROOT / package.replace(".", "/")).rglob("*.py")
    return sorted(relative(f).removesuffix(".py").removesuffix("/__init__").replace("/", ".") for f in files)


def test_import_contracts() -> None:
    command = "from importlinter.cli import lint_imports_command; lint_imports_command(['--no-logo', '--no-cache'])"
    done = subprocess.run([sys.executable, "-c", command], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("package", ["gearstudio.theory", "gearstudio"])
def test_theory_needs_numpy_alone(package: str) -> None:
    names = package_modules("gearstudio.theory") if package.endswith("theory") else [package]
    loaded = modules_after("import " + ", ".join(names))
    assert not loaded & (KERNEL | RENDERER | TOOLKIT | {"scipy", "matplotlib"})


@pytest.mark.parametrize(
    ("module", "heavy"),
    [
        ("main", KERNEL | RENDERER | TOOLKIT | {"numpy", "scipy", "pydantic"}),
        ("gearstudio.cli", KERNEL | RENDERER | TOOLKIT),
        ("gearstudio.jobs", KERNEL | RENDERER | TOOLKIT),
        ("ui.app", KERNEL | RENDERER),
    ],
)
def test_import_stays_light(module: str, heavy: set[str]) -> None:
    assert not modules_after(f"import {module}") & heavy


def test_kernel_is_the_only_door_to_cad() -> None:
    culprits = {
        relative(path)
        for path in SOURCES
        if "gearstudio/kernel/" not in relative(path)
        and any(name.split(".")[0] in KERNEL for name in imported_modules(path))
    }
    assert not culprits


def test_core_imports_no_window() -> None:
    windowed = RENDERER | TOOLKIT | {"ui"}
    culprits = {
        relative(path)
        for path in SOURCES
        if relative(path).startswith("gearstudio/")
        and any(name.split(".")[0] in windowed for name in imported_modules(path))
    }
    assert not culprits


def test_theory_imports_only_numpy_design_and_errors() -> None:
    """Scipy's root finding and splines too, but from within the functions that use them."""
    ours = ("gearstudio.theory", "gearstudio.design", "gearstudio.errors", "gearstudio.nurbs", "scipy")
    for path in ROOT.glob("gearstudio/theory/**/*.py"):
        for name in imported_modules(path):
            top = name.split(".")[0]
            assert top == "numpy" or top in sys.stdlib_module_names or name.startswith(ours), (
                f"{relative(path)}: {name}"
            )


@pytest.mark.parametrize("name", WIDGETLESS)
def test_logic_of_the_window_uses_no_widget(name: str) -> None:
    widgets = [module for module in imported_modules(ROOT / name) if "QtWidgets" in module.split(".")]
    assert not widgets


def test_files_are_small() -> None:
    lengths = {relative(path): len(path.read_text(encoding="utf-8").splitlines()) for path in SOURCES}
    assert {name: count for name, count in lengths.items() if count > 400} == {}
    assert statistics.median(count for count in lengths.values() if count) <= 170


def is_stub(function: ast.FunctionDef) -> bool:
    """Whether it only declares, as in a protocol, whose docstring speaks for its members."""
    last = function.body[-1]
    return isinstance(last, ast.Expr) and isinstance(last.value, ast.Constant) and last.value.value is ...


def undocumented(tree: ast.Module) -> Iterator[str]:
    """Public names without a docstring; a method may leave it to the one of that name that it overrides."""
    if tree.body and not ast.get_docstring(tree):
        yield "the module"
    definitions = [node for node in tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef)]
    methods = [
        (node, member)
        for node in definitions
        if isinstance(node, ast.ClassDef)
        for member in node.body
        if isinstance(member, ast.FunctionDef) and not is_stub(member)
    ]
    documented = {member.name for _, member in methods if ast.get_docstring(member)}
    yield from (node.name for node in definitions if node.name[0] != "_" and not ast.get_docstring(node))
    for owner, member in methods:
        overrides = bool(owner.bases) and member.name in documented
        if not (owner.name[0] == "_" or member.name[0] == "_" or ast.get_docstring(member) or overrides):
            yield f"{owner.name}.{member.name}"


def test_public_names_of_the_core_are_documented() -> None:
    silent = [
        f"{relative(path)}: {name}"
        for path in SOURCES
        if relative(path).startswith("gearstudio/")
        for name in undocumented(ast.parse(path.read_text(encoding="utf-8")))
    ]
    assert not silent


def tracked_texts() -> Iterator[tuple[str, str]]:
    """Name and text of every text file under version control; of every source where there is no git."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False)
    names = listed.stdout.split("\0") if listed.returncode == 0 else [relative(path) for path in SOURCES]
    for name in filter(None, names):
        path = ROOT / name
        if path.is_file():
            data = path.read_bytes()
            if b"\0" not in data:
                yield name, data.decode("utf-8")


def test_texts_name_no_machine_and_no_registry() -> None:
    words = ["/ro" + "ot/", "/wo" + "rk/", "/ho" + "me/", "py" + "pi.org", "python" + "hosted", "deb." + "debian.org"]
    words += ["registry." + "npmjs", "--index" + "-url", "--find" + "-links"]
    found = [(name, word) for name, text in tracked_texts() for word in words if word in text]
    assert not found


def test_requirements_are_pinned() -> None:
    for path in ROOT.glob("requirements*.txt"):
        lines = path.read_text(encoding="utf-8").splitlines()
        loose = [line for line in lines if line and not line.startswith(("#", "-r ")) and "==" not in line]
        assert not loose, path.name


def test_project_and_pins_agree() -> None:
    """What the packaged project asks for is what the pinned environment has."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    wanted = [*project["project"]["dependencies"], *project["dependency-groups"]["dev"]]
    pinned = {}
    for name in ("requirements.txt", "requirements-dev.txt"):
        for line in (ROOT / name).read_text(encoding="utf-8").splitlines():
            if "==" in line:
                pin = Requirement(line)
                pinned[canonicalize_name(pin.name)] = next(iter(pin.specifier)).version
    for text in wanted:
        requirement = Requirement(text)
        version = pinned.get(canonicalize_name(requirement.name))
        assert version is not None, f"{requirement.name} is not pinned"
        assert requirement.specifier.contains(version), f"{text}, but {version} is pinned"


def test_every_import_is_asked_for() -> None:
    """What the program imports is named in the project, not merely pulled in by something else."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    asked = {canonicalize_name(Requirement(text).name) for text in project["dependencies"]}
    providers = packages_distributions()
    tops = {name.split(".")[0] for path in SOURCES for name in imported_modules(path)}
    foreign = tops - sys.stdlib_module_names - {"main", "ui", "gearstudio"}
    assert {top for top in foreign if not asked & {canonicalize_name(d) for d in providers.get(top, [])}} == set()


def test_every_pinned_package_is_installed_as_pinned() -> None:
    """The tests run on what the pins say, not on what happens to be there."""
    for line in (ROOT / "requirements.txt").read_text(encoding="utf-8").splitlines():
        if "==" in line:
            requirement = Requirement(line)
            if requirement.marker is None or requirement.marker.evaluate():
                assert requirement.specifier.contains(version(requirement.name)), line


def test_architecture_page_names_every_package() -> None:
    page = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    packages = [path.parent for path in ROOT.glob("gearstudio/**/__init__.py")]
    missing = [relative(p) for p in packages if p.name not in page]
    assert not missing


def test_painters_end_whatever_happens() -> None:
    """An error in a paint event must not leave the painter active: the next repaint would bring the program down."""
    for path in ROOT.glob("ui/**/*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for event in (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)):
            managed = {id(item.context_expr) for w in ast.walk(event) if isinstance(w, ast.With) for item in w.items}
            for call in (node for node in ast.walk(event) if isinstance(node, ast.Call)):
                on_itself = [ast.unparse(argument) for argument in call.args] == ["self"]
                if ast.unparse(call.func) == "QPainter" and on_itself:
                    assert id(call) in managed, f"{path.relative_to(ROOT)}:{call.lineno}: with QPainter(self) as …"
