"""Bodies wedged between two races: states at rest, and courses through states of growing load."""
