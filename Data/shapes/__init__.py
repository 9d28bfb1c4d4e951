"""Shapes that carry their map: every generator returns points, cells and where the map sends each point."""
