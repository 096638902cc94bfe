import subprocess
import sys


def test_importing_evaluate_needs_neither_scipy_nor_matplotlib() -> None:
    code = "import pilotage.evaluate, sys; print({'scipy', 'matplotlib'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"
