"""Writing of the results of a verification run: pages, figures and tables."""
