"""From a camera's images to sightings of markers. Needs OpenCV: the extra ``camera``."""
