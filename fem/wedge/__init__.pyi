from fem.wedge.freewheel import FreewheelState, solve_freewheel

__all__ = ["FreewheelState", "solve_freewheel"]
