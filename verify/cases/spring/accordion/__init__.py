"""Case spring-accordion."""
