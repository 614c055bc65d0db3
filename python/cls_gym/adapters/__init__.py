"""Environments in the forms of other frameworks, one module each, which imports its framework alone.

docs/training.md has the table: which module is for which framework, and what it cannot do.
"""
