"""Beams and frames on a line mesh."""
