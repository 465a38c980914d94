package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;

/** Bodies that are connected by joints, directly or indirectly, and whose forces must be solved for together. */
final class Island {

    private final List<Body> bodies = new ArrayList<>();
    private final List<ConstraintJoint> joints = new ArrayList<>();
    private final List<Body> stack = new ArrayList<>();

    List<Body> bodies() {
        return bodies;
    }

    List<ConstraintJoint> joints() {
        return joints;
    }

    /** Collects and wakes all bodies and joints connected to a body, in ODE's order ({@code BuildIslands...}). */
    void collect(Body start) {
        clear();
        start.visited = true;
        stack.add(start);
        while (!stack.isEmpty()) {
            Body body = stack.remove(stack.size() - 1);
            body.islandIndex = bodies.size();
            bodies.add(body);
            for (int i = body.joints.size() - 1; i >= 0; i--) {
                visit(body.joints.get(i), body);
            }
        }
    }

    void integrate(double seconds) {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).integrate(seconds);
        }
    }

    void clear() {
        bodies.clear();
        joints.clear();
    }

    private void visit(ConstraintJoint joint, Body from) {
        if (joint.visited) {
            return;
        }
        joint.visited = true;
        joints.add(joint);
        Body other = joint.opposite(from);
        if (other != null && !other.visited) {
            other.visited = true;
            other.resume();
            stack.add(other);
        }
    }
}
