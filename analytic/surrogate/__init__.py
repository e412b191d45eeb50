"""Surrogates of a slow model on a box of parameters, and the search for their smallest value."""
