"""Zebra stripes: what a room of straight lamps would look like in the surface, computed for every pixel.

The line of sight is reflected at the surface; its angle to the lamps, counted in stripes, decides between light and
dark. Stripes meet across an edge where the surfaces are tangent, and have no kink where their curvatures agree.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ui.camera import Camera

Floats = NDArray[np.float64]

FEWEST, MOST = 4, 80
_TAG = "//VTK::Light::Impl"
_DARKEST = 0.14
_STRIPES = f"""{_TAG}
  vec3 zebraNormal = normalize(normalVCVSOutput);
  vec3 zebraEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  if (dot(zebraNormal, zebraEye) < 0.0) zebraNormal = -zebraNormal;
  vec3 zebraRay = reflect(-zebraEye, zebraNormal);
  float zebraPlace = asin(clamp(dot(zebraRay, zebraLamps), -1.0, 1.0)) * zebraCount / 3.14159265;
  float zebraWave = 2.0 * abs(fract(zebraPlace) - 0.5);
  float zebraBlur = clamp(2.0 * fwidth(zebraPlace), 0.002, 0.5);
  float zebraLight = smoothstep(0.5 - zebraBlur, 0.5 + zebraBlur, zebraWave);
  gl_FragData[0].rgb *= mix({_DARKEST}, 1.0, zebraLight);
"""


@dataclass(frozen=True)
class Stripes:
    """How the lamps stand.

    Attributes
    ----------
    count : int
        Stripes over half a turn of the reflected ray.
    with_gear : bool
        The lamps are fixed to the gear and the stripes flow when the camera moves only as the eye does;
        else they are fixed to the camera.
    angle_deg : float
        Turns the lamps: in the picture, or about the gear's tooth from its axis to the side.
    """

    count: int = 40
    with_gear: bool = False
    angle_deg: float = 90.0

    def direction(self, look: Camera) -> Floats:
        """Across the lamps, in the camera's axes (right, up, back), shape (3,)."""
        angle = np.radians(self.angle_deg)
        if not self.with_gear:
            return np.array([np.cos(angle), np.sin(angle), 0.0])
        fixed = np.array([0.0, np.sin(angle), np.cos(angle)])
        return np.array([fixed @ look.right, fixed @ look.up, fixed @ look.back])


def put_stripes(actor: Any, stripes: Stripes | None) -> None:
    """Draw an actor with stripes, or plainly again."""
    shader = actor.GetShaderProperty()
    if stripes is None:
        shader.ClearFragmentShaderReplacement(_TAG, True)
    else:
        shader.AddFragmentShaderReplacement(_TAG, True, _STRIPES, False)
        shader.GetFragmentCustomUniforms().SetUniformf("zebraCount", float(stripes.count))


def aim_stripes(actor: Any, stripes: Stripes, look: Camera) -> None:
    """Set where the lamps are for the frame to come."""
    actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniform3f("zebraLamps", list(stripes.direction(look)))
