"""Case spring-stages."""
