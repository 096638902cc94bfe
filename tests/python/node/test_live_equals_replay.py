"""A live run and the replay of what was recorded of it give the same bytes."""
