"""A program that says in a line, not in a traceback, what a user can mend."""

import sys

import typer


def run(app: typer.Typer, program: str) -> None:
    """Run a program's command line; an error that a user can mend exits with 2."""
    try:
        app(prog_name=program)
    except (ValueError, KeyError, OSError, RuntimeError, ImportError) as error:
        print(f"{program}: {_in_words(error)}", file=sys.stderr)
        sys.exit(2)


def _in_words(error: Exception) -> str:
    if isinstance(error, KeyError):
        return str(error.args[0])  # its own text is in quotes
    if isinstance(error, OSError) and error.filename is not None:
        return f"{error.filename}: {error.strerror}"
    return str(error)
