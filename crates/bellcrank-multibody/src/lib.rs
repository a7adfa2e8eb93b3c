//! Topology, kinematics and inverse dynamics of closed-loop mechanisms.
