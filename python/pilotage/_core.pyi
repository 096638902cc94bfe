"""
Pilotage's C++ core and engine.
"""
from __future__ import annotations
import collections.abc
import numpy
import numpy.typing
import typing
__all__: list[str] = ['ArcUnicycle', 'ArcVelocity', 'CalibratedArc', 'CameraModel', 'Config', 'ConfigError', 'ConstantVelocity', 'DifferentialDrive', 'EchoEnvelope', 'Ekf3', 'Ekf5', 'Ekf6', 'Engine', 'EulerVelocity', 'GyroDrive', 'HeadingFix', 'LinearKalman', 'LinearizedVelocity', 'Localizer', 'MarkerMap', 'MarkerModel', 'MidpointUnicycle', 'MidpointVelocity', 'MoveAndTurn', 'PlanarVelocity', 'Policy', 'PoseFix', 'PositionFix', 'Recording', 'RelativePosition', 'Run', 'SkidSteer', 'Speed', 'Ukf3', 'Ukf4', 'Ukf5', 'Ukf6', 'Unscented', 'UpdateReport', 'WallMap', 'WallRange', 'WheelTravel', 'WorldBearing', 'YawRate', 'associate_pixels', 'load_config', 'read_checkpoint', 'read_table', 'relative_position_noise', 'replay', 'unscented_transform']
class ConfigError(ValueError):
    """
    A configuration or map that cannot be used; names file, line, key, value and what was expected.
    """
class MarkerMap:
    """
    The surveyed markers, sorted by id.
    """
    @staticmethod
    def load(path: str) -> MarkerMap:
        """
        Reads a YAML list of {id, x, y, z, sigma, label}; ValueError names file, line and value.
        """
    def __init__(self, ids: typing.Annotated[numpy.typing.ArrayLike, numpy.int32], positions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], sigmas: typing.Any = 0.0, labels: typing.Annotated[numpy.typing.ArrayLike, numpy.int32] | None = None) -> None:
        """
        Parameters
        ----------
        ids : (n,) int, 0 or more, each once
        positions : (n, 3) float, x, y in frame map and z above the ground [m]
        sigmas : float or (n,) float, standard deviation of the survey in x and in y [m]
        labels : (n,) int, class of look-alike markers (a pole's colour), -1 none; none at all if left out
        
        Raises
        ------
        ValueError
            If the map is empty, an id comes twice, a number is not finite or a label is below -1.
        """
    def __len__(self) -> int:
        ...
    def __repr__(self) -> str:
        ...
    def save(self, path: str) -> None:
        """
        Writes the YAML list that `load` reads.
        """
    @property
    def ids(self) -> numpy.typing.NDArray[numpy.int32]:
        """
        (n,) int32
        """
    @property
    def labels(self) -> numpy.typing.NDArray[numpy.int32]:
        """
        (n,) int32, -1 where there is none
        """
    @property
    def positions(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (n, 3) float [m]
        """
    @property
    def sigmas(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (n,) float [m]
        """
class CameraModel:
    """
    A camera on the robot: from points to pixels and back.
    
    OpenCV's pinhole with its radial and tangential distortion. Pixel (0, 0) is the centre of the top
    left one, u to the right, v down. The level sensor frame has its origin at the sensor, x along its
    forward axis (the mounting's yaw) in the horizontal plane, y left and z up.
    """
    def __init__(self, size: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(2)"], matrix: typing.Annotated[collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex], "FixedSize(4)"], distortion: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex] = [], roll_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0, pitch_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Parameters
        ----------
        size : (width, height) of the image [px]
        matrix : (fx, fy, cx, cy) [px]
        distortion : none, 4 (k1 k2 p1 p2), 5 (and k3) or 8 (and k4 k5 k6) numbers
        roll_rad, pitch_rad : of the camera body in the level sensor frame, R = Ry(pitch) Rx(roll): positive
            pitch looks down, positive roll lowers the right side
        
        Raises
        ------
        ValueError
            Naming what is not finite, not positive, or of the wrong length.
        """
    def __repr__(self) -> str:
        ...
    def angle_covariance(self, pixels: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], covariance: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        Covariance (n, 2, 2) of the angles [rad^2] from that of the pixels (n, 2, 2) [px^2], to first order.
        """
    def angles(self, pixels: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        (n, 2): azimuth, left positive, and elevation, up positive [rad], of what is seen at pixels (n, 2): bearing and elevation of a sighting. NaN where no point is seen.
        """
    def project(self, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        Pixels (n, 2) of points (n, 3) in the level sensor frame [m]; NaN behind the camera and beyond where the distortion is one-to-one. They may lie outside the image.
        """
    def rays(self, pixels: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        Unit vectors (n, 3) in the level sensor frame towards what is seen at pixels (n, 2); NaN where no point is seen.
        """
    @property
    def distortion(self) -> typing.Annotated[list[float], "FixedSize(8)"]:
        """
        k1 k2 p1 p2 k3 k4 k5 k6
        """
    @property
    def matrix(self) -> tuple[float, float, float, float]:
        """
        (fx, fy, cx, cy) [px]
        """
    @property
    def pitch_rad(self) -> float:
        ...
    @property
    def roll_rad(self) -> float:
        ...
    @property
    def rotation(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        (3, 3), from OpenCV's camera frame (x right, y down, z forward) to the level sensor frame
        """
    @property
    def size(self) -> tuple[int, int]:
        """
        (width, height) [px]
        """
    @property
    def widest_rad(self) -> float:
        """
        Angle from the optical axis within which the distortion is one-to-one.
        """
class WallMap:
    """
    The walls of a world, and what a beam meets among them.
    """
    def __init__(self, segments: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> None:
        """
        segments : (n, 4) float, from x, y to x, y in frame map [m], in any order; raises ConfigError for a wall without length and for what is not finite
        """
    def __len__(self) -> int:
        ...
    def cast(self, poses: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], angles_rad: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        Ranges [m] (n, k) to the nearest walls from poses (n, 3) at angles (k,) from their headings; inf where there is no wall.
        """
    @property
    def segments(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (n, 4) float, from x, y to x, y in frame map [m]
        """
class WallRange:
    """
    Distance [m] to the nearest wall along a beam.
    
    Not defined where the beam meets no wall, or one at less than 3 degrees.
    """
    def __init__(self, walls: WallMap, beam_rad: typing.SupportsFloat | typing.SupportsIndex, mounting: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = ...) -> None:
        """
        Parameters
        ----------
        walls : WallMap
        beam_rad : from the sensor's forward axis, left positive
        mounting : (3,) float, the sensor's x, y [m] and yaw [rad] in the robot frame
        """
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class Config:
    """
    All that a run needs besides its input.
    
    Keys are dotted, as in the file: ``config["sensors.camera.sigma_bearing_rad"] = 0.02``. Speaking of a
    sensor that is not there adds it. `describe` lists every key with its value and meaning.
    """
    @staticmethod
    def parse(yaml: str) -> Config:
        """
        Reads YAML text; raises ConfigError.
        """
    def __getitem__(self, key: str) -> typing.Any:
        """
        Raises KeyError naming the nearest known key.
        """
    @typing.overload
    def __init__(self) -> None:
        ...
    @typing.overload
    def __init__(self, other: Config) -> None:
        """
        A copy.
        """
    def __setitem__(self, key: str, value: typing.Any) -> None:
        """
        Raises KeyError naming the nearest known key, ConfigError for an impossible value.
        """
    def camera(self, sensor: str) -> CameraModel | None:
        """
        The CameraModel of a sensor by its name, None if it has no intrinsics; KeyError if there is no such sensor.
        """
    def check(self) -> None:
        """
        Raises ConfigError if the parts do not fit together.
        """
    def describe(self) -> list[tuple[str, str, str]]:
        """
        (key, value, meaning) of every key.
        """
    def set_camera(self, sensor: str, camera: CameraModel) -> None:
        """
        Gives a sensor a camera, with its roll and pitch; KeyError if there is no such sensor.
        """
    def to_yaml(self) -> str:
        """
        Every key with its value, and the map.
        """
    @property
    def detectors(self) -> dict[str, typing.Any]:
        """
        The section of that name as it stands, by sensor; empty where there is none. The node passes over it.
        """
    @detectors.setter
    def detectors(self, arg1: dict[str, typing.Any]) -> None:
        ...
    @property
    def map(self) -> MarkerMap:
        """
        The MarkerMap.
        """
    @map.setter
    def map(self, arg0: MarkerMap) -> None:
        ...
    @property
    def marker_sensors(self) -> list[str]:
        """
        Names of those that measure markers.
        """
    @property
    def pixel_sensors(self) -> list[str]:
        """
        Names of those that measure pixels.
        """
    @property
    def sensors(self) -> list[str]:
        """
        Names of the sensors.
        """
    @property
    def walls(self) -> WallMap:
        """
        The WallMap.
        """
    @walls.setter
    def walls(self, arg0: WallMap) -> None:
        ...
class Recording:
    """
    LCM messages in the order of their arrival, as a log file holds them.
    
    The `add_*` methods encode whole arrays. Stamps are integer microseconds; the time of arrival is the
    stamp unless `received` is given, and seq counts from 0 unless `seq` is. Call `sort` once everything is added.
    """
    @staticmethod
    def load(path: str) -> Recording:
        """
        Reads an LCM log file, over damaged places; see `damage`.
        """
    def __getitem__(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> tuple[int, str, bytes]:
        """
        (received, channel, data) of a message.
        """
    def __init__(self) -> None:
        ...
    def __len__(self) -> int:
        ...
    def add(self, received: typing.SupportsInt | typing.SupportsIndex, channel: str, data: bytes) -> None:
        """
        Any one encoded message.
        """
    def add_encoders(self, channel: str, utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64], left: typing.Annotated[numpy.typing.ArrayLike, numpy.int64], right: typing.Annotated[numpy.typing.ArrayLike, numpy.int64], received: typing.Annotated[numpy.typing.ArrayLike, numpy.int64] | None = None, seq: typing.Annotated[numpy.typing.ArrayLike, numpy.int32] | None = None) -> None:
        """
        encoders_t: (n,) int64 absolute ticks.
        """
    def add_gyro(self, channel: str, utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64], rate: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], received: typing.Annotated[numpy.typing.ArrayLike, numpy.int64] | None = None, seq: typing.Annotated[numpy.typing.ArrayLike, numpy.int32] | None = None) -> None:
        """
        gyro_t: (n,) mean yaw rate since the previous sample [rad/s].
        """
    def add_reference(self, channel: str, utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64], x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], y: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], heading: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], received: typing.Annotated[numpy.typing.ArrayLike, numpy.int64] | None = None, seq: typing.Annotated[numpy.typing.ArrayLike, numpy.int32] | None = None) -> None:
        """
        reference_t: (n,) truth [m, m, rad].
        """
    def add_sightings(self, channel: str, sensor: str, utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64], id: typing.Annotated[numpy.typing.ArrayLike, numpy.int32], bearing: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], elevation: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], range: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], received: typing.Annotated[numpy.typing.ArrayLike, numpy.int64] | None = None, seq: typing.Annotated[numpy.typing.ArrayLike, numpy.int32] | None = None) -> None:
        """
        marker_frame_t: (n,) each, NaN where not measured [rad, rad, m]; rows that follow each other with equal utime, time of arrival and seq make one frame.
        """
    def add_ticks(self, utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64]) -> None:
        """
        tick_t, as `pilotage-node` records them: (n,) times at which the status is due.
        """
    def add_velocity(self, channel: str, utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64], v: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], omega: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], received: typing.Annotated[numpy.typing.ArrayLike, numpy.int64] | None = None, seq: typing.Annotated[numpy.typing.ArrayLike, numpy.int32] | None = None) -> None:
        """
        velocity_t: (n,) means since the previous sample [m/s, rad/s].
        """
    def arrivals(self, channel: str) -> numpy.typing.NDArray[numpy.int64]:
        """
        (n,) times of arrival of a channel's messages, in order [us].
        """
    def messages(self, channel: str) -> list[bytes]:
        """
        The encoded messages of a channel, in order.
        """
    def reference(self) -> numpy.ndarray:
        """
        All reference_t in it: structured array of utime, x, y, heading.
        """
    def save(self, path: str) -> None:
        """
        Writes an LCM log file.
        """
    def sort(self) -> None:
        """
        By time of arrival; equal times stay in the order of adding.
        """
    @property
    def damage(self) -> list[str]:
        """
        A line for each damaged place of the file.
        """
class MidpointUnicycle:
    """
    u = (distance [m], turn [rad]), driven along the mid heading.
    
    Eqs. 16 to 18 of Kiriy and Buehler 2002.
    """
    def __init__(self, slip_angle_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class ArcUnicycle:
    """
    u = (distance [m], turn [rad]), driven along the exact arc.
    """
    def __init__(self, slip_angle_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class MoveAndTurn:
    """
    u = (distance [m], turn [rad]), a straight move and then a turn on the spot.
    """
    def __init__(self, slip_angle_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class DifferentialDrive:
    """
    u = (left travel [m], right travel [m]), heading from the wheels.
    
    Eqs. 16 to 22 of Kiriy and Buehler 2002; eqs. 31 to 35 of Tamas et al. 2008 without their arctan.
    """
    def __init__(self, track_width_m: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class GyroDrive:
    """
    u = (left travel [m], right travel [m], turn by the gyro [rad]).
    
    Eqs. 16 to 19 of Kiriy and Buehler 2002; its B replaces eq. 22, which holds only where the heading comes
    from the wheels.
    """
    def __init__(self) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class CalibratedArc:
    """
    ArcUnicycle behind the calibration states gyro bias [rad/s], distance scale and
    rotation scale (six states); u = (distance [m], turn [rad]) as measured.
    """
    def __init__(self, gyro_time_s: typing.SupportsFloat | typing.SupportsIndex, slip_angle_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 6]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class EulerVelocity:
    """
    u = (speed [m/s], yaw rate [rad/s]) over dt_s, along the heading at the start.
    
    Eqs. 5 and 6 of Kohler's final project report.
    """
    def __init__(self, dt_s: typing.SupportsFloat | typing.SupportsIndex, slip_angle_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class MidpointVelocity:
    """
    u = (speed [m/s], yaw rate [rad/s]) over dt_s, along the mid heading.
    """
    def __init__(self, dt_s: typing.SupportsFloat | typing.SupportsIndex, slip_angle_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class ArcVelocity:
    """
    u = (speed [m/s], yaw rate [rad/s]) over dt_s, along the exact arc.
    """
    def __init__(self, dt_s: typing.SupportsFloat | typing.SupportsIndex, slip_angle_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class LinearizedVelocity:
    """
    ArcVelocity whose covariance moves by exp(A dt), linearised at the start of the step.
    
    Eqs. 4 to 7 of Sousa, Costa, Moreira and Carvalho.
    """
    def __init__(self, dt_s: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class PlanarVelocity:
    """
    u = (forward [m/s], leftward [m/s], yaw rate [rad/s]) of the body, held over dt_s.
    """
    def __init__(self, dt_s: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class SkidSteer:
    """
    u = (right, left) speed of the wheels [m/s], held over dt_s.
    
    Eqs. 29 and 30 of Tamas et al. 2008: the (3, 2) coefficients give forward and leftward velocity and
    yaw rate [rad/m].
    """
    def __init__(self, coefficients: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 2]"], dt_s: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class ConstantVelocity:
    """
    State (x, y, heading, speed [m/s], yaw rate [rad/s]), along the exact arc.
    
    u = (acceleration [m/s^2], yaw acceleration [rad/s^2]) over dt_s, normally zero: its covariance is the
    process noise.
    """
    def __init__(self, dt_s: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[5, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[5, 5]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[5, 2]"]]:
        """
        f(x, u) and its Jacobians.
        
        Returns
        -------
        next : (n,) float, the state after the motion
        a : (n, n) float, by the state
        b : (n, m) float, by the input; without the rows of calibration states
        """
    def path(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 1]"], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k + 1, n) from x (n,) on, one step after the other, u (k, m).
        """
    def step_each(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The states (k, n) one step from each of x (k, n), u (k, m).
        """
class MarkerModel:
    """
    What a mounted sensor measures of one marker.
    """
    def __init__(self, marker: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], components: collections.abc.Sequence[str], mounting: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 1]"] = ..., range_scale: typing.SupportsFloat | typing.SupportsIndex = 1.0, range_offset_m: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Parameters
        ----------
        marker : (3,) float, x, y in frame map, z above the ground [m]
        components : some of "bearing" [rad], "elevation" [rad], "range" [m], in this order
        mounting : (4,) float, the sensor's x, y, z [m] and yaw [rad] in the robot frame
        range_scale, range_offset_m : reported = scale * true + offset
        """
    def linearize(self, pose: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian: eqs. 23 to 25 of Kiriy and Buehler 2002 (25 with its signs corrected).
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, 3) float, by (x, y, heading)
        defined : bool, False at the marker itself
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; bearings wrap.
        """
    def predict(self, poses: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many poses at once: (n, m) for (n, 3).
        """
class RelativePosition:
    """
    (forward, leftward) [m] from a mounted sensor to a marker.
    
    Eqs. 8 and 9 of Sousa, Costa, Moreira and Carvalho.
    """
    def __init__(self, marker: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], mounting: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = ...) -> None:
        """
        Parameters
        ----------
        marker : (2,) float, x, y in frame map [m]
        mounting : (3,) float, the sensor's x, y [m] and yaw [rad] in the robot frame
        """
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class WorldBearing:
    """
    Direction from a marker to the robot in frame map [rad]; it does not see the heading.
    
    Eq. 4 of Kohler's final project report, its innovation wrapped.
    """
    def __init__(self, marker: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> None:
        """
        marker : (2,) float, x, y in frame map [m]
        """
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class PositionFix:
    """
    x, y [m] in frame map of a point of the robot, such as an antenna.
    """
    def __init__(self, lever_arm: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"] = ...) -> None:
        """
        lever_arm : (2,) float, forward and leftward of the robot's origin [m]
        """
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class HeadingFix:
    """
    Heading [rad] from +x of frame map: a compass.
    """
    def __init__(self, offset_rad: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        offset_rad : read less the robot's heading
        """
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class PoseFix:
    """
    x, y [m] and heading [rad] of a sensor.
    """
    def __init__(self, mounting: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = ...) -> None:
        """
        mounting : (3,) float, the sensor's x, y [m] and yaw [rad] in the robot frame
        """
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class Speed:
    """
    The state's speed [m/s], its fourth entry.
    """
    def __init__(self) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class YawRate:
    """
    The state's yaw rate [rad/s], its fifth entry.
    """
    def __init__(self) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class WheelTravel:
    """
    (left, right) travel [m] within dt_s, of a state with speed and yaw rate.
    
    Eqs. 19 and 20 of Kiriy and Buehler 2002, solved for the wheels.
    """
    def __init__(self, track_width_m: typing.SupportsFloat | typing.SupportsIndex, dt_s: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class EchoEnvelope:
    """
    The envelope of an ultrasonic echo at a time, of the state (A0, tau [s], T [s], alpha).
    
    Eq. 38 of Tamas et al. 2008 with the sign of its exponent put right; zero before tau, highest at
    tau + alpha T, not defined unless T and alpha are positive.
    """
    @staticmethod
    def at_times(state: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 1]"], times_s: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        The envelope (n,) of one echo at times (n,).
        """
    def __init__(self, time_s: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    def linearize(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 1]"]) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"], bool]:
        """
        h(x) and its Jacobian.
        
        Returns
        -------
        value : (m,) float
        jacobian : (m, n) float, by the states that it sees
        defined : bool, whether there is anything to measure, and a derivative to trust
        """
    def minus(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], predicted: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Measured less predicted, (m,) each; angles wrap.
        """
    def predict(self, states: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> numpy.typing.NDArray[numpy.float64]:
        """
        h(x) of many states at once: (k, m) for (k, n).
        """
class Policy:
    """
    How an innovation decides about its own update.
    """
    @staticmethod
    def gate(false_reject: typing.SupportsFloat | typing.SupportsIndex) -> Policy:
        """
        Rejects an innovation whose NIS is above the chi-square quantile.
        """
    @staticmethod
    def student_t(dof: typing.SupportsFloat | typing.SupportsIndex = 4.0) -> Policy:
        """
        Weights by (nu + d) / (nu + NIS), at most 1.
        """
    def __init__(self) -> None:
        """
        Every finite innovation is fused with full weight.
        """
    def gate_nis(self, dof: typing.SupportsInt | typing.SupportsIndex) -> float:
        """
        The limit on the NIS for 1, 2 or 3 degrees of freedom.
        """
class UpdateReport:
    """
    What an update did.
    """
    @property
    def accepted(self) -> bool:
        ...
    @property
    def fault(self) -> str:
        """
        '', 'gated', 'undefined' or 'numeric'
        """
    @property
    def innovation(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (m,) float, measured less predicted
        """
    @property
    def nis(self) -> float:
        """
        normalised innovation squared
        """
    @property
    def s(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (m, m) float, H P H' + R
        """
    @property
    def weight(self) -> float:
        """
        robust weight, 0 when not taken
        """
class Ekf3:
    """
    The first paper's filter: x, y [m], heading [rad].
    
    ``predict(model, u, gamma, q)`` is the time update, eqs. 8 and 9: u the model's input, gamma its
    covariance, q (3,) the variances added to the states.
    """
    def __init__(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"]) -> None:
        ...
    def correct(self, innovation: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], h: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        The update with innovation (m,) and h (m, 3) given, so that they may be taken at another point.
        """
    @typing.overload
    def predict(self, model: MidpointUnicycle, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def predict(self, model: ArcUnicycle, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def predict(self, model: DifferentialDrive, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def predict(self, model: GyroDrive, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def predict(self, model: MoveAndTurn | EulerVelocity | MidpointVelocity | ArcVelocity | LinearizedVelocity | PlanarVelocity | SkidSteer, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    def propagate(self, next: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], a: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"], b: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 2]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        """
        The time update with next (3,), a (3, 3) and b (3, 2) given, so that they may be taken at another point.
        """
    @typing.overload
    def update(self, model: MarkerModel, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update, eqs. 10, 11 and 28 of Kiriy and Buehler 2002 (Joseph form), linearised at the state as it stands. Nothing changes unless the report says accepted.
        """
    @typing.overload
    def update(self, model: RelativePosition | WorldBearing | WallRange | PositionFix | HeadingFix | PoseFix, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @property
    def covariance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        (n, n) float, a copy
        """
    @property
    def state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (n,) float, a copy
        """
class Ekf6:
    """
    The filter with calibration: x, y [m], heading [rad], gyro bias [rad/s], distance scale, rotation scale.
    """
    def __init__(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"], p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 6]"]) -> None:
        ...
    def correct(self, innovation: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], h: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        The update with innovation (m,) and h (m, 3) given, so that they may be taken at another point.
        """
    def predict(self, model: CalibratedArc, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> None:
        ...
    def update(self, model: MarkerModel, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update, eqs. 10, 11 and 28 of Kiriy and Buehler 2002 (Joseph form), linearised at the state as it stands. Nothing changes unless the report says accepted.
        """
    @property
    def covariance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 6]"]:
        """
        (n, n) float, a copy
        """
    @property
    def state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        (n,) float, a copy
        """
class Ekf5:
    """
    The filter with velocities as states: x, y [m], heading [rad], speed [m/s], yaw rate [rad/s].
    """
    def __init__(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 1]"], p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 5]"]) -> None:
        ...
    def correct(self, innovation: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], h: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        The update with innovation (m,) and h (m, 5) given, so that they may be taken at another point.
        """
    def predict(self, model: ConstantVelocity, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 1]"]) -> None:
        ...
    @typing.overload
    def update(self, model: MarkerModel, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update, eqs. 10, 11 and 28 of Kiriy and Buehler 2002 (Joseph form), linearised at the state as it stands. Nothing changes unless the report says accepted.
        """
    @typing.overload
    def update(self, model: RelativePosition | WorldBearing | WallRange | PositionFix | HeadingFix | PoseFix, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @typing.overload
    def update(self, model: Speed | YawRate | WheelTravel, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @property
    def covariance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[5, 5]"]:
        """
        (n, n) float, a copy
        """
    @property
    def state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[5, 1]"]:
        """
        (n,) float, a copy
        """
class LinearKalman:
    """
    The Kalman filter of a linear system of 1 to 4 states.
    
    Eqs. 3, 4 and 7 to 11 of Tamas et al. 2008, x = A x + B u + w and z = H x + v, with Q the covariance
    of w and R that of v. No state is an angle.
    """
    def __init__(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"]) -> None:
        ...
    def predict(self, a: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], bu: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"]) -> None:
        """
        Time update, eqs. 7 and 8.
        
        Parameters
        ----------
        a : (n, n) float
        bu : (n,) float, what the input adds: b @ u
        q : (n, n) float
        """
    def update(self, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], h: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update, eqs. 9 to 11 as the Joseph form.
        
        Nothing changes unless the report says accepted.
        
        Parameters
        ----------
        z : (m,) float, m up to 3
        h : (m, n) float
        r : (m, m) float
        """
    @property
    def covariance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        (n, n) float, a copy
        """
    @property
    def state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (n,) float, a copy
        """
class Unscented:
    """
    The set of sigma points: mean +- sqrt(c) times the columns of a Cholesky root.
    
    c = alpha^2 (n + kappa), with n the entries that have a variance. ``Unscented()`` is the set of 2n
    points with equal weights, ``Unscented(kappa=1)`` that of eq. 14 of Tamas et al. 2008.
    """
    def __init__(self, alpha: typing.SupportsFloat | typing.SupportsIndex = 1.0, beta: typing.SupportsFloat | typing.SupportsIndex = 0.0, kappa: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        alpha above 0, beta and kappa 0 or more: no covariance comes out indefinite then.
        """
    @property
    def alpha(self) -> float:
        """
        spread of the points
        """
    @property
    def beta(self) -> float:
        """
        weight of the mean's shift in the covariance
        """
    @property
    def kappa(self) -> float:
        """
        added to n
        """
class Ukf3:
    """
    Ekf3's unscented counterpart: x, y [m], heading [rad].
    
    It takes the models that Ekf3 takes and uses their values alone, eqs. 14 to 28 of Tamas et al. 2008.
    ``predict(model, u, gamma, q)``: u the model's input, gamma its covariance, q (3,) the variances
    added to the states. Sigma points are of state and input; with gamma zero, of the state alone.
    """
    def __init__(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"], unscented: Unscented = ...) -> None:
        ...
    @typing.overload
    def predict(self, model: MidpointUnicycle, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def predict(self, model: ArcUnicycle, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def predict(self, model: DifferentialDrive, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def predict(self, model: GyroDrive, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def predict(self, model: MoveAndTurn | EulerVelocity | MidpointVelocity | ArcVelocity | LinearizedVelocity | PlanarVelocity | SkidSteer, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @typing.overload
    def update(self, model: MarkerModel, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @typing.overload
    def update(self, model: RelativePosition | WorldBearing | WallRange | PositionFix | HeadingFix | PoseFix, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @property
    def covariance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        (n, n) float, a copy
        """
    @property
    def state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (n,) float, a copy
        """
class Ukf6:
    """
    Ekf6's unscented counterpart, with its models.
    """
    def __init__(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"], p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 6]"], unscented: Unscented = ...) -> None:
        ...
    def predict(self, model: CalibratedArc, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> None:
        ...
    def update(self, model: MarkerModel, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @property
    def covariance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 6]"]:
        """
        (n, n) float, a copy
        """
    @property
    def state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        (n,) float, a copy
        """
class Ukf5:
    """
    Ekf5's unscented counterpart.
    """
    def __init__(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 1]"], p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 5]"], unscented: Unscented = ...) -> None:
        ...
    def predict(self, model: ConstantVelocity, u: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], gamma: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[5, 1]"]) -> None:
        ...
    @typing.overload
    def update(self, model: MarkerModel, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @typing.overload
    def update(self, model: RelativePosition | WorldBearing | WallRange | PositionFix | HeadingFix | PoseFix, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @typing.overload
    def update(self, model: Speed | YawRate | WheelTravel, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @property
    def covariance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[5, 5]"]:
        """
        (n, n) float, a copy
        """
    @property
    def state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[5, 1]"]:
        """
        (n,) float, a copy
        """
class Ukf4:
    """
    The unscented filter of four states, none an angle; of an echo's parameters.
    """
    def __init__(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 1]"], p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 4]"], unscented: Unscented = ...) -> None:
        ...
    def update(self, model: EchoEnvelope, z: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], r: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], policy: Policy = ...) -> UpdateReport:
        """
        Measurement update. Nothing changes unless the report says accepted.
        """
    @property
    def covariance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 4]"]:
        """
        (n, n) float, a copy
        """
    @property
    def state(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 1]"]:
        """
        (n,) float, a copy
        """
class Run:
    """
    A recording that went through the engine, with all that came out.
    """
    def write_poses_csv(self, path: str) -> None:
        ...
    def write_poses_tum(self, path: str) -> None:
        """
        TUM trajectory: time [s] x y z qx qy qz qw.
        """
    def write_reports_csv(self, path: str) -> None:
        ...
    @property
    def counts(self) -> dict[str, typing.Any]:
        """
        messages that went in, and of measured components: samples = accepted + sum of rejected by reason.
        """
    @property
    def damage(self) -> list[str]:
        """
        Damaged places of the log file.
        """
    @property
    def inputs(self) -> list[dict[str, typing.Any]]:
        """
        Per input: name, channel, received, counts by verdict.
        """
    @property
    def messages(self) -> int:
        """
        Number of messages that went in.
        """
    @property
    def notices(self) -> list[str]:
        ...
    @property
    def poses(self) -> numpy.ndarray:
        """
        Structured array, one row a published pose: utime, x, y, heading, covariance (3, 3), v, omega, status, resets.
        """
    @property
    def published(self) -> Recording:
        """
        Recording of the published messages, if they were kept.
        """
    @property
    def reasons(self) -> list[str]:
        ...
    @property
    def reports(self) -> numpy.ndarray:
        """
        Structured array, one row a sighting with its newest revision: utime, sensor (into `sensors`), frame_seq, index, id, revision, innovation (3,), sigma (3,), nis, dof, weight, accepted, reason (into `reasons`), value, limit. Components are bearing [rad], elevation [rad], range [m].
        """
    @property
    def sensors(self) -> list[str]:
        ...
    @property
    def waiting_for(self) -> str:
        """
        What the localizer lacked to the end; empty if nothing.
        """
    @property
    def wall_s(self) -> float:
        """
        Time that the replay took [s].
        """
class Engine:
    """
    Bytes in, messages out, one message a call.
    """
    def __init__(self, config: Config) -> None:
        ...
    def handle(self, channel: str, received: typing.SupportsInt | typing.SupportsIndex, data: bytes) -> list[tuple[str, bytes]]:
        """
        Takes an encoded message with its time of arrival [us]; the (channel, data) to publish.
        """
    def restore(self, checkpoint: bytes) -> None:
        """
        Begins with a checkpoint's pose, as a hypothesis; before anything else. RuntimeError says why it cannot be used.
        """
    def tick(self, now: typing.SupportsInt | typing.SupportsIndex, drops: typing.SupportsInt | typing.SupportsIndex = 0) -> list[tuple[str, bytes]]:
        """
        Time passes [us]; the (channel, data) to publish.
        """
    @property
    def checkpoint(self) -> bytes | None:
        """
        The newest checkpoint that a tick made, as its file holds it.
        """
    @property
    def notices(self) -> list[str]:
        ...
    @property
    def tick_period(self) -> int:
        """
        As `tick` wants to be called [us].
        """
    @property
    def waiting_for(self) -> str:
        ...
class Localizer:
    """
    The localizer itself, without messages and channels.
    
    Takes whole recordings held as arrays, in one call, with the GIL released. The configuration's map and at
    least one sensor must be set; times are taken as they are (no time policy, no latency).
    """
    def __init__(self, config: Config) -> None:
        ...
    def run(self, motion_utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64], motion: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], gyro_utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64] = ..., gyro_rate: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., sighting_utime: typing.Annotated[numpy.typing.ArrayLike, numpy.int64] = ..., sighting_id: typing.Annotated[numpy.typing.ArrayLike, numpy.int32] = ..., sighting: typing.Annotated[numpy.typing.ArrayLike, numpy.float64] = ..., sensor: typing.SupportsInt | typing.SupportsIndex = 0) -> numpy.ndarray:
        """
        Feeds samples in the order of their times.
        
        Parameters
        ----------
        motion_utime : (n,) int, us, not decreasing
        motion : (n, 2) float, absolute ticks (left, right), or (v [m/s], omega [rad/s]) by `motion.source`
        gyro_utime, gyro_rate : (g,) int us and float [rad/s], mean since the previous sample
        sighting_utime, sighting_id : (k,) int us and marker ids
        sighting : (k, 3) float, bearing [rad], elevation [rad], range [m]; NaN where not measured
        sensor : number of the sensor in the configuration
        
        Returns
        -------
        Structured array like `Run.poses`, one row a motion sample.
        """
def associate_pixels(camera: CameraModel, mounting: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 1]"], pose: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], map: MarkerMap, pixels: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], radius_pixel: typing.SupportsFloat | typing.SupportsIndex, labels: typing.Annotated[numpy.typing.ArrayLike, numpy.int32] | None = None) -> numpy.typing.NDArray[numpy.int32]:
    """
    Which markers pixels are of: the one projected nearest, within a radius.
    
    Section 2 of Kiriy and Buehler 2002, where the radius is 64. Of two pixels at one marker the nearer has it.
    
    Parameters
    ----------
    camera : CameraModel
    mounting : (4,) float, the sensor's x, y, z [m] and yaw [rad] in the robot frame
    pose : (3,) float, x, y [m] and heading [rad] of the robot in frame map
    map : MarkerMap
    pixels : (n, 2) float
    radius_pixel : below which a projection is near
    labels : (n,) int, class of look-alike markers, -1 any
    
    Returns
    -------
    (n,) int32, ids of markers, -1 where there is none
    """
def load_config(path: str) -> Config:
    """
    Reads a configuration file and the map that it names; raises ConfigError naming file and line.
    """
def read_checkpoint(path: str) -> dict[str, typing.Any]:
    """
    Reads the file that `pilotage-node --checkpoint` keeps; RuntimeError if it is damaged.
    
    Returns
    -------
    utime, made : us, of the newest motion sample and of the checkpoint
    seq, version : count of checkpoints since the node's start, and the node's version
    ticks : (left, right) at utime
    state, covariance : (n,) and (n, n) float; x, y [m], heading [rad], and calibration if it is estimated
    """
def read_table(path: str, columns: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]) -> numpy.ndarray:
    """
    Columns (from 0) of a text table of numbers, as (rows, len(columns)) float.
    
    Separators are blanks, tabs and commas; empty lines and lines that begin with # or % are passed over.
    ValueError names file and line of a ragged row or of a word that is no number.
    """
def relative_position_noise(relative_m: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"], sigma_distance_per_m: typing.SupportsFloat | typing.SupportsIndex, sigma_bearing_rad: typing.SupportsFloat | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 2]"]:
    """
    R (2, 2) [m^2] of a RelativePosition, its axes along the line of sight and across it.
    
    Eqs. 13 to 16 of Sousa, Costa, Moreira and Carvalho, with eq. 15 transposed as it should be; relative_m
    (2,) is measured or predicted.
    """
@typing.overload
def replay(config: Config, recording: Recording, keep_messages: bool = False, progress: collections.abc.Callable[[float], None] | None = None) -> Run:
    """
    Feeds a recording to an engine, in the order and with the times in which its messages arrived.
    
    Parameters
    ----------
    config : Config
    recording : Recording, or the path of an LCM log file, which is then not held in memory
    keep_messages : keep what was published, as `Run.published`
    progress : called now and then with the part that is done, 0 to 1
    """
@typing.overload
def replay(config: Config, path: str, keep_messages: bool = False, progress: collections.abc.Callable[[float], None] | None = None) -> Run:
    ...
def unscented_transform(mean: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"], covariance: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"], f: collections.abc.Callable[[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]], typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]], unscented: Unscented = ...) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"], typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]]:
    """
    Mean and covariance of f(x), eqs. 14 to 17 of Tamas et al. 2008; none of its values an angle.
    
    Parameters
    ----------
    mean : (n,) float, n up to 6
    covariance : (n, n) float
    f : from (n,) float to (m,) float, m up to 6
    
    Returns
    -------
    mean : (m,) float
    covariance : (m, m) float
    """
__version__: str = '0.1.0'
