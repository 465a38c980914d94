package org.robonewbie.simulator.physics.sparse;

import java.util.List;

/** Finds the forces on one island at a time; keeps the arrays for it from step to step. */
final class IslandSolver {

    private final ConstraintRows rows = new ConstraintRows();
    private final BlockPivotingLcpSolver solver = new BlockPivotingLcpSolver(rows);
    private final SymbolicFactorizationCache factorizations = new SymbolicFactorizationCache();

    /**
     * Finds all forces on the bodies, and the accelerations that come from them.
     *
     * @param island the bodies and all joints between them
     * @param seconds length of the step
     */
    void solve(Island island, double seconds) {
        List<Body> bodies = island.bodies();
        List<ConstraintJoint> joints = island.joints();
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).addOwnForces(seconds);
            bodies.get(i).clearAcceleration();
        }
        if (!joints.isEmpty()) {
            findForces(bodies, joints, seconds);
        }
    }

    private void findForces(List<Body> bodies, List<ConstraintJoint> joints, double seconds) {
        double rate = 1 / seconds;
        SymbolicFactorization factorization = factorizations.get(joints, bodies.size());
        rows.reset(factorization.rows(), factorization.joints(), PhysicsConstants.SOFTNESS);
        for (int k = 0; k < factorization.joints(); k++) {
            ConstraintJoint joint = joints.get(factorization.order[k]);
            joint.firstRow = factorization.firstRow[k];
            rows.hinge[k] = joint.hinge;
            joint.writeRows(rows, rate);
        }
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).prepare(seconds);
        }
        for (int i = 0; i < joints.size(); i++) {
            rows.prepare(joints.get(i), rate);
        }
        solver.solve(factorization, joints, bodies);
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).readForces(rows);
        }
    }
}
