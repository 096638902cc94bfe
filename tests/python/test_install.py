"""What a machine may lack is brought, or named with the command that brings it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PREPARE = ROOT / "tools" / "prepare-machine"


def run(*command, **env):
    return subprocess.run(
        [str(word) for word in command],
        capture_output=True,
        text=True,
        env={**os.environ, **{key: str(value) for key, value in env.items()}},
    )


def script(path, text):
    path.unlink(missing_ok=True)  # a link would lead to the machine's own command
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)


class Machine:
    """A folder of commands that is all there is in PATH; tests take some away or break them."""

    def __init__(self, folder):
        self.folder = folder
        for name in ("sh", "env", "c++", "cat", "id"):
            self.add(name)
        self.python_without("nothing")

    def add(self, name):
        (self.folder / name).symlink_to(shutil.which(name))

    def remove(self, name):
        (self.folder / name).unlink()

    def python_without(self, *words):
        """Make python3 fail whenever one of `words` is in its arguments."""
        patterns = "|".join(f"*{word}*" for word in words)
        fault = f'case "$*" in {patterns}) exit 1 ;; esac'
        script(self.folder / "python3", f'{fault}\nexec "{sys.executable}" "$@"')

    def prepare(self, *arguments):
        return run(PREPARE, *arguments, PATH=self.folder, PYTHON="python3", CXX="")


@pytest.fixture
def machine(tmp_path):
    folder = tmp_path / "bin"
    folder.mkdir()
    return Machine(folder)


def test_a_machine_with_everything_passes_in_silence(machine):
    result = machine.prepare()
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")


@pytest.mark.parametrize(
    ("word", "what", "package"),
    [
        ("ensurepip", "Python's venv module", "python3-venv"),
        ("Python.h", "Python's headers", "python3-dev"),
        ("libglib", "GLib, which LCM needs", "libglib2.0-0"),
    ],
)
def test_what_python_lacks_is_named(machine, word, what, package):
    machine.python_without(word)
    result = machine.prepare()
    assert result.returncode == 1
    assert result.stderr == f"missing: {what}\ninstall it: sudo apt install {package}\n"


def test_a_missing_compiler_is_named(machine):
    machine.remove("c++")
    result = machine.prepare()
    assert result.returncode == 1
    assert result.stderr == "missing: a C++17 compiler\ninstall it: sudo apt install g++\n"


def test_a_missing_python_is_named(machine):
    machine.remove("python3")
    result = machine.prepare()
    assert result.returncode == 1
    assert result.stderr.startswith("missing: python3\ninstall it: sudo apt install python3 ")


def test_an_old_python_is_named(machine):
    machine.python_without("version_info")
    result = machine.prepare()
    assert result.returncode == 1
    assert result.stderr.startswith("missing: Python 3.10 or newer, python3 is Python 3.")


def test_all_that_is_missing_is_named_at_once(machine):
    machine.remove("c++")
    machine.python_without("ensurepip", "libglib")
    assert machine.prepare().stderr.splitlines() == [
        "missing: a C++17 compiler; Python's venv module; GLib, which LCM needs",
        "install it: sudo apt install g++ python3-venv libglib2.0-0",
    ]


def test_root_gets_it_from_apt(machine):
    machine.remove("c++")
    machine.add("ln")
    script(machine.folder / "id", "echo 0")
    compiler, here = shutil.which("c++"), machine.folder / "c++"
    install = f'case "$*" in *install*g++*) ln -s {compiler} {here} ;; esac'
    script(machine.folder / "apt-get", install)
    result = machine.prepare()
    assert result.returncode == 0
    assert result.stdout == "installing from apt: g++\n"


def test_a_user_whom_sudo_asks_for_a_password_gets_the_command(machine):
    machine.remove("c++")
    script(machine.folder / "id", "echo 1000")
    script(machine.folder / "apt-get", "exit 100")
    script(machine.folder / "sudo", 'echo "sudo: a password is required" >&2; exit 1')
    result = machine.prepare()
    assert result.returncode == 1
    assert result.stderr == "missing: a C++17 compiler\ninstall it: sudo apt install g++\n"


def test_make_stops_with_the_advice(machine, tmp_path):
    machine.remove("c++")
    for name in ("find", "sed", "tr", "nproc"):
        machine.add(name)
    make = shutil.which("make")
    venv = tmp_path / "venv"
    result = run(make, "-C", ROOT, "demo", f"VENV={venv}", PATH=machine.folder, CXX="")
    assert result.returncode != 0
    assert "sudo apt install g++" in result.stderr
    assert not venv.exists()


@pytest.fixture
def broken_glib(tmp_path):
    """Return a folder for LD_LIBRARY_PATH in which GLib cannot be loaded."""
    folder = tmp_path / "lib"
    folder.mkdir()
    (folder / "libglib-2.0.so.0").touch()
    return folder


@pytest.mark.parametrize("program", ["pilotage-node", "pilotage"])
def test_a_program_without_glib_says_so(broken_glib, program):
    result = run(Path(sys.executable).parent / program, "--version", LD_LIBRARY_PATH=broken_glib)
    assert result.returncode != 0
    assert "sudo apt install libglib2.0-0" in result.stderr


def configure(tmp_path, *options, **env):
    if not shutil.which("cmake"):
        pytest.skip("no cmake")
    build = tmp_path / "build"
    return run("cmake", "-S", ROOT, "-B", build, "-DPILOTAGE_BUILD_TESTS=OFF", *options, **env)


def test_cmake_says_how_to_install_what_it_can_neither_find_nor_fetch(tmp_path):
    nowhere = "http://127.0.0.1:9"
    result = configure(tmp_path, "-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON", https_proxy=nowhere)
    assert result.returncode != 0
    assert "Pilotage needs Eigen3" in result.stderr
    assert "pip install cmeel-eigen" in result.stderr


def test_cmake_says_when_lcm_gen_lacks_glib(tmp_path, broken_glib):
    result = configure(tmp_path, LD_LIBRARY_PATH=broken_glib)
    assert result.returncode != 0
    assert "sudo apt install libglib2.0-0" in result.stderr
