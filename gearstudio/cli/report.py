"""``report``: the design, its data sheets, the comparison, maps, contact and equations as a PDF."""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from gearstudio.catalogue import MEMBERS, MemberName
from gearstudio.cli.output import Progress
from gearstudio.files import write_bytes
from gearstudio.project import open_design
from gearstudio.report.sections import SECTION_KEYS

_PICTURES = {
    "views": ("--size", "1500x620"),
    "pair": ("--mode", "pair", "--size", "1300x760"),
}
_PATIENCE_S = 300


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("--out", required=True, metavar="FILE", help="a .pdf file")
    parser.add_argument("--member", choices=MEMBERS, default="wheel", help="whose maps are drawn; default: wheel")
    parser.add_argument(
        "--sections", type=sections, default=SECTION_KEYS, metavar="A,B,…",
        help=f"some of {', '.join(SECTION_KEYS)}; default: all",
    )  # fmt: skip


def run(args: argparse.Namespace) -> int:
    """Carry the command out."""
    design = open_design(args.design)
    from gearstudio.report.document import compose, typeset

    progress = Progress()
    try:
        with _pictures(args.design, args.member, "pictures" in args.sections) as pictures:
            pages = compose(design, args.sections, args.member, pictures, progress)
        progress("setting the pages", 0.9)
        write_bytes(Path(args.out), typeset(pages)[0])
    finally:
        progress.clear()
    print(args.out)
    return 0


def sections(text: str) -> tuple[str, ...]:
    """Keys of sections, separated by commas.

    Raises
    ------
    argparse.ArgumentTypeError
        There is no such section.
    """
    keys = tuple(part.strip() for part in text.split(","))
    for key in keys:
        if key not in SECTION_KEYS:
            raise argparse.ArgumentTypeError(f"{key[:20]!r} is no section; use some of {', '.join(SECTION_KEYS)}")
    return keys


class _Awaited(Mapping[str, bytes]):
    """Pictures that other processes take meanwhile; those that could not be taken are not there."""

    def __init__(self, taken: dict[str, tuple[Path, subprocess.Popen[bytes]]]) -> None:
        self._taken = taken

    def __getitem__(self, name: str) -> bytes:
        path, process = self._taken[name]
        if process.wait(_PATIENCE_S) != 0:
            raise KeyError(name)
        return path.read_bytes()

    def __iter__(self) -> Iterator[str]:
        return (name for name, (_, process) in self._taken.items() if process.wait(_PATIENCE_S) == 0)

    def __len__(self) -> int:
        return sum(1 for _ in self)


@contextmanager
def _pictures(design: str, member: MemberName, wanted: bool) -> Iterator[Mapping[str, bytes]]:
    """Have the program's own ``screenshot`` take the pictures, beside the other work."""
    with tempfile.TemporaryDirectory(prefix="gearstudio-pictures-") as folder:
        taken = {}
        for name, options in _PICTURES.items() if wanted else ():
            path = Path(folder) / f"{name}.png"
            words = [*_this_program(), "screenshot", design, "--out", str(path), "--member", member, *options]
            process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            taken[name] = (path, process)
        try:
            yield _Awaited(taken)
        finally:
            for _, process in taken.values():
                process.kill()
                process.wait()


def _this_program() -> list[str]:
    if getattr(sys, "frozen", False):
        return [sys.executable]
    return [sys.executable, str(Path(__file__).parents[2] / "main.py")]
