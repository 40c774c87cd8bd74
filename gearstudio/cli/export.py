"""``export``: flanks, a tooth, a gear or the pair as a method makes them, for other programs."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from pathlib import Path

from gearstudio.cli.findings import findings
from gearstudio.cli.numbers import echoed, number
from gearstudio.cli.output import Progress
from gearstudio.errors import DesignError, Issue
from gearstudio.formats import FORMATS, OPTIONS, ExportOptions, OptionSpec, options_of
from gearstudio.jobs import CONSTRUCTIONS
from gearstudio.project import open_design

PARTS = tuple(FORMATS)
PAIR = "pair"
__all__ = ["CONSTRUCTIONS", "PAIR", "PARTS", "add_options", "chosen_options", "run"]


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status."""
    from gearstudio.jobs import ExportJob

    formats = tuple(dict.fromkeys(args.format))
    _refuse_what_does_not_go_together(args, formats)
    design = open_design(args.design)
    job = ExportJob(
        design,
        args.member,
        args.part,
        args.method,
        args.variant,
        formats,
        Path(args.out),
        args.construction,
        chosen_options(args),
        args.record,
    )
    progress = Progress()
    try:
        files = job.run(progress)
    finally:
        progress.clear()
    for file in files:
        print(file.path)
        if args.details:
            print(findings(file.check))
    return 0


def add_options(parser: argparse.ArgumentParser) -> None:
    """Every option of the formats, from their table."""
    group = parser.add_argument_group("how files are written")
    for spec in OPTIONS.values():
        text = f"{', '.join(spec.formats)}: {spec.help[:1].lower()}{spec.help[1:]}"
        if spec.kind == "choice":
            values = [value for value, _ in spec.choices]
            group.add_argument(
                spec.flag, dest=spec.name, choices=values, default=None, help=f"{text}; default: {spec.default}"
            )
        elif spec.kind == "switch":
            group.add_argument(
                spec.flag, dest=spec.name, action="store_const", const=False, default=None, help=f"leave out: {text}"
            )
        else:
            kind = {"mm": "MM", "°": "DEG"}[spec.unit]
            group.add_argument(spec.flag, dest=spec.name, type=_number(spec), metavar=kind, default=None, help=text)


def chosen_options(args: argparse.Namespace) -> ExportOptions:
    """The options that were given, the others as usual."""
    given = {name: getattr(args, name) for name in OPTIONS if getattr(args, name) is not None}
    return ExportOptions(**given)


class _number:  # noqa: N801 - argparse shows the name of a type when it raises ValueError; this one never does
    """Reads a number within an option's limits."""

    def __init__(self, spec: OptionSpec) -> None:
        self._spec = spec

    def __call__(self, text: str) -> float:
        low, high = self._spec.limits
        value = number(text)
        if not self._spec.allows(value):
            unit = "degrees" if self._spec.unit == "°" else self._spec.unit
            what = "a length" if unit == "mm" else "an angle"
            raise argparse.ArgumentTypeError(f"{echoed(text, 20)} is not {what} in {unit}; use {low:g} to {high:g}")
        return value


def _refuse_what_does_not_go_together(args: argparse.Namespace, formats: Iterable[str]) -> None:
    offered = FORMATS[args.part]
    issues = [
        Issue("not_offered", "--format", f"{args.part} cannot be written as {name}; use {' or '.join(offered)}")
        for name in formats
        if name not in offered
    ]
    if args.member == PAIR and args.part != "gear":
        issues.append(Issue("not_offered", "--part", f"{args.part} is of one member; a pair is written as gear"))
    fitting = options_of(formats)
    for name, spec in OPTIONS.items():
        if getattr(args, name) is not None and spec not in fitting:
            text = f"of {', '.join(spec.formats)} alone, and none of them is written; leave it out"
            issues.append(Issue("not_offered", spec.flag, text))
    if issues:
        raise DesignError(issues)
