"""An independent program for the reference numbers: mechanism analysis in absolute coordinates.

It shares nothing with bellcrank but the model file. Every body has its own pose (planar x, y, angle;
spatial place and unit quaternion) and every joint coordinate is an unknown of its own, so the equations
are "pose of the second point = pose of the first point, moved by the joint" and nothing is eliminated.

  position       Gauss-Newton with a complex-step Jacobian (exact to rounding)
  velocity,      the same equations in truncated Taylor series of time: order 1 and order 2 follow
  acceleration   from the order-0 Jacobian, with no formula for a velocity or a Coriolis term
  forces         each body taken free (Newton, Euler); unknowns are the whole wrench of each joint at
                 the second point and the drive efforts; conditions S'W = effort for each coordinate
  uniqueness     a component is unique when it vanishes on the null space of that linear system

Needs numpy.  python3 -m maximal MODEL STUDY  prints the first and last row.
"""
from .series import quaternion_matrix, skew
from .studies import Model, load
