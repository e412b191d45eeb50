"""Which reading of its inputs and of the number itself gives what a paper prints."""
