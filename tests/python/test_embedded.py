"""The core on a microcontroller: the example runs here, and cross-compiles where it can."""

import shutil
import subprocess
import sysconfig
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "embedded"


def _build(folder: Path, *options: str) -> Path:
    configure = ["cmake", "-S", str(EXAMPLE), "-B", str(folder), f"-DEIGEN={_eigen()}", *options]
    subprocess.run(configure, check=True, capture_output=True)
    subprocess.run(["cmake", "--build", str(folder)], check=True, capture_output=True)
    return folder / "pilotage_embedded"


def _eigen() -> Path:
    """The headers of the cmeel-eigen wheel that the core was built with, or the system's."""
    installed = Path(sysconfig.get_path("platlib"), "cmeel.prefix", "include", "eigen3")
    places = [installed, Path("/usr/include/eigen3")]
    for place in places:
        if (place / "Eigen" / "Core").exists():
            return place
    pytest.skip(f"Eigen's headers are in none of {', '.join(map(str, places))}")


def test_the_example_localizes_in_single_precision(tmp_path: Path):
    program = _build(tmp_path)
    subprocess.run([str(program)], check=True)


@pytest.mark.skipif(
    shutil.which("arm-none-eabi-g++") is None,
    reason="gcc-arm-none-eabi and libstdc++-arm-none-eabi-newlib are not installed",
)
def test_the_example_fits_a_cortex_m7(tmp_path: Path):
    program = _build(tmp_path, f"-DCMAKE_TOOLCHAIN_FILE={EXAMPLE / 'cortex-m7.cmake'}")
    size = subprocess.run(
        ["arm-none-eabi-size", str(program)], check=True, capture_output=True, text=True
    )
    text, data, bss = (int(word) for word in size.stdout.splitlines()[1].split()[:3])
    assert text < 160 * 1024, "flash; the documented size has grown"
    assert data + bss < 1024, "static memory; the history is on the heap, made once"
