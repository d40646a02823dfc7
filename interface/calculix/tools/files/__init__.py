"""Readers and writers of the files of ccx, and of CSV."""
