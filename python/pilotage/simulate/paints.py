"""Colours of what is painted or printed, as a camera sees them in fair light."""

Colour = tuple[float, float, float]
"""Blue, green, red, 0 to 255, as OpenCV has them."""

PAINTS: dict[str, Colour] = {
    "red": (40.0, 35.0, 205.0),
    "orange": (30.0, 120.0, 235.0),
    "yellow": (35.0, 205.0, 235.0),
    "green": (70.0, 150.0, 40.0),
    "cyan": (210.0, 190.0, 40.0),
    "blue": (185.0, 70.0, 25.0),
    "magenta": (165.0, 40.0, 190.0),
    "white": (235.0, 235.0, 235.0),
    "grey": (128.0, 128.0, 128.0),
    "black": (25.0, 25.0, 25.0),
}
"""By the name that a scenario file calls them."""


def paint(name: str) -> Colour:
    """Return a colour by its name; a ValueError lists the names."""
    if name not in PAINTS:
        raise ValueError(f"colour is {name!r}, expected one of {', '.join(PAINTS)}")
    return PAINTS[name]
