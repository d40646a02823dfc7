"""Elasto-plastic contact of rough timber faces. Units are N, mm and MPa throughout."""
