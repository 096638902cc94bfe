"""Whether LCM's multicast can work here, and a private network where it does."""

import os
import shutil
import socket
import struct
import subprocess
import sys
from collections.abc import Sequence

GROUP, PORT = "239.255.76.67", 7667  # LCM's defaults
ADVICE = (
    "there is no route for multicast, which LCM needs; on one machine:\n"
    "  sudo ip link set lo multicast on\n"
    "  sudo ip route add 224.0.0.0/4 dev lo"
)

_ENTERED = "PILOTAGE_IN_PRIVATE_NETWORK"
_SET_UP = (
    "ip link set lo up && ip link set lo multicast on && "
    'ip route add 224.0.0.0/4 dev lo && exec "$@"'
)


def available() -> bool:
    """Whether this machine can join LCM's group and send to it."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        membership = struct.pack("4sl", socket.inet_aton(GROUP), socket.INADDR_ANY)
        try:
            probe.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
            probe.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
            probe.sendto(b"", (GROUP, PORT + 1))  # nobody listens there
        except OSError:
            return False
    return True


def private_network(command: Sequence[str]) -> list[str] | None:
    """Return the command that runs `command` in a network of its own with multicast, if possible.

    Needs unshare (util-linux), ip (iproute2) and a kernel that lets users make namespaces.
    """
    if shutil.which("unshare") is None or shutil.which("ip") is None:
        return None
    wrapped = ["unshare", "-rn", "sh", "-c", _SET_UP, "sh"]
    works = subprocess.run([*wrapped, "true"], capture_output=True, check=False).returncode == 0
    return [*wrapped, *command] if works else None


def rerun_in_private_network() -> int | None:
    """Run this very command again in a network of its own; its exit status, None if impossible."""
    if os.environ.get(_ENTERED):
        return None
    command = private_network([sys.executable, *sys.orig_argv[1:]])
    if command is None:
        return None
    return subprocess.run(command, check=False, env={**os.environ, _ENTERED: "1"}).returncode
