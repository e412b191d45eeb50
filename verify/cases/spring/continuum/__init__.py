"""Case spring-continuum."""
