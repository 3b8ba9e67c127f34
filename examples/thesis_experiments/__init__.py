# SPDX-License-Identifier: GPL-3.0-or-later
"""The experiments of the thesis, and what is needed to run them and to write about them."""
