"""What was found in an exported file when it was read back, as plain records that travel between processes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

from gearstudio.errors import FileError

VOLUME_ERROR = 1e-4
"""Largest relative difference of the volume that is taken as the same solid."""
Box = tuple[tuple[float, float, float], tuple[float, float, float]]


@dataclass(frozen=True)
class FaceCheck:
    """One face of a file against theory.

    Attributes
    ----------
    member, name : str
        ``"wheel"``; ``"concave"``, ``"convex fillet"``, ``"root"``, ``"tip"``, ``"end"``, ``"body"``, …
    tooth : int
        From 1 at azimuth 0; 0 where a face belongs to none.
    largest_um, limit_um : float
        Largest distance from theory, of whichever sign [µm]; the most there can be if the file is what it should be.
    """

    member: str
    name: str
    tooth: int
    largest_um: float
    limit_um: float

    @property
    def good(self) -> bool:
        """Whether the face is where it should be."""
        return self.largest_um <= self.limit_um

    @property
    def title(self) -> str:
        """Face and tooth in words."""
        return f"{self.name}, tooth {self.tooth}" if self.tooth else self.name


@dataclass(frozen=True)
class FileCheck:
    """What was found in a file of solids or triangles.

    Attributes
    ----------
    format : str
    valid, closed : bool
        By the kernel's full check; for triangles, by counting their edges. Flanks alone are never closed.
    solids, faces : int
        Faces, or triangles.
    volume : float
        [mm^3]
    volume_error : float
        Relative to what belongs in the file.
    box_error : float
        Largest difference of the bounding boxes [mm].
    wanted_solids : int
        0 where there are faces alone, without volume.
    box : two corners
        Least and greatest coordinates [mm].
    deviations : tuple of FaceCheck
    chord_um, chord_limit_um : float or None
        Of triangles: farthest that their middles lie from theory [µm].
    kernel : str
        Name and version of what read the file.
    remarks : tuple of str
        What is in the file by intention and not as the design asks for.
    """

    format: str
    valid: bool
    closed: bool
    solids: int
    faces: int
    volume: float
    volume_error: float
    box_error: float
    wanted_solids: int = 1
    box: Box = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    deviations: tuple[FaceCheck, ...] = ()
    chord_um: float | None = None
    chord_limit_um: float | None = None
    kernel: str = ""
    remarks: tuple[str, ...] = ()

    @property
    def worst(self) -> tuple[FaceCheck, ...]:
        """Of each kind of face of each member the one farthest from theory; one out of limits comes first."""
        found: dict[tuple[str, str], FaceCheck] = {}
        for face in self.deviations:
            key = face.member, face.name
            if key not in found or (face.good, -face.largest_um) < (found[key].good, -found[key].largest_um):
                found[key] = face
        return tuple(found[key] for key in sorted(found, key=_place))

    def problems(self) -> tuple[str, ...]:
        """Everything that is wrong with the file; empty when it is what it should be."""
        return tuple(self._problems())

    def require(self, path: object) -> None:
        """Raise FileError with the first problem."""
        for problem in self._problems():
            raise FileError(path, f"{problem} after reading the file back")

    def record(self) -> dict[str, Any]:
        """As a table of plain values."""
        return {**asdict(self), "problems": list(self._problems())}

    def _problems(self) -> Iterator[str]:
        if self.solids != self.wanted_solids:
            yield f"{self.solids} solids instead of {self.wanted_solids} were found"
        if not self.valid:
            yield "the solid is not valid" if self.wanted_solids else "a face is missing or not valid"
        elif not self.closed and self.wanted_solids:
            yield "the solid is not closed"
        if not self.volume_error <= VOLUME_ERROR:
            yield f"the volume differs by {self.volume_error:.2g}"
        for face in self.worst:
            if not face.good:
                lies = f"lies {face.largest_um:.4g} µm from theory instead of at most {face.limit_um:.3g} µm"
                yield f"the {face.member}'s {face.title} {lies}"
        if self.chord_um is not None and self.chord_limit_um is not None and not self.chord_um <= self.chord_limit_um:
            allowed = f"instead of {self.chord_limit_um:.4g} µm at most"
            yield f"triangles lie {self.chord_um:.4g} µm from the surfaces {allowed}"

    def __str__(self) -> str:
        if not self.wanted_solids:
            return f"{self.faces} {'valid ' if self.valid else ''}faces"
        closed = "closed valid " if self.valid and self.closed else ""
        return (
            f"{self.solids} {closed}solid{'s' if self.solids != 1 else ''}, {self.faces} faces, "
            f"{self.volume:.6g} mm³ (relative difference {self.volume_error:.1e})"
        )


_ORDER = ("concave", "convex", "fillet", "meridian", "root", "tip", "end", "body")


def _place(key: tuple[str, str]) -> tuple[str, int, str]:
    member, name = key
    word = name.rpartition(" ")[2]
    return member, _ORDER.index(word) if word in _ORDER else len(_ORDER), name
