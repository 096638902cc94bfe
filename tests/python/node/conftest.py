"""Tests of the node run again in a private network, where their multicast reaches nobody else."""

import os
import subprocess
import sys

import pytest

from pilotage import multicast

INSIDE = "PILOTAGE_TEST_NETWORK"


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem):
    """Run the test in a process inside the private network, and take over its verdict."""
    if os.environ.get(INSIDE) or "outside" in pyfuncitem.keywords:
        return None
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", pyfuncitem.nodeid]
    inside = multicast.private_network(command)
    if inside is None:
        pytest.skip("no private network here: needs unshare, ip and user namespaces")
    result = subprocess.run(
        inside,
        env={**os.environ, INSIDE: "1"},
        cwd=pyfuncitem.config.rootpath,
        capture_output=True,
        text=True,
        timeout=240,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return True
