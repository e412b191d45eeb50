"""Case spring-curve."""
