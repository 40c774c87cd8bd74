"""Numbers as they are typed on a command line: with a point, or with a comma where it can mean nothing else."""

from __future__ import annotations

import argparse
import re

_MINUS = "\N{MINUS SIGN}"
_WITH_COMMA = re.compile(r"[+-]?\d*,\d+([eE][+-]?\d+)?|[+-]?\d+,", re.ASCII)
_MAYBE_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}", re.ASCII)
_DECIMALS = re.compile(r"0\d+")
_LONGEST = 40


def number(text: str) -> float:
    """A number; NaN for what is none.

    Raises
    ------
    argparse.ArgumentTypeError
        Its comma may stand before decimals or after thousands.
    """
    plain = text.strip().replace(_MINUS, "-")
    if _MAYBE_THOUSANDS.fullmatch(plain):
        small, large = plain.replace(",", "."), plain.replace(",", "")
        raise argparse.ArgumentTypeError(f"{echoed(text)} may be {small} or {large}; write one of them")
    if _WITH_COMMA.fullmatch(plain):
        plain = plain.replace(",", ".")
    try:
        return float(plain)
    except ValueError:
        return float("nan")


def numbers(text: str, count: int) -> list[float]:
    """Some numbers parted by commas, or by semicolons or blanks and then with decimal commas too; NaN for what is none.

    Raises
    ------
    argparse.ArgumentTypeError
        Some of the commas that should part numbers seem to stand before decimals.
    """
    for parts in (text.split(";"), text.split()):
        if len(parts) == count and not any(part.rstrip().endswith(",") for part in parts):
            return [number(part) for part in parts]
    parts = text.split(",")
    if ";" not in text and (count < len(parts) <= 2 * count or any(map(_DECIMALS.fullmatch, parts))):
        example = ";".join(["0,05"] + ["0"] * (count - 1))
        raise argparse.ArgumentTypeError(
            f"the commas of {echoed(text)} part {count} numbers; write decimals with a point, as 0.05, or part the "
            f'numbers by semicolons between quotation marks, as "{example}"'
        )
    return [number(part) for part in parts]


def echoed(text: str, most: int = _LONGEST) -> str:
    """What was typed, fit for a message."""
    return text if len(text) <= most else f"{text[: most - 1]}…"
