"""What one field of a design is: its limits and its words, stated once for file, messages and form."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field
from pydantic.fields import FieldInfo

Kind = Literal["int", "float", "choice", "text"]
_KINDS: dict[Any, Kind] = {int: "int", float: "float", str: "text"}
_LIMITS = ("gt", "ge", "le", "min_length", "max_length")


class Part(BaseModel):
    """A table of the design file: frozen, and strict about types."""

    model_config = ConfigDict(frozen=True, strict=True, extra="forbid", allow_inf_nan=False, validate_default=True)


@dataclass(frozen=True)
class Words:
    """The part of a field that is for people; everything else follows from the model.

    Attributes
    ----------
    title : str
        Short label.
    description : str
        What it is, in a sentence.
    unit : str
        ``"mm"``, ``"°"``, ``"µm"``, a counted noun (``"teeth"``), or empty for a ratio or a word.
    symbol, equation : str
        As theory.md writes them; empty where there is none.
    step : float
        What one step of a spin button changes.
    decimals : int
        Useful digits after the point.
    used_when : tuple of str, or None
        (path, value) of another field, without which this one has no effect.
    """

    title: str
    description: str
    unit: str = ""
    symbol: str = ""
    equation: str = ""
    step: float = 1.0
    decimals: int = 0
    used_when: tuple[str, str] | None = None


@dataclass(frozen=True)
class FieldSpec:
    """One field of the design, as file, messages and form need it.

    Attributes
    ----------
    path : str
        Dotted key of the design file (``"pair.pinion_teeth"``).
    kind : {"int", "float", "choice", "text"}
    default : object
        Value of a new design; None for an optional field that is derived.
    minimum, maximum : float or None
        Inclusive limits; for a text the least and greatest number of characters.
    above_minimum : bool
        The minimum itself is not allowed.
    choices : tuple of str
    optional : bool
        May be left out (None); the value is then derived.
    group : str
        Heading in the form.
    title, description, unit, symbol, equation, step, decimals, used_when
        As in `Words`.
    """

    path: str
    kind: Kind
    default: Any
    minimum: float | None
    maximum: float | None
    above_minimum: bool
    choices: tuple[str, ...]
    optional: bool
    group: str
    title: str
    description: str
    unit: str
    symbol: str
    equation: str
    step: float
    decimals: int
    used_when: tuple[str, str] | None

    @property
    def range_text(self) -> str:
        """What may be used instead, in words: ``"5 to 200"``, ``"more than 0, up to 0.5"``, ``"a, b or c"``."""
        if self.kind == "choice":
            quoted = [f'"{choice}"' for choice in self.choices]
            return " or ".join([", ".join(quoted[:-1]), quoted[-1]]) if len(quoted) > 1 else quoted[0]
        if self.kind == "text":
            return f"one line of up to {self.maximum:g} characters"
        if self.above_minimum:
            return f"more than {self.minimum:g}, up to {self.maximum:g}"
        return f"{self.minimum:g} to {self.maximum:g}"


def number(
    default: float | None,
    minimum: float,
    maximum: float,
    words: Words,
    *,
    above_minimum: bool = False,
) -> Any:
    """A pydantic field for a number within limits; whole or not is said by its annotation."""
    limits: dict[str, Any] = {"gt" if above_minimum else "ge": minimum, "le": maximum}
    return _field(default, words, limits)


def word(default: str, words: Words) -> Any:
    """A pydantic field for one of a few words, listed by its annotation (a Literal)."""
    return _field(default, words, {})


def text(default: str, longest: int, words: Words) -> Any:
    """A pydantic field for a line of text."""
    return _field(default, words, {"max_length": longest})


def _field(default: Any, words: Words, limits: dict[str, Any]) -> Any:
    extra: dict[str, Any] = {"words": words}
    return Field(default, json_schema_extra=extra, **limits)


def specify(path: str, group: str, info: FieldInfo) -> FieldSpec:
    """The specification of one model field made by `number`, `word` or `text`."""
    extra = info.json_schema_extra
    words: object = extra["words"] if isinstance(extra, dict) else None
    if not isinstance(words, Words):
        raise TypeError(f"{path} has no words")
    limits = {name: getattr(rule, name) for rule in info.metadata for name in _LIMITS if hasattr(rule, name)}
    optional = type(None) in get_args(info.annotation)
    bare = next(a for a in get_args(info.annotation) if a is not type(None)) if optional else info.annotation
    choices = tuple(str(choice) for choice in get_args(bare))
    kind: Kind = "choice" if choices else _KINDS[bare]
    return FieldSpec(
        path=path,
        kind=kind,
        default=info.default,
        minimum=limits.get("gt", limits.get("ge", limits.get("min_length"))),
        maximum=limits.get("le", limits.get("max_length")),
        above_minimum="gt" in limits,
        choices=choices,
        optional=optional,
        group=group,
        **vars(words),
    )
