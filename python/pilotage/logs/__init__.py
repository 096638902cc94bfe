"""Readers of recordings: each public format, by its original files, becomes a `Log`.

`read` recognises the format. A reader knows one format, converts it to this package's messages and
conventions, and adds nothing: what it cannot convert it leaves out and says so in `Log.notes`.
Sensor models, noise and lags belong to the configuration, not to the reader.
"""

from .log import Log, without_ids, write_lcmlog
from .reading import read

__all__ = ["Log", "read", "without_ids", "write_lcmlog"]
