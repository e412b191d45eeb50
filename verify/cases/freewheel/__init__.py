"""Cases of the subject freewheel."""
