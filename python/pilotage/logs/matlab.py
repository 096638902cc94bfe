"""Variables of a MATLAB file of version 5 to 7, which is what `save` writes unless told otherwise.

The MathWorks, "MAT-File Format". Read here because scipy's reader takes the whole process down on
some damaged files.
"""

import struct
import zlib
from collections.abc import Iterable, Iterator
from math import prod
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

_Numbers = NDArray[np.float64]

_HEADER = 128
_MATRIX, _COMPRESSED = 14, 15
_TYPES = {
    1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8",
}  # fmt: skip
_NUMERIC = range(6, 16)  # classes of arrays: double to uint64
_COMPLEX = 0x800


def is_matlab(path: Path) -> bool:
    """Whether the file's name says that it is a MATLAB file."""
    return path.suffix.lower() == ".mat" and path.is_file()


def variable_names(path: Path) -> set[str]:
    """Names of the variables of a MATLAB file; ValueError if it is none."""
    return set(_variables(path))


def load_variables(path: Path, names: Iterable[str]) -> dict[str, _Numbers]:
    """The named variables as two-dimensional arrays; ValueError names those that are missing."""
    names = list(names)
    found = _variables(path)
    missing = [name for name in names if name not in found]
    if missing:
        there = ", ".join(sorted(found))
        raise ValueError(f"{path}: lacks the variables {', '.join(missing)}; it has {there}")
    loaded = {}
    for name in names:
        variable = found[name]
        if variable is None:
            raise ValueError(f"{path}: variable {name} is no matrix of real numbers")
        loaded[name] = variable
    return loaded


def _variables(path: Path) -> dict[str, _Numbers | None]:
    """Every variable by its name; None for what is no matrix of real numbers."""
    content = path.read_bytes()
    order = {b"\x00\x01IM": "<", b"\x01\x00MI": ">"}.get(content[_HEADER - 4 : _HEADER])
    if order is None:
        raise ValueError(
            f"{path}: cannot be read as a MATLAB file of version 5 to 7 (`save -v7` writes one)"
        )
    try:
        return dict(_matrix(body, order) for body in _matrices(content[_HEADER:], order))
    except (ValueError, zlib.error) as error:
        raise ValueError(f"{path}: cannot be read as a MATLAB file: {error}") from error


def _matrices(content: bytes, order: str) -> Iterator[bytes]:
    for kind, body in _elements(content, order):
        inside = _elements(zlib.decompress(body), order) if kind == _COMPRESSED else [(kind, body)]
        yield from (body for kind, body in inside if kind == _MATRIX)


def _elements(content: bytes, order: str) -> Iterator[tuple[int, bytes]]:
    """The elements that stand one after the other: a number that says the kind, and the bytes."""
    at = 0
    while at < len(content):
        if at + 8 > len(content):
            raise ValueError("it ends in the middle")
        kind, size = struct.unpack_from(order + "II", content, at)
        begin = at + 8
        if kind >> 16:  # kind and size share a word, and the bytes come in the next
            kind, size, begin = kind & 0xFFFF, kind >> 16, at + 4
        end = begin + size
        if end > len(content):
            raise ValueError("it ends in the middle")
        yield kind, content[begin:end]
        at = end if kind == _COMPRESSED else end + -end % 8


def _matrix(body: bytes, order: str) -> tuple[str, _Numbers | None]:
    """Name and numbers of a variable; None where they are not real or have not two dimensions."""
    parts = _elements(body, order)
    try:
        (_, flags), (_, dimensions), (_, name) = next(parts), next(parts), next(parts)
        (flag,) = struct.unpack_from(order + "I", flags)
    except (StopIteration, struct.error):
        raise ValueError("a variable lacks its name") from None
    called = name.decode("ascii", "backslashreplace")
    shape = tuple(np.frombuffer(dimensions, order + "i4").tolist())
    if flag & 0xFF not in _NUMERIC or flag & _COMPLEX or len(shape) != 2:
        return called, None
    kind, real = next(parts, (9, b""))
    if kind not in _TYPES:
        raise ValueError(f"variable {called} is of a type that is not known")
    numbers = np.frombuffer(real, order + _TYPES[kind]).astype(np.float64)
    if min(shape) < 0 or numbers.size != prod(shape):
        raise ValueError(f"variable {called} has not as many numbers as it says")
    return called, numbers.reshape(shape, order="F")
