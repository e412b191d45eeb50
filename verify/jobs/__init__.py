"""The cache of results, the scheduler, and processes that solve."""
