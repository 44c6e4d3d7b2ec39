"""Scenes in notebooks: a widget that is turned, cut open and picked in, in the page and in Python alike (`docs/notebooks.md`).

It needs the extra `notebook` of this package.
"""

from ._widget import View

__all__ = ["View"]
