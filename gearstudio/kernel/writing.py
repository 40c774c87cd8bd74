"""Solids as files for other CAD programs: writers by format."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from OCP.BinTools import BinTools
from OCP.BRepTools import BRepTools
from OCP.IGESCAFControl import IGESCAFControl_Writer
from OCP.IGESControl import IGESControl_Controller
from OCP.Interface import Interface_Static

from gearstudio.formats import ExportOptions
from gearstudio.kernel.cutting import compound
from gearstudio.kernel.document import Part, located, make_document
from gearstudio.kernel.step import not_written, save_step, settle

_UNITS = {"mm": "MM", "inch": "INCH"}
_IGES_BODIES = {"surfaces": 0, "solid": 1}


def write_solids(path: Path, name: str, made: Sequence[Part], format_: str, options: ExportOptions) -> None:
    """Write parts.

    Parameters
    ----------
    path : Path
        Written in place.
    name : str
        Of the product as a whole.
    made : sequence of Part
        One, or several that make an assembly.
    format_ : {"step", "iges", "brep"}
    options : ExportOptions

    Raises
    ------
    FileError
        The kernel could not write the file.
    """
    settle()
    if not _WRITERS[format_](path, name, made, options):
        raise not_written(path, format_)


def _write_step(path: Path, name: str, made: Sequence[Part], options: ExportOptions) -> bool:
    return save_step(path, make_document(name, made, options.names), options, options.names)


def _write_iges(path: Path, name: str, made: Sequence[Part], options: ExportOptions) -> bool:
    IGESControl_Controller.Init_s()
    Interface_Static.SetIVal_s("write.iges.brep.mode", _IGES_BODIES[options.iges_bodies])
    Interface_Static.SetCVal_s("write.iges.unit", _UNITS[options.iges_unit])
    writer = IGESCAFControl_Writer()
    writer.SetNameMode(options.names)
    writer.SetColorMode(options.colors)
    writer.Transfer(make_document(name, made, options.names))
    return bool(writer.Write(str(path)))


def _write_brep(path: Path, name: str, made: Sequence[Part], options: ExportOptions) -> bool:
    shapes = [located(part) for part in made]
    whole = shapes[0] if len(shapes) == 1 else compound(shapes)
    write = BinTools.Write_s if options.brep_encoding == "binary" else BRepTools.Write_s
    return bool(write(whole, str(path)))


_WRITERS: dict[str, Callable[[Path, str, Sequence[Part], ExportOptions], bool]] = {
    "step": _write_step,
    "iges": _write_iges,
    "brep": _write_brep,
}
