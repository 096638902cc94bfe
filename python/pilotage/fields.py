"""From the text of a YAML file to values of dataclasses and functions, without silent typos."""

import inspect
import math
from collections.abc import Callable, Iterable
from difflib import get_close_matches
from pathlib import Path
from types import NoneType
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

import yaml

T = TypeVar("T")


class _Loader(yaml.SafeLoader):  # type: ignore[misc]
    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Any, Any]:
        keys = [key.value for key, _ in node.value if isinstance(key, yaml.ScalarNode)]
        for key in keys:
            if keys.count(key) > 1:
                line = node.start_mark.line + 1
                raise yaml.YAMLError(f"line {line}: the key '{key}' stands there twice")
        return dict(super().construct_mapping(node, deep))


def read_yaml(path: Path) -> Any:
    """Read a file; a ValueError names it, and the line that is no YAML or repeats a key."""
    try:
        return yaml.load(path.read_text(encoding="utf-8"), _Loader)
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise ValueError(f"{path}: {' '.join(str(error).split())}") from error


def mapping(content: Any, where: str) -> dict[str, Any]:
    """Return the content if it is a mapping with names for keys."""
    if not isinstance(content, dict) or not all(isinstance(key, str) for key in content):
        raise ValueError(f"{where} is {content!r}, expected keys with values")
    return content


def known_keys(content: dict[str, Any], known: Iterable[str], where: str) -> None:
    """Raise a ValueError that names the nearest known key if there is another."""
    known = list(known)
    for key in content:
        if key not in known:
            (near,) = get_close_matches(key, known, n=1, cutoff=0.0)
            raise ValueError(f"{where}: unknown key '{key}'; the nearest known key is '{near}'")


def call(function: Callable[..., T], content: Any, where: str, **given: Any) -> T:
    """Call a function, or make a dataclass, with arguments by the content's keys.

    Values are held against the annotations; what is missing, unknown or of another kind is a
    ValueError with its place, `where`. Arguments `given` do not come from the file.
    """
    content = mapping(content, where)
    parameters = inspect.signature(function).parameters
    known_keys(content, [name for name in parameters if name not in given], where)
    kinds = get_type_hints(function.__init__ if inspect.isclass(function) else function)
    arguments = {key: value_of(kinds[key], v, f"{where}.{key}") for key, v in content.items()}
    for name, parameter in parameters.items():
        if parameter.default is parameter.empty and name not in arguments and name not in given:
            raise ValueError(f"{where}: '{name}' is missing")
    try:
        return function(**arguments, **given)
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from error


def value_of(kind: Any, value: Any, where: str) -> Any:
    """Return the value as the kind that an annotation says."""
    inner = get_args(kind)
    if NoneType in inner:
        return None if value is None else value_of(inner[0], value, where)
    if kind is float:
        return _number(value, where)
    if kind in (bool, str):
        if isinstance(value, kind):
            return value
        expected = "true or false" if kind is bool else "a word"
        raise ValueError(f"{where} is {value!r}, expected {expected}")
    if not isinstance(value, list):
        raise ValueError(f"{where} is {value!r}, expected a list")
    if get_origin(kind) is tuple and inner[-1] is not Ellipsis and len(value) != len(inner):
        raise ValueError(f"{where} is {value!r}, expected {len(inner)} values")
    return get_origin(kind)(value_of(inner[0], v, f"{where}[{i}]") for i, v in enumerate(value))


def within(name: str, value: float, low: float, high: float = math.inf) -> None:
    """Raise a ValueError that names the value unless it is a number from `low` to `high`."""
    if not low <= value <= high:
        wanted = f"{low:g} or more" if high == math.inf else f"{low:g} to {high:g}"
        raise ValueError(f"{name} is {value:g}, expected {wanted}")


def ascending(name: str, span: tuple[float, float], low: float = -math.inf) -> None:
    """Raise a ValueError that names the span unless it is from low or more, and then to more."""
    if not low <= span[0] <= span[1]:
        order = "from <= to" if low == -math.inf else f"{low:g} <= from <= to"
        raise ValueError(f"{name} is [{span[0]:g}, {span[1]:g}], expected {order}")


def _number(value: Any, where: str) -> float:
    # YAML takes 1e-3, without a point, for a word.
    if isinstance(value, (int, float, str)) and not isinstance(value, bool):
        try:
            number = float(value)
        except ValueError:
            number = math.nan
        if math.isfinite(number):
            return number
    raise ValueError(f"{where} is {value!r}, expected a number")
