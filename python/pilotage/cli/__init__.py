"""The command `pilotage`: each file parses, calls and prints; what it does stands elsewhere."""
