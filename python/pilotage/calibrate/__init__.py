"""Cameras calibrated: the lens from pictures of a board, the mounting from a drive past markers."""
