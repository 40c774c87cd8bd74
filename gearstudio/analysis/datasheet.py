"""The geometry data sheet of a pair; every value explains itself."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from gearstudio.analysis.datasheet_hypoid import standard_rows
from gearstudio.analysis.datasheet_rows import Row, Subject, cone_rows, pair_rows
from gearstudio.analysis.datasheet_teeth import size_rows, tooth_rows
from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design
from gearstudio.theory.cones import pair_geometry

Owner = Literal["pair", "pinion", "wheel"]
SheetFormat = Literal["text", "csv", "latex"]

_DECIMALS = {"mm": 4, "°": 5, "": 4}
_ESCAPES = str.maketrans({"&": r"\&", "%": r"\%", "#": r"\#", "_": r"\_", "°": r"$^\circ$"})
_GREEK = {
    "α": r"\alpha", "β": r"\beta", "γ": r"\gamma", "δ": r"\delta", "ε": r"\varepsilon", "θ": r"\theta",
    "Σ": r"\Sigma", "ζ": r"\zeta",
}  # fmt: skip


@dataclass(frozen=True)
class Quantity:
    """A value of the data sheet that explains itself.

    Attributes
    ----------
    key, group, name, symbol : str
    owner : {"pair", "pinion", "wheel"}
    value : float
        In `unit`: mm, ° or none.
    formula, equation : str
        The formula as a person reads it, and the section of the theory (and the paper's equation in brackets).
    inputs : tuple of (symbol, value, unit)
        The numbers put in.
    """

    key: str
    group: str
    name: str
    symbol: str
    unit: str
    owner: Owner
    value: float
    formula: str
    equation: str
    inputs: tuple[tuple[str, float, str], ...]

    @property
    def text(self) -> str:
        """The value without its unit, as the sheet shows it."""
        return number(self.value, self.unit)

    @property
    def explanation(self) -> str:
        """Formula, numbers put in and result, in one line."""
        given = ", ".join(f"{symbol} = {number(value, unit)}{_spaced(unit)}" for symbol, value, unit in self.inputs)
        where = f" with {given}" if given else ""
        return f"{self.formula}{where}: {self.symbol} = {self.text}{_spaced(self.unit)} (theory {self.equation})"


@dataclass(frozen=True)
class DataSheet:
    """All quantities of a pair, in the order of the sheet."""

    quantities: tuple[Quantity, ...]

    def get(self, key: str, owner: Owner = "pair") -> Quantity:
        """The quantity of a key; what the pair shares is found under either member too."""
        return next(q for q in self.quantities if q.key == key and q.owner in (owner, "pair"))

    def lines(self) -> tuple[tuple[Quantity, ...], ...]:
        """One tuple for each line of the sheet: of the pair, or of pinion and wheel."""
        grouped: dict[str, list[Quantity]] = {}
        for quantity in self.quantities:
            grouped.setdefault(quantity.key, []).append(quantity)
        return tuple(tuple(group) for group in grouped.values())


def data_sheet(design: Design) -> DataSheet:
    """The geometry data sheet of both members of a design without errors.

    Raises
    ------
    GeometryError
        There is no tooth: as `theory.profile.tooth_profile`, and tips beyond the involute.
    """
    pair = pair_geometry(design)
    subjects = {name: Subject(design, pair, pair.member(name)) for name in MEMBERS}
    rows = (*pair_rows(), *cone_rows(), *size_rows(), *tooth_rows())
    if pair.hypoid is not None:
        rows = standard_rows(pair.hypoid)
    by_key = {row.key: row for row in rows}
    quantities: list[Quantity] = []
    for row in rows:
        owners: tuple[Owner, ...] = ("pair",) if row.of_pair else MEMBERS
        for owner in owners:
            subject = subjects["wheel" if owner == "pair" else owner]
            quantities.append(_quantity(row, owner, subject, by_key))
    return DataSheet(tuple(quantities))


def sheet_text(sheet: DataSheet, format_: SheetFormat) -> str:
    """The sheet to copy: aligned text, CSV (every digit, formula and numbers put in), or a LaTeX table."""
    return {"text": _plain, "csv": _csv, "latex": _latex}[format_](sheet)


def number(value: float, unit: str) -> str:
    """A value with the digits that the sheet shows; whole numbers of teeth without any."""
    if not unit and value == int(value):
        return str(int(value))
    return f"{value:.{_DECIMALS[unit]}f}"


def _quantity(row: Row, owner: Owner, subject: Subject, rows: Mapping[str, Row]) -> Quantity:
    inputs = []
    for name in row.inputs:
        key, of_mate = name.removeprefix("mate:"), name.startswith("mate:")
        source = rows[key]
        members = [("", subject.opposite if of_mate else subject)]
        if row.of_pair and not source.of_pair:
            members = [("1", subject.opposite), ("2", subject)]
        inputs += [
            (f"{source.symbol}{index}{' of the mate' * of_mate}", _shown(source, one), source.unit)
            for index, one in members
        ]
    return Quantity(
        row.key, row.group, row.name, row.symbol, row.unit, owner, _shown(row, subject), row.formula, row.equation,
        tuple(inputs),
    )  # fmt: skip


def _shown(row: Row, subject: Subject) -> float:
    value = float(row.value(subject))
    return float(np.degrees(value)) if row.unit == "°" else value


def _spaced(unit: str) -> str:
    return {"": "", "°": "°"}.get(unit, f" {unit}")


def _plain(sheet: DataSheet) -> str:
    width = max(len(q.name) for q in sheet.quantities) + 2
    out, group = [], ""
    for line in sheet.lines():
        first = line[0]
        if first.group != group:
            group = first.group
            heads = "" if first.owner == "pair" else f"{'pinion':>14}{'wheel':>14}"
            out += ["", f"{group:<{width + 10}}{heads}".rstrip()]
        values = "".join(f"{q.text:>14}" for q in line)
        out.append(f"{first.name:<{width}}{first.symbol:<10}{values} {first.unit}".rstrip())
    return "\n".join(out[1:]) + "\n"


def _csv(sheet: DataSheet) -> str:
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["group", "name", "symbol", "member", "value", "unit", "formula", "theory", "inputs"])
    for q in sheet.quantities:
        inputs = "; ".join(f"{symbol} = {value:.17g}{_spaced(unit)}" for symbol, value, unit in q.inputs)
        writer.writerow([q.group, q.name, q.symbol, q.owner, f"{q.value:.17g}", q.unit, q.formula, q.equation, inputs])
    return file.getvalue()


def _latex(sheet: DataSheet) -> str:
    out = [r"\begin{tabular}{llrrl}", r"\hline", r"Quantity & Symbol & Pinion & Wheel & Unit \\"]
    group = ""
    for line in sheet.lines():
        first = line[0]
        if first.group != group:
            group = first.group
            out += [r"\hline", rf"\multicolumn{{5}}{{l}}{{\textbf{{{group}}}}} \\"]
        values = " & ".join(q.text for q in line)
        cells = values if len(line) == 2 else rf"\multicolumn{{2}}{{c}}{{{values}}}"
        name = first.name.translate(_ESCAPES)
        out.append(rf"{name} & ${_tex_symbol(first.symbol)}$ & {cells} & {first.unit.translate(_ESCAPES)} \\")
    return "\n".join([*out, r"\hline", r"\end{tabular}"]) + "\n"


def _tex_symbol(symbol: str) -> str:
    head, _, index = symbol.partition("_")
    parts = ["".join(_GREEK.get(letter, letter) for letter in part) for part in (head, index)]
    name = parts[0] if len(head) == 1 else rf"\mathrm{{{parts[0]}}}"
    return f"{name}_{{{parts[1]}}}" if index else name
