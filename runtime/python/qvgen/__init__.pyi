# SPDX-License-Identifier: MIT
import enum
import os
import pathlib
from typing import Any, Iterable, Literal, Mapping, NamedTuple, Protocol

from numpy import bool_, float32, float64, int32
from numpy.typing import ArrayLike, NDArray

from . import derivatives as derivatives
from . import interop as interop
from . import metrics as metrics
from . import orientation as orientation
from . import robots as robots

class BuildError(RuntimeError): ...

class Status(enum.IntEnum):
    solved = 0
    singular = 1
    unreachable = 2
    invalid = 3
    incomplete = 4

class VelocityStatus(enum.IntEnum):
    solved = 0
    damped = 1
    invalid_input = 2
    incomplete = 3

class Solutions(NamedTuple):
    q: NDArray[float64]
    count: NDArray[int32]
    status: NDArray[int32]
    branch: NDArray[int32]
    continuum: NDArray[bool_]

class Assemblies(NamedTuple):
    q: NDArray[float64]
    count: NDArray[int32]
    status: NDArray[int32]
    branch: NDArray[int32]
    continuum: NDArray[bool_]
    meets: NDArray[bool_]

class Followed(NamedTuple):
    q: NDArray[float64]
    closed: NDArray[bool_]

class TipMotion(NamedTuple):
    pose: NDArray[float64]
    jacobian: NDArray[float64]
    bias: NDArray[float64]

class NearSolution(NamedTuple):
    q: NDArray[float64]
    status: NDArray[int32]

class NearestRows(NamedTuple):
    q: NDArray[float64]
    position_error: NDArray[float64]
    orientation_error: NDArray[float64]
    continuum: NDArray[bool_]
    count: NDArray[int32]
    status: NDArray[int32]

class JointRates(NamedTuple):
    qd: _Result
    status: NDArray[int32]
    residual: _Result
    factor: _Result
    limited: NDArray[bool_]

class Motion(NamedTuple):
    s: NDArray[float64]
    q: NDArray[float64]
    begins: str
    ends: str
    branches: list[int]
    turns: float
    values: NDArray[float64] | None
    gaps: list[tuple[float, float]] | None
    t: NDArray[float64] | None = None
    overload: tuple[str, float, float] | None = None

class Paths(NamedTuple):
    motions: list[Motion]
    whole: list[int]
    chain: list[tuple[int, float]]
    gaps: list[tuple[float, float]]
    others: list[tuple[float, float]] | None = None
    fastest: int | None = None

class Page:
    path: pathlib.Path

_Constants = dict[str, float] | None
_Limits = Literal["description"] | tuple[ArrayLike, ArrayLike] | None
_RateLimits = Literal["description"] | tuple[ArrayLike, ArrayLike]
_Reference = Literal["conventional", "stereographic"]
_Prefer = Literal["both", "position", "orientation"]
_Result = NDArray[float64] | NDArray[float32]
_Out = NDArray[float64] | NDArray[float32] | None

class Robot(Protocol):
    """Module of a robot, with all that it can have: `functions` tells what it has. Shapes and units are in the docstrings."""

    dof: int
    joint_names: list[str]
    is_revolute: list[bool]
    lower_limits: list[float]
    upper_limits: list[float]
    velocity_limits: list[float]
    effort_limits: list[float]
    default_geometry: dict[str, float]
    default_inertia: dict[str, float]
    functions: dict[str, str]
    limbs: Mapping[str, "Robot"]  #: of what `load` returns: chains to the tips, where the joints branch
    singularity_names: list[str]
    base_parameter_names: list[str]

    def forward_kinematics(
        self, q: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def homogeneous_transform(
        self, q: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def jacobian(
        self, q: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def tool_jacobian(
        self, q: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def jacobian_at(
        self, q: ArrayLike, point: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def singularity_measures(
        self, q: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def jacobian_dot(
        self, q: ArrayLike, qd: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def velocity(
        self, q: ArrayLike, qd: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def jacobian_dot_times_qd(
        self, q: ArrayLike, qd: ArrayLike, *, geometry: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def forward_kinematics_and_jacobian(self, q: ArrayLike, *, geometry: _Constants = None) -> Any: ...  # transform, jacobian
    def inverse_velocity(
        self, q: ArrayLike, twist: ArrayLike, *, geometry: _Constants = None, threshold: float = 0.02,
        damping: float = 0.02, scale: float = 0.05,
    ) -> JointRates: ...
    def inverse_velocity_scaled(
        self, q: ArrayLike, twist: ArrayLike, *, limits: _RateLimits = "description", geometry: _Constants = None,
        threshold: float = 0.02, damping: float = 0.02, scale: float = 0.05,
    ) -> JointRates: ...
    def inverse_velocity_within(
        self, q: ArrayLike, twist: ArrayLike, *, limits: _RateLimits = "description", geometry: _Constants = None,
        threshold: float = 0.02, damping: float = 0.02, scale: float = 0.05,
    ) -> JointRates: ...
    def inverse_dynamics(
        self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, gravity: float = 9.80665, out: _Out = None,
    ) -> _Result: ...
    def forward_dynamics(
        self, q: ArrayLike, qd: ArrayLike, torque: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, gravity: float = 9.80665, out: _Out = None,
    ) -> _Result: ...
    def gravity_torque(
        self, q: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, gravity: float = 9.80665, out: _Out = None,
    ) -> _Result: ...
    def coriolis_torque(
        self, q: ArrayLike, qd: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def mass_matrix(
        self, q: ArrayLike, *, geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def coriolis_matrix(
        self, q: ArrayLike, qd: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def kinetic_energy(
        self, q: ArrayLike, qd: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def potential_energy(
        self, q: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, gravity: float = 9.80665, out: _Out = None,
    ) -> _Result: ...
    def inverse_dynamics_derivatives(  # torque, by_position, by_rate
        self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, gravity: float = 9.80665,
    ) -> Any: ...
    def regressor(
        self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, gravity: float = 9.80665, out: _Out = None,
    ) -> _Result: ...
    def inverse_dynamics_with_gravity_vector(
        self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, fall: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def inverse_dynamics_with_wrench(
        self, q: ArrayLike, qd: ArrayLike, qdd: ArrayLike, fall: ArrayLike, wrench: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def gravity_torque_with_gravity_vector(
        self, q: ArrayLike, fall: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def forward_dynamics_with_gravity_vector(
        self, q: ArrayLike, qd: ArrayLike, torque: ArrayLike, fall: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def forward_dynamics_with_wrench(
        self, q: ArrayLike, qd: ArrayLike, torque: ArrayLike, fall: ArrayLike, wrench: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...
    def potential_energy_with_gravity_vector(
        self, q: ArrayLike, fall: ArrayLike, *,
        geometry: _Constants = None, inertia: _Constants = None, out: _Out = None,
    ) -> _Result: ...

    # An arm with a joint given has also inverse_kinematics_given_NAME(target, given, seed=None, ...) and
    # inverse_kinematics_near_given_NAME(target, given, seed, ...). Where less than a pose is taken too `pose` is `target`.
    def inverse_kinematics(
        self, pose: ArrayLike, seed: ArrayLike | None = None, *, limits: _Limits = None, geometry: _Constants = None,
        tolerance: float = 1e-13,
    ) -> Solutions: ...
    def inverse_kinematics_near(
        self, pose: ArrayLike, seed: ArrayLike, *, path: bool = False, limits: _Limits = None, geometry: _Constants = None,
        tolerance: float = 1e-13,
    ) -> NearSolution: ...
    # Arms of seven joints around a spherical shoulder and wrist; their inverse_kinematics has limits="description".
    def arm_angle(
        self, q: ArrayLike, *, reference: _Reference = "conventional", geometry: _Constants = None,
    ) -> NDArray[float64]: ...
    def inverse_kinematics_arm_angle(
        self, pose: ArrayLike, psi: ArrayLike, seed: ArrayLike | None = None, *, reference: _Reference = "conventional",
        geometry: _Constants = None, tolerance: float = 1e-13,
    ) -> Solutions: ...
    def nearest_pose(
        self, pose: ArrayLike, seed: ArrayLike | None = None, *, prefer: _Prefer = "both",
        metres_per_radian: float = 0.0, limits: _Limits = None, starts: int = 32, geometry: _Constants = None,
    ) -> NearestRows: ...
    def paths(
        self, poses: ArrayLike, *, free: str | Mapping[str, float | tuple[float, float] | None] | None = None,
        hold: Mapping[str, float] | None = None,
        limits: _Limits = "description", times: ArrayLike | None = None, screw: bool = False,
        prefer: ArrayLike | None = None, prove: bool = False, time: ArrayLike | None = None,
        joint_speeds: ArrayLike | None = None, spline: bool = False, blend: float | None = None,
        free_range: tuple[float, float] | None = None, joint_torques: ArrayLike | Literal["description"] | None = None,
        joint_jerks: ArrayLike | None = None,
    ) -> Paths: ...
    def plot(self, q: ArrayLike, *, axes: Any = None) -> Any: ...  # axes of matplotlib
    def show(self, *, browser: bool = True) -> Page: ...
    def __getattr__(self, name: str) -> Any: ...

def cache_folder() -> pathlib.Path: ...
def calibrate(
    description: str | os.PathLike[str], data: str | os.PathLike[str], output: str | os.PathLike[str], *options: str
) -> str: ...
def identify(
    description: str | os.PathLike[str],
    logs: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    output: str | os.PathLike[str] | None = ...,
    *options: str,
) -> str: ...
def load(description: str | os.PathLike[str], *options: str, floating: bool = ...) -> Robot: ...
