/**
 * Our own world step: the equations of ODE's exact step, solved in time proportional to the number of joints.
 *
 * <p><b>The equations.</b> A step of length h computes the velocities after the step. Every joint constrains them, row by row:
 * {@code J v = c - C λ}, where J is the row's Jacobian, c the speed that it demands (such as a share of a gap that has to
 * close), λ the force that the row exerts and C the softness with which it yields (ODE's CFM). Forces change velocities by
 * Newton's law, {@code v = v0 + h M⁻¹ (f + Jᵀ λ)}. Together this is one linear system for the forces,
 *
 * <pre>{@code (J M⁻¹ Jᵀ + C / h) λ = c / h - J (v0 / h + M⁻¹ f)      A λ = b}</pre>
 *
 * <p>with one condition: a motor, a stop or a contact exerts only a force between two limits, and at a limit its row need not
 * hold. That makes it a linear complementarity problem.
 *
 * <p><b>What differs from ODE.</b> ODE fills the whole matrix A and pivots in it row by row, which takes time with the cube of
 * its size. But two joints have a common entry in A only where they share a body, and a robot's bodies shape a tree: a Cholesky
 * factorisation that goes from fingertips and toes to the torso causes no fill-in. The same factorisation is simply repeated,
 * with some rows left out, until every row is either satisfied or at its limit. That takes one or two rounds.
 *
 * <p>Read {@link org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld} first, then {@code IslandSolver}, {@code
 * ConstraintRows}, {@code SymbolicFactorization}, {@code BlockCholesky} and {@code BlockPivotingLcpSolver}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.physics.sparse;
