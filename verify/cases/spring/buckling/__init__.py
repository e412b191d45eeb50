"""Case spring-buckling."""
