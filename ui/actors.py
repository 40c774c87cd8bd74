"""Draws layers with VTK: one named actor for each, updated in place; the only place that knows both.

What several views share is sent to the renderer once: layers that are the same object in more than one pane use
one mapper, with an actor in each pane.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPlaneCollection, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkActor, vtkMapper, vtkPolyDataMapper, vtkProperty

from gearstudio.theory.place import Place
from ui import colormap
from ui.camera import Camera
from ui.layers import Layer
from ui.section import Plane
from ui.views.appearance import LayerLook
from ui.views.styling import apply_style, chosen_style, rgb
from ui.views.zebra import Stripes, aim_stripes, put_stripes

STRIPED = frozenset({"deviation", "cad_flank"})
_LIFT = 160.0
"""Depth, in millionths of the range drawn, by which one step of lift comes forward."""


def fill_table(table: vtkLookupTable, name: str, steps: int) -> None:
    """Give a table the colours of a map; every coloured surface uses the same one."""
    table.SetNumberOfTableValues(colormap.SIZE)
    for index, (red, green, blue) in enumerate(colormap.table(name, steps) / 255.0):
        table.SetTableValue(index, red, green, blue, 1.0)
    table.SetNanColor(0.5, 0.5, 0.5, 1.0)
    table.Modified()


class MeshBuffer:
    """The arrays of one layer on their way to the renderer."""

    def __init__(self, table: vtkLookupTable) -> None:
        self.mesh = vtkPolyData()
        self.mapper = vtkPolyDataMapper()
        self.mapper.SetInputData(self.mesh)
        self.mapper.SetLookupTable(table)
        self.mapper.UseLookupTableScalarRangeOn()
        self.mapper.InterpolateScalarsBeforeMappingOn()
        self.mapper.SetStatic(False)
        self.layer: Layer | None = None
        self._arrays: dict[str, tuple[np.ndarray, Any]] = {}

    def load(self, layer: Layer) -> None:
        """Take over a layer's arrays, into the memory already there when their shapes agree."""
        before, self.layer = self.layer, layer
        if before is layer:
            return
        arrays = layer.single
        points = self._write("points", arrays["points"])
        if points is not None:
            holder = vtkPoints()
            holder.SetData(points)
            self.mesh.SetPoints(holder)
        self.mesh.GetPoints().Modified()
        for name, attach in (
            ("normals", self.mesh.GetPointData().SetNormals),
            ("scalars", self.mesh.GetPointData().SetScalars),
        ):
            values = arrays.get(name)
            if values is None:
                attach(None)
                self._arrays.pop(name, None)
                continue
            fresh = self._write(name, values)
            if fresh is not None:
                attach(fresh)
        if before is None or before.kind != layer.kind or not _same(before, layer):
            self._set_cells(layer)
        self.mapper.SetScalarVisibility(layer.scalars is not None)
        self._set_lift(layer.style.lift)
        self.mesh.Modified()

    def _write(self, name: str, values: np.ndarray) -> Any | None:
        """Copy values; the new VTK array when one had to be made."""
        held = self._arrays.get(name)
        if held is not None and held[0].shape == values.shape:
            np.copyto(held[0], values)
            held[1].Modified()
            return None
        copy = values.copy()
        array = numpy_to_vtk(copy, deep=False)
        array.SetName(name)
        self._arrays[name] = (copy, array)
        return array

    def _set_cells(self, layer: Layer) -> None:
        cells = np.arange(len(layer.points))[:, None] if layer.kind == "points" else layer.cells
        made = vtkCellArray()
        if len(cells):
            made.SetData(cells.shape[1], numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells).ravel(), deep=True))
        setters = {"surface": self.mesh.SetPolys, "lines": self.mesh.SetLines, "points": self.mesh.SetVerts}
        for kind, setter in setters.items():
            setter(made if kind == layer.kind else vtkCellArray())

    def _set_lift(self, lift: int) -> None:
        self.mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -_LIFT * lift)
        self.mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -_LIFT * lift)
        self.mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-_LIFT * lift)


class ActorStore:
    """All actors of all panes."""

    def __init__(self, renderers: Sequence[Any]) -> None:
        vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
        self.table = vtkLookupTable()
        self.table.SetTableRange(-1.0, 1.0)
        fill_table(self.table, "balance", 0)
        self.dark = False
        self.pixel_ratio = 1.0
        self._renderers = tuple(renderers)
        self._buffers: dict[tuple[str, int], MeshBuffer] = {}
        self._actors: list[dict[str, vtkActor]] = [{} for _ in self._renderers]
        self._panes: tuple[tuple[Layer, ...], ...] = ()
        self._places: dict[str, vtkMatrix4x4] = {}
        self._coarse = False
        self._plane: vtkPlane | None = None
        self._looks: Mapping[str, LayerLook] = {}
        self._stripes: Stripes | None = None

    @property
    def counts(self) -> tuple[int, ...]:
        """How many actors each pane has."""
        return tuple(len(actors) for actors in self._actors)

    def set_layers(self, panes: Sequence[tuple[Layer, ...]]) -> None:
        """Show exactly these layers, a tuple for each pane; panes without one become empty."""
        self._panes = (*map(tuple, panes), *((),) * (len(self._renderers) - len(panes)))
        used: set[tuple[str, int]] = set()
        slots: dict[str, list[Layer]] = {}
        for pane, layers in enumerate(self._panes):
            for layer in layers:
                same_role = slots.setdefault(layer.key, [])
                if not any(layer is other for other in same_role):
                    same_role.append(layer)
                slot = (layer.key, next(i for i, other in enumerate(same_role) if other is layer))
                used.add(slot)
                buffer = self._buffers.setdefault(slot, MeshBuffer(self.table))
                buffer.load(layer)
                self._show(pane, layer, buffer)
            self._drop_actors(pane, {layer.key for layer in layers})
        for slot in self._buffers.keys() - used:
            del self._buffers[slot]

    def set_range(self, low: float, high: float) -> None:
        """Colours run from low to high."""
        self.table.SetTableRange(low, high)

    def set_colors(self, name: str, steps: int) -> None:
        """Colour by a map of `colormap.MAPS`, smooth or in so many steps."""
        fill_table(self.table, name, steps)

    def set_looks(self, looks: Mapping[str, LayerLook]) -> None:
        """Take the user's own colours and opacities of layers."""
        if looks != self._looks:
            self._looks = looks
            self.restyle(self.dark, self.pixel_ratio)

    def set_stripes(self, stripes: Stripes | None) -> None:
        """Draw the CAD flanks with zebra stripes."""
        if stripes != self._stripes:
            self._stripes = stripes
            self._each(self._stripe)

    def aim_stripes(self, cameras: Sequence[Camera]) -> None:
        """Set the lamps of the stripes for the cameras of the panes, just before a frame."""
        if self._stripes is None:
            return
        for pane, layers in enumerate(self._panes):
            for layer in layers:
                if layer.kind == "surface" and layer.layer_id in STRIPED:
                    aim_stripes(self._actors[pane][layer.key], self._stripes, cameras[pane])

    def _stripe(self, actor: vtkActor, layer: Layer) -> None:
        if layer.kind == "surface" and layer.layer_id in STRIPED:
            put_stripes(actor, self._stripes)

    def move(self, places: Mapping[str, Place]) -> None:
        """Move bodies from where their layers put them; no mesh is touched."""
        for body, place in places.items():
            matrix = self._places.get(body)
            if matrix is None:
                matrix = self._places[body] = vtkMatrix4x4()
                self._each(self._place)
            for row in range(3):
                for column in range(3):
                    matrix.SetElement(row, column, float(place.matrix[row, column]))
                matrix.SetElement(row, 3, float(place.shift[row]))

    def set_coarse(self, coarse: bool) -> None:
        """Show the coarse level of what has two, or the fine one."""
        if coarse != self._coarse:
            self._coarse = coarse
            self._each(self._place)

    def cut(self, plane: Plane | None) -> None:
        """Take away every body beyond a plane, or show them whole."""
        if plane is None:
            self._plane = None
        else:
            self._plane = self._plane or vtkPlane()
            self._plane.SetOrigin(*plane.point)
            self._plane.SetNormal(*(-plane.normal))
        self._each(self._place)

    def _each(self, change: Callable[[vtkActor, Layer], None]) -> None:
        for pane, layers in enumerate(self._panes):
            for layer in layers:
                change(self._actors[pane][layer.key], layer)

    def _place(self, actor: vtkActor, layer: Layer) -> None:
        actor.SetVisibility(layer.level != ("fine" if self._coarse else "coarse"))
        if not layer.body:
            return
        actor.SetUserMatrix(self._places.get(layer.body))
        mapper = actor.GetMapper()
        if self._plane is None:
            mapper.RemoveAllClippingPlanes()
        elif mapper.GetClippingPlanes() is None or not mapper.GetClippingPlanes().IsItemPresent(self._plane):
            planes = vtkPlaneCollection()
            planes.AddItem(self._plane)
            mapper.SetClippingPlanes(planes)

    def restyle(self, dark: bool, pixel_ratio: float) -> None:
        """Take the theme's colours and the screen's scale."""
        self.dark, self.pixel_ratio = dark, pixel_ratio
        for pane, layers in enumerate(self._panes):
            for layer in layers:
                self._style(self._actors[pane][layer.key], layer)

    def stand_like(self, other: ActorStore) -> None:
        """Take the places of the bodies, the cut and the colours of another store."""
        self.table.DeepCopy(other.table)
        self._plane = other._plane
        for body, matrix in other._places.items():
            self._places[body] = vtkMatrix4x4()
            self._places[body].DeepCopy(matrix)
        self._each(self._place)

    def clear(self) -> None:
        """Drop every actor and buffer."""
        self.set_layers(())

    def _show(self, pane: int, layer: Layer, buffer: MeshBuffer) -> None:
        actor = self._actors[pane].get(layer.key)
        if actor is None:
            actor = vtkActor()
            actor.SetPickable(False)
            self._actors[pane][layer.key] = actor
            self._renderers[pane].AddActor(actor)
            self._stripe(actor, layer)
        if actor.GetMapper() is not buffer.mapper:
            actor.SetMapper(buffer.mapper)
        self._style(actor, layer)
        self._place(actor, layer)

    def _drop_actors(self, pane: int, keep: set[str]) -> None:
        actors = self._actors[pane]
        for key in actors.keys() - keep:
            self._renderers[pane].RemoveActor(actors.pop(key))

    def _style(self, actor: vtkActor, layer: Layer) -> None:
        style = chosen_style(layer, self._looks)
        apply_style(actor.GetProperty(), layer, style, self.dark, self.pixel_ratio)
        if style.inside is not None:
            inside = actor.GetBackfaceProperty() or vtkProperty()
            inside.SetAmbient(1.0)
            inside.SetDiffuse(0.0)
            inside.SetSpecular(0.0)
            inside.SetColor(*rgb(style.inside.dark if self.dark else style.inside.light))
            actor.SetBackfaceProperty(inside)
        actor.SetForceTranslucent(style.opacity < 1)
        actor.SetForceOpaque(style.opacity >= 1)


def _same(before: Layer, after: Layer) -> bool:
    """Whether the cells need no new upload."""
    if after.kind == "points":
        return len(before.points) == len(after.points)
    return before.cells is after.cells or np.array_equal(before.cells, after.cells)
