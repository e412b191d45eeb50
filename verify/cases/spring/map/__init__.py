"""Case spring-map."""
