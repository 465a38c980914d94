package org.robonewbie.simulator.physics.sparse;

import java.util.List;

/** Solves for the constraint forces of one island at a time, reusing its arrays. */
final class IslandSolver {

    private final ConstraintRows rows = new ConstraintRows();
    private final BlockPivotingLcpSolver solver = new BlockPivotingLcpSolver(rows);
    private final SymbolicFactorizationCache factorizations = new SymbolicFactorizationCache();

    /** Computes all forces on the bodies of an island and the resulting accelerations. */
    void solve(Island island, double seconds) {
        List<Body> bodies = island.bodies();
        List<ConstraintJoint> joints = island.joints();
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).addGravityAndGyroscopicTorque(seconds);
            bodies.get(i).clearAcceleration();
        }
        if (!joints.isEmpty()) {
            solveConstraints(bodies, joints, seconds);
        }
    }

    private void solveConstraints(List<Body> bodies, List<ConstraintJoint> joints, double seconds) {
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
