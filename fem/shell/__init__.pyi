from fem.shell.solution import ShellSolution
from fem.shell.solve import solve_shell

__all__ = ["ShellSolution", "solve_shell"]
