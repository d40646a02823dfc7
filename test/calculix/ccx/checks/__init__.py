"""Checks of CalculiX with UINTER, by subject."""
