"""The published systems behind this project, one file a study."""
