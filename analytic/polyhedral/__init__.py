"""The polyhedral ring clutch."""
