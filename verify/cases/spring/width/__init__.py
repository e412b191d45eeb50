"""Case spring-width."""
