"""Roller freewheels."""
