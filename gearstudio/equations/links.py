"""Which equations a field of the design enters, and which give a quantity of the data sheet."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from gearstudio.design import all_field_specs
from gearstudio.equations.listing import equation
from gearstudio.equations.records import holds
from gearstudio.theory.cones import PairGeometry

_PLAIN_FIELDS = {
    "pair.pinion_teeth": "pitch_angle mean_radii half_thickness cone_distance contact_ratio contact_turns",
    "pair.wheel_teeth": "pitch_angle mean_radii half_thickness cone_distance contact_ratio contact_turns",
    "pair.shaft_angle_deg": "pitch_angle pitch_cones touching_cones placing",
    "pair.outer_module": "base_radius mean_module own_depth cone_distance mean_radii",
    "pair.pressure_angle_deg": "transverse_angle flank_angles base_angle base_radius normal_thickness duplex",
    "pair.pressure_angle_kind": "transverse_angle",
    "pair.face_width_factor": "face spiral_start",
    "pair.face_width": "face spiral_start places",
    "pair.pinion_hand": "turn flank",
    "pair.offset": "offset_arms pitch_cones",
    "lengthwise.curve": "turn base_spiral trace limit_radius",
    "lengthwise.spiral_angle_deg": "trace spiral_angles transverse_angle toe_spiral mean_module",
    "lengthwise.spiral_angle_at": "toe_spiral spiral_start",
    "lengthwise.cutter_radius": "trace limit_radius duplex",
    "lengthwise.spiral_angle_of": "spiral_angles",
    "tooth.addendum_factor": "own_depth depths tip working_depth",
    "tooth.clearance_factor": "own_depth depths working_depth",
    "tooth.profile_shift": "own_depth half_thickness mean_depths",
    "tooth.backlash": "half_thickness normal_thickness",
    "tooth.fillet_factor": "fillet",
    "tooth.tip_cone": "tip_parallel depths",
    "tooth.ends": "ends toe",
    "tooth.limit_pressure_angle_factor": "flank_angles",
    "depth.system": "working_depth own_depth",
    "depth.taper": "taper duplex",
    "depth.depth_factor": "working_depth mean_depths",
    "depth.clearance_factor": "working_depth",
    "depth.mean_addendum_factor": "mean_depths",
    "depth.thickness_factor": "normal_thickness",
    "depth.addendum_angle_deg": "taper",
    "depth.dedendum_angle_deg": "taper",
    "methods.tolerance_um": "deviation",
    "methods.point_cloud_degree": "nurbs",
}
_RELIEF_FIELDS = {
    "lengthwise_crowning_um": "relief modified_flank",
    "profile_crowning_um": "relief modified_flank",
    "spiral_angle_correction_um": "relief",
    "pressure_angle_correction_um": "relief",
    "bias_um": "relief",
    "tip_relief_um": "tip_relief relief",
    "tip_relief_start": "tip_relief",
    "root_relief_um": "root_relief relief",
    "root_relief_end": "root_relief",
}
_ENDS = "emi"
_QUANTITIES = {
    "sigma": "pitch_angle pitch_cones",
    "u": "pitch_angle mean_radii",
    "m": "mean_module base_radius mean_radii",
    "m_mn": "mean_module mean_radii",
    "alpha_n": "transverse_angle flank_angles",
    "alpha": "transverse_angle flank_angles",
    "ha": "own_depth",
    "c": "own_depth",
    "j_t": "half_thickness normal_thickness",
    "R_e": "cone_distance mean_radii",
    "R_m": "face mean_radii",
    "R_i": "face",
    "b": "face",
    "b_e": "face",
    "b_i": "face",
    "beta_e": "trace spiral_angles",
    "beta_m": "trace spiral_angles",
    "beta_i": "trace toe_spiral",
    "eps_alpha": "contact_ratio contact_turns",
    "eps_beta": "contact_ratio contact_turns",
    "eps_gamma": "contact_ratio contact_turns",
    "eps_o": "contact_ratio contact_turns",
    "z": "pitch_angle mean_radii",
    "x": "own_depth",
    "delta": "pitch_angle limit_radius pitch_cones",
    "delta_a": "tip_parallel depths touching_cones taper",
    "delta_f": "depths touching_cones taper",
    "delta_b": "base_angle flank_angles",
    "delta_bD": "flank_angles base_angle",
    "delta_bC": "flank_angles base_angle",
    "gamma": "element_angle",
    "theta_a": "tip_parallel depths taper",
    "theta_f": "depths taper",
    "R_b": "base_radius",
    "t_xo": "crown",
    "t_xi": "crown",
    "b_x": "crown",
    "t_z": "apexes",
    "t_zF": "touching_cones tip_parallel",
    "t_zR": "touching_cones depths",
    "a": "offset_arms",
    "zeta_m": "offset_arms pitch_cones",
    "zeta_mp": "pitch_cones",
    "zeta_R": "touching_cones",
    "zeta_o": "touching_cones",
    "a_p": "offset_arms",
    "alpha_lim": "limit_angle",
    "alpha_nD": "flank_angles transverse_angle",
    "alpha_nC": "flank_angles transverse_angle",
    "h_mw": "working_depth",
    "clearance": "working_depth",
    "half": "half_thickness",
    "s_et": "thickness",
    "s_etc": "thickness",
    "s_mt": "thickness",
    "s_mn": "normal_thickness thickness",
    "s_mnc": "normal_thickness thickness",
    "d_v": "thickness",
    "h_aec": "thickness",
    "h_amc": "normal_thickness thickness",
    "s_ae": "tip_land",
    "s_ai": "tip_land",
    "undercut": "undercut",
    "R_f": "fillet",
    "x_hm": "mean_depths",
    "x_sm": "normal_thickness",
    "m_et": "diameters",
    "delta_iso": "pitch_cones pitch_angle",
    "R_m_iso": "mean_radii cone_distance",
    "beta_m_iso": "spiral_angles trace",
    **{f"d_{part}{end}": "diameters" for end in _ENDS for part in ("", "a", "f")},
    **{f"h_{part}{end}": "heights mean_depths" for end in _ENDS for part in ("", "a", "f")},
    "h_ae": "own_depth mean_depths",
    "h_fe": "own_depth mean_depths",
    **{f"c_{end}": "heights" for end in _ENDS},
}


@cache
def equations_of_field(path: str) -> tuple[str, ...]:
    """Keys of the equations that a field enters, the nearest first; empty for a name or a size of the blank."""
    plain = _PLAIN_FIELDS.get(path, "")
    relief = _RELIEF_FIELDS.get(path.rsplit(".", 1)[-1], "") if path.startswith("modifications.") else ""
    return tuple((plain or relief).split())


def equations_of_quantity(key: str) -> tuple[str, ...]:
    """Keys of the equations that give a quantity of the data sheet, the nearest first."""
    return tuple(_QUANTITIES.get(key, "").split())


@cache
def fields_of(key: str) -> tuple[str, ...]:
    """Paths of the fields that an equation uses, in the order of the form."""
    return tuple(path for path in all_field_specs() if key in equations_of_field(path))


def equation_for(keys: Iterable[str], pair: PairGeometry | None) -> str:
    """Of some equations the first that holds for a pair, else the first; empty without any."""
    found = list(keys)
    fitting = (key for key in found if pair is not None and holds(equation(key), pair))
    return next(fitting, found[0] if found else "")
