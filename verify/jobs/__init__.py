"""The cache of results, the scheduler, and the processes that solve references."""
