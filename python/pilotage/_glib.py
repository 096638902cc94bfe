"""The one library that no wheel carries: GLib, which LCM needs."""

from __future__ import annotations


def explain(error: Exception) -> str:
    """Say what to install when loading a library failed for want of GLib.

    Parameters
    ----------
    error
        The ImportError of a module or the OSError of a library.

    Returns
    -------
    The error's own text, with the way out where GLib is what is missing.
    """
    if "libglib" not in str(error):
        return str(error)
    return (
        f"GLib, which LCM needs, is missing ({error}).\nInstall it: sudo apt install libglib2.0-0"
    )
