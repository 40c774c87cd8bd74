"""What is installed is complete: data files in the wheel, the program in a folder of its own, the desktop's files."""

from __future__ import annotations

import ast
import configparser
import os
import runpy
import shutil
import subprocess
import sys
import tarfile
import tomllib
import xml.etree.ElementTree as ET
import zipfile
from importlib import metadata
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest
from packaging.utils import canonicalize_name

import main as door

ROOT = Path(__file__).resolve().parents[1]
PACKAGES = ("gearstudio", "ui")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
SOURCES = {"LICENSE", "MANIFEST.in", "README.md", "pyproject.toml"} | {
    f"packaging/{path.name}" for path in (ROOT / "packaging").iterdir()
}
SAID_BY_TOOLS = {"PKG-INFO", "setup.cfg"}
REQUIREMENTS = (ROOT / "requirements.txt").read_text(encoding="utf-8").splitlines()


def data_files() -> set[str]:
    """All but code and the sources of the translations."""
    found = (path for package in PACKAGES for path in (ROOT / package).rglob("*") if path.is_file())
    return {
        path.relative_to(ROOT).as_posix()
        for path in found
        if path.suffix not in (".py", ".pyc", ".ts")
        and "__pycache__" not in path.parts
        and not path.name.startswith(".")
    }


def help_pages() -> set[str]:
    """The pages of the help in all languages, and their pictures, by the link in the package."""
    found = (path for path in (ROOT / "docs").rglob("*") if path.suffix in (".md", ".png"))
    return {f"ui/help/pages/{path.relative_to(ROOT / 'docs').as_posix()}" for path in found}


def test_the_help_has_its_pages_in_every_language() -> None:
    pages = help_pages()
    assert {f"ui/help/pages/{folder}guide.md" for folder in ("", "de/", "zh/")} <= pages
    assert all((ROOT / page).is_file() for page in pages)


def test_the_wheel_takes_every_kind_of_data_file() -> None:
    patterns = PROJECT["tool"]["setuptools"]["package-data"]["*"]
    taken = {
        path.relative_to(ROOT).as_posix() for package in PACKAGES for p in patterns for path in (ROOT / package).glob(p)
    }
    assert data_files() <= taken
    for names in PROJECT["tool"]["setuptools"]["data-files"].values():
        assert all((ROOT / name).is_file() for name in names)


class Recorded(ModuleType):
    """Stands in for the freezer: notes which data files, modules and packages' versions the bundle is to have."""

    def __init__(self) -> None:
        super().__init__("PyInstaller.utils.hooks")
        self.data: set[str] = set()
        self.modules: set[str] = set()
        self.versions: set[str] = set()

    def collect_data_files(self, _package: str, **_options: Any) -> list[tuple[str, str]]:
        return []

    def collect_submodules(self, package: str, **_options: Any) -> list[str]:
        return [package]

    def copy_metadata(self, name: str) -> list[tuple[str, str]]:
        self.versions.add(canonicalize_name(name))
        return []

    def analyse(self, _scripts: list[str], **given: Any) -> SimpleNamespace:
        self.modules |= set(given["hiddenimports"])
        self.data |= {f"{folder}/{Path(file).name}" for file, folder in given["datas"]}
        return SimpleNamespace(pure=[], scripts=[], binaries=[], datas=[])


@pytest.fixture
def bundle(monkeypatch: pytest.MonkeyPatch) -> Recorded:
    """What the recipe of the bundle asks for."""
    recorded = Recorded()
    for name in ("PyInstaller", "PyInstaller.utils"):
        monkeypatch.setitem(sys.modules, name, ModuleType(name))
    monkeypatch.setitem(sys.modules, recorded.__name__, recorded)
    spec = ROOT / "packaging" / "gearstudio.spec"
    others = dict.fromkeys(("PYZ", "EXE", "COLLECT"), lambda *_things, **_options: None)
    runpy.run_path(str(spec), {"SPECPATH": str(spec.parent), "Analysis": recorded.analyse, **others})
    return recorded


def test_the_bundle_takes_every_data_file_and_no_script(bundle: Recorded) -> None:
    assert bundle.data == data_files() | help_pages()
    assert set(PACKAGES) <= bundle.modules


def test_the_bundle_knows_the_versions_that_the_program_tells(bundle: Recorded) -> None:
    pinned = {canonicalize_name(line.split("==")[0]) for line in REQUIREMENTS if "==" in line}
    told = set()
    for path in (path for package in PACKAGES for path in (ROOT / package).rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        if any(isinstance(node, ast.Attribute) and ast.unparse(node) == "metadata.version" for node in ast.walk(tree)):
            words = (node.value for node in ast.walk(tree) if isinstance(node, ast.Constant))
            told |= {canonicalize_name(word) for word in words if isinstance(word, str)} & pinned
    assert told and told <= bundle.versions


@pytest.mark.parametrize("before", [None, "/opt/lib"])
def test_programs_started_by_the_bundle_do_not_load_its_libraries(before: str | None) -> None:
    environment = {"LD_LIBRARY_PATH": "/bundle/_internal", "HOME": "/users/a"}
    if before is not None:
        environment |= {"LD_LIBRARY_PATH": f"/bundle/_internal:{before}", "LD_LIBRARY_PATH_ORIG": before}
    door.give_back_search_path(environment)
    assert environment.get("LD_LIBRARY_PATH") == before and "LD_LIBRARY_PATH_ORIG" not in environment
    assert environment["HOME"] == "/users/a"


def can_build() -> bool:
    try:
        return int(metadata.version("setuptools").split(".")[0]) >= 77 and bool(metadata.version("pip"))
    except metadata.PackageNotFoundError:
        return False


@pytest.mark.slow
@pytest.mark.skipif(not can_build(), reason="needs pip and setuptools 77")
def test_the_wheel_is_complete_and_runs_from_a_folder_of_its_own(tmp_path: Path) -> None:
    def run(*arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, *arguments],
            cwd=tmp_path,
            env=os.environ | variables,
            capture_output=True,
            text=True,
            check=False,
        )

    source = tmp_path / "source"
    for name in ("pyproject.toml", "MANIFEST.in", "README.md", "LICENSE", "main.py"):
        source.mkdir(exist_ok=True)
        (source / name).write_bytes((ROOT / name).read_bytes())
    for name in (*PACKAGES, "packaging", "tests"):
        copy_tree(ROOT / name, source / name)
    options = ("--no-deps", "--no-build-isolation", "--no-index", "--quiet", "--disable-pip-version-check")
    made = run("-m", "pip", "wheel", *options, "--wheel-dir", str(tmp_path), str(source))
    assert made.returncode == 0, made.stderr
    (wheel,) = tmp_path.glob("*.whl")
    names = set(zipfile.ZipFile(wheel).namelist())
    code = {path.relative_to(ROOT).as_posix() for package in PACKAGES for path in (ROOT / package).rglob("*.py")}
    whole = data_files() | help_pages() | code | {"main.py"}
    assert {name for name in names if not name.startswith("gearstudio-")} == whole
    assert any(name.endswith("share/applications/gearstudio.desktop") for name in names)
    assert set(sourced(source, tmp_path)) - SAID_BY_TOOLS == whole | SOURCES
    place = tmp_path / "place"
    assert run("-m", "pip", "install", *options, "--target", str(place), str(wheel)).returncode == 0
    command = str(place / "bin" / "gearstudio")
    done = run(command, "info", "preset:default", PYTHONPATH=str(place))
    assert done.returncode == 0 and "Default spiral bevel pair" in done.stdout, done.stderr
    where = run("-c", "import ui, gearstudio; print(ui.__file__, gearstudio.__file__)", PYTHONPATH=str(place))
    assert where.stdout.count(str(place)) == 2


def sourced(source: Path, place: Path) -> list[str]:
    """What a source distribution has."""
    make = "import sys, setuptools.build_meta as made; print(made.build_sdist(sys.argv[1]))"
    done = subprocess.run(
        [sys.executable, "-c", make, str(place)], cwd=source, capture_output=True, text=True, check=True
    )
    with tarfile.open(place / done.stdout.splitlines()[-1]) as archive:
        files = [entry.name.partition("/")[2] for entry in archive if entry.isfile()]
    return [name for name in files if ".egg-info/" not in name]


def copy_tree(source: Path, target: Path) -> None:
    """A copy in which links, as that to the pages of the help, are files of their own."""
    shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))


def test_the_desktop_entry_and_the_file_type_agree() -> None:
    entry = configparser.RawConfigParser(delimiters=("=",))
    entry.optionxform = str  # type: ignore[method-assign,assignment]
    entry.read(ROOT / "packaging" / "gearstudio.desktop", encoding="utf-8")
    main = entry["Desktop Entry"]
    tree = ET.parse(ROOT / "packaging" / "gearstudio-mime.xml")
    kind = tree.find("{*}mime-type")
    assert kind is not None and main["MimeType"] == kind.get("type") + ";"
    assert kind.find("{*}glob").get("pattern") == "*.gear.toml"  # type: ignore[union-attr]
    assert main["Exec"] == "gearstudio %f" and "gearstudio" in PROJECT["project"]["scripts"]
    assert main["Icon"] == kind.find("{*}icon").get("name") == "gearstudio"  # type: ignore[union-attr]


def test_the_desktop_is_told_where_the_program_is(tmp_path: Path) -> None:
    program = tmp_path / "my programs" / "gearstudio"
    program.parent.mkdir()
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)
    environment = os.environ | {"XDG_DATA_HOME": str(tmp_path / "share")}
    script = str(ROOT / "packaging" / "install-desktop.sh")
    beside = program.relative_to(tmp_path)
    call = ["sh", script, str(beside)]
    subprocess.run(call, cwd=tmp_path, env=environment, check=True, capture_output=True, timeout=30)
    text = (tmp_path / "share" / "applications" / "gearstudio.desktop").read_text(encoding="utf-8")
    assert f'Exec="{program}" %f\n' in text and f"TryExec={program}\n" in text
    assert (tmp_path / "share" / "mime" / "packages" / "gearstudio-mime.xml").is_file()
    assert (tmp_path / "share" / "icons" / "hicolor" / "scalable" / "apps" / "gearstudio.svg").is_file()
    failed = subprocess.run(
        ["sh", script, "no-such-program"], env=environment, check=False, capture_output=True, timeout=30
    )
    assert failed.returncode == 2 and b"not installed" in failed.stderr
