"""`pilotage study`: the published systems, rerun."""

from pathlib import Path
from typing import Annotated

import typer

app = typer.Typer(help="Rerun a published system.", no_args_is_help=True)


@app.command("kiriy-listing")
def kiriy_listing(
    log: Annotated[
        Path, typer.Option("--log", help="Folder with the paper's poselog, angles and map files.")
    ],
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for the results.")],
) -> None:
    """Reproduce the numbers of the first paper's printed program, step for step.

    Writes states.csv (x, y, heading before each row's step) and final_covariance.csv, 17 digits.

    Example: pilotage study kiriy-listing --log mower-listing -o out
    """
    from ..logs.mower import read_triple
    from ..studies import kiriy_listing as study

    listing = study.run(read_triple(log))
    listing.save(output)
    typer.echo(f"{output}/states.csv: {len(listing.states)} rows; {output}/final_covariance.csv")
