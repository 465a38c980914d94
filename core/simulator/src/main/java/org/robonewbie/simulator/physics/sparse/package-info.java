/**
 * Rigid body engine that solves the equations of ODE's exact step in time proportional to the number of joints.
 *
 * <p><b>Equations.</b> A step of length h computes the velocities after the step. Each joint constrains them, row by row:
 * {@code J v = c - C λ}, where J is the Jacobian of the row, c its target speed (for example a fraction of the joint error per
 * step), λ the constraint force and C its softness (ODE's constraint force mixing, CFM). Forces change velocities according to
 * Newton's law, {@code v = v0 + h M⁻¹ (f + Jᵀ λ)}. Together, these equations form a linear system for the forces,
 *
 * <pre>{@code (J M⁻¹ Jᵀ + C / h) λ = c / h - J (v0 / h + M⁻¹ f)      A λ = b}</pre>
 *
 * <p>with one condition: the force of a motor, a stop or a contact is bounded, and at a bound its row need not be satisfied.
 * That makes it a linear complementarity problem (LCP).
 *
 * <p><b>Difference from ODE.</b> ODE builds the dense matrix A and pivots in it row by row (Dantzig), in cubic time. But two
 * joints have a common block in A only if they share a body, and the bodies of a robot form a tree. A Cholesky factorization
 * that eliminates joints from hands and feet towards the torso therefore has no fill-in. Block principal pivoting repeats it with
 * different sets of rows until every row is satisfied or at a bound, which takes one or two iterations.
 *
 * <p>Read {@link org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld} first, then {@code IslandSolver}, {@code
 * ConstraintRows}, {@code SymbolicFactorization}, {@code BlockCholesky} and {@code BlockPivotingLcpSolver}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.physics.sparse;
