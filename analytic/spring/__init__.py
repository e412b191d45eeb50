"""Accordion springs of roller clutches."""
