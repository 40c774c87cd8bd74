"""The figures of a report and the pictures that were taken for it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gearstudio.report.blocks import Picture

_JPEG = b"\xff\xd8"


@dataclass(frozen=True)
class Taken:
    """Pictures of the program's views, PNG or JPEG by name, and why others are missing."""

    pictures: Mapping[str, bytes] = field(default_factory=dict)
    problems: tuple[str, ...] = ()


@dataclass
class Store:
    """The figures' files as they are made, and the pictures that were handed in."""

    taken: Taken = field(default_factory=Taken)
    files: dict[str, bytes] = field(default_factory=dict)

    def add(self, name: str, content: bytes, caption: str, width: float = 1.0) -> Picture:
        """Keep a file and return the block that shows it."""
        self.files[name] = content
        return Picture(name, caption, width)

    def picture(self, name: str, caption: str, width: float = 1.0) -> Picture | None:
        """The block of a picture that was handed in; None when it was not."""
        data = self.taken.pictures.get(name)
        if data is None:
            return None
        kind = "jpg" if data.startswith(_JPEG) else "png"
        return self.add(f"{name}.{kind}", data, caption, width)
