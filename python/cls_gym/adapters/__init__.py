"""Environments in the forms of other frameworks, a module each that imports its framework alone.

docs/training.md has the table: which module is for which framework, and what it cannot do.
"""
