"""Values of inputs that a parameter file leaves out, each with its source."""
