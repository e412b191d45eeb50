"""Accordion springs: centre line and strip."""
