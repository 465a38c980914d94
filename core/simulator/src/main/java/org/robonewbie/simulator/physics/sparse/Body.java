package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.MassDistribution;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/**
 * A rigid body: Newton and Euler for one lump of matter.
 *
 * <p>Arrays hold x, y, z; arrays of six hold a linear part and then an angular part, all along the world's axes.
 */
final class Body implements RigidBody, Restorable {

    /** Stands where no body is known yet. */
    static final Body NONE =
            new Body(new MassDistribution(1, new Vector3(1, 1, 1)), Vector3.ZERO, new UpdateSequence());

    private static final double GRAVITY = -9.81;
    private static final double RESTING_SPEED_SQUARED = 0.01 * 0.01;
    private static final int STEPS_TO_FALL_ASLEEP = 10;

    double inverseMass;
    /** Rotation from the body's axes to the world's, row by row. */
    final double[] rotation = Rotations.identity();
    /** The inverse of the inertia about the world's axes, row by row; as of the last {@link #prepare}. */
    final double[] inverseInertia = new double[9];
    /** Linear and angular velocity. */
    final double[] velocity = new double[6];
    /** Force and torque of this step, constraints not counted. */
    final double[] force = new double[6];
    /** The velocity that the step would give without constraints, per second of the step: v/h + M⁻¹f. */
    final double[] unconstrained = new double[6];
    /** What the constraints' forces add: M⁻¹ Jᵀ λ. */
    final double[] acceleration = new double[6];
    /** Joints that hold on to this body, hinges first, then the contacts of this step. */
    final List<ConstraintJoint> joints = new ArrayList<>();
    /** Number of this body in its island, while the island is stepped. */
    int islandIndex;
    /** Whether this step has put the body in an island already. */
    boolean visited;

    private final MassDistribution usual;
    private double mass;
    private final double[] inertia = new double[3];
    private final boolean evenlyHeavy;
    private final double[] position = new double[3];
    /** The position as it was asked for last, since it is asked for several times per step. */
    private Vector3 seenPosition = Vector3.ZERO;

    private boolean hasMoved = true;
    /** The velocity as it was asked for last. */
    private Vector3 seenVelocity = Vector3.ZERO;

    private final double[] quaternion = {1, 0, 0, 0};
    private final UpdateSequence order;
    private final List<CollisionShape> shapes = new ArrayList<>();
    private boolean asleep;
    private int turns;
    private int restingStepsLeft = STEPS_TO_FALL_ASLEEP;

    Body(MassDistribution distribution, Vector3 position, UpdateSequence order) {
        this.order = order;
        usual = distribution;
        setMassFactor(1);
        Vector3 moments = distribution.inertia();
        evenlyHeavy = moments.x() == moments.y() && moments.y() == moments.z();
        set(this.position, position);
    }

    @Override
    public void setMassFactor(double factor) {
        mass = factor * usual.massKg();
        inverseMass = 1 / mass;
        set(inertia, usual.inertia().times(factor));
    }

    double[] place() {
        return position;
    }

    double[] orientation() {
        return quaternion;
    }

    /** A counter of the body's rotations, which shows whether a value derived from its orientation is still valid. */
    int turns() {
        return turns;
    }

    void attach(CollisionShape shape) {
        shapes.add(shape);
        shape.moved(order);
    }

    void removeContacts() {
        while (!joints.isEmpty() && joints.get(joints.size() - 1) instanceof ContactJoint) {
            joints.remove(joints.size() - 1);
        }
    }

    /** Marks body and joints as belonging to no island yet. */
    void unvisit() {
        visited = false;
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).visited = false;
        }
    }

    /** Counts the steps at rest and puts the body to sleep after ten, like ODE's auto-disable. */
    void watchRest() {
        if (asleep || joints.isEmpty()) {
            return;
        }
        restingStepsLeft = isResting() ? restingStepsLeft - 1 : STEPS_TO_FALL_ASLEEP;
        if (restingStepsLeft <= 0) {
            asleep = true;
            Arrays.fill(velocity, 0);
        }
    }

    /** Takes part in the step because something awake is joined to it; its count of steps at rest continues. */
    void stir() {
        asleep = false;
    }

    private boolean isResting() {
        return Rotations.dot(velocity, 0, velocity, 0) <= RESTING_SPEED_SQUARED
                && Rotations.dot(velocity, 3, velocity, 3) <= RESTING_SPEED_SQUARED;
    }

    /** Adds weight and gyroscopic torque, and turns the inertia to the world's axes. */
    void addOwnForces(double seconds) {
        force[2] += mass * GRAVITY;
        Rotations.turnedDiagonal(rotation, 1 / inertia[0], 1 / inertia[1], 1 / inertia[2], inverseInertia);
        if (!evenlyHeavy) {
            Gyroscope.addTorque(rotation, inertia, velocity, seconds, force);
        }
    }

    /** Computes what the step would do without constraints; to be called when all forces are known. */
    void prepare(double seconds) {
        double rate = 1 / seconds;
        for (int axis = 0; axis < 3; axis++) {
            unconstrained[axis] = force[axis] * inverseMass + velocity[axis] * rate;
            unconstrained[3 + axis] = Rotations.dot(inverseInertia, 3 * axis, force, 3) + velocity[3 + axis] * rate;
        }
    }

    void clearAcceleration() {
        Arrays.fill(acceleration, 0);
    }

    /** Moves the body: first the velocities, then with them place and orientation (semi-implicit Euler, as ODE). */
    void move(double seconds) {
        for (int axis = 0; axis < 3; axis++) {
            velocity[axis] += seconds * (acceleration[axis] + force[axis] * inverseMass);
            velocity[3 + axis] +=
                    seconds * (acceleration[3 + axis] + Rotations.dot(inverseInertia, 3 * axis, force, 3));
        }
        for (int axis = 0; axis < 3; axis++) {
            position[axis] += seconds * velocity[axis];
        }
        hasMoved = true;
        Rotations.rotate(quaternion, velocity, seconds);
        Rotations.toMatrix(quaternion, rotation);
        turns++;
        Arrays.fill(force, 0);
        tellForms();
    }

    private void tellForms() {
        for (int i = 0; i < shapes.size(); i++) {
            shapes.get(i).moved(order);
        }
    }

    @Override
    public Vector3 position() {
        if (hasMoved) {
            seenPosition = new Vector3(position[0], position[1], position[2]);
            hasMoved = false;
        }
        return seenPosition;
    }

    @Override
    public RotationMatrix rotation() {
        double[] r = rotation;
        return new RotationMatrix(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
    }

    @Override
    public Vector3 axisY() {
        return new Vector3(rotation[1], rotation[4], rotation[7]);
    }

    @Override
    public double upwards() {
        return rotation[8];
    }

    @Override
    public Vector3 directionToLocal(double x, double y, double z) {
        double[] r = rotation;
        return new Vector3(
                r[0] * x + r[3] * y + r[6] * z, r[1] * x + r[4] * y + r[7] * z, r[2] * x + r[5] * y + r[8] * z);
    }

    @Override
    public Vector3 ownAngularVelocity() {
        return directionToLocal(velocity[3], velocity[4], velocity[5]);
    }

    @Override
    public boolean isWithin(double metres) {
        return Math.abs(position[0]) < metres && Math.abs(position[1]) < metres && Math.abs(position[2]) < metres;
    }

    @Override
    public Vector3 velocity() {
        if (!isVelocity(seenVelocity)) {
            seenVelocity = new Vector3(velocity[0], velocity[1], velocity[2]);
        }
        return seenVelocity;
    }

    /** Compares bit by bit, so that 0 and -0 differ. */
    private boolean isVelocity(Vector3 vector) {
        return Double.compare(vector.x(), velocity[0]) == 0
                && Double.compare(vector.y(), velocity[1]) == 0
                && Double.compare(vector.z(), velocity[2]) == 0;
    }

    @Override
    public Vector3 angularVelocity() {
        return new Vector3(velocity[3], velocity[4], velocity[5]);
    }

    @Override
    public void setPosition(Vector3 place) {
        set(position, place);
        hasMoved = true;
        tellForms();
    }

    @Override
    public void setRotation(RotationMatrix turn) {
        Rotations.copy(turn, rotation);
        Rotations.toQuaternion(rotation, quaternion);
        Rotations.straighten(rotation);
        turns++;
        tellForms();
    }

    @Override
    public void setVelocity(Vector3 metresPerSecond) {
        set(velocity, metresPerSecond);
    }

    @Override
    public void setAngularVelocity(Vector3 radiansPerSecond) {
        velocity[3] = radiansPerSecond.x();
        velocity[4] = radiansPerSecond.y();
        velocity[5] = radiansPerSecond.z();
    }

    @Override
    public void addForce(Vector3 newtons) {
        force[0] += newtons.x();
        force[1] += newtons.y();
        force[2] += newtons.z();
    }

    @Override
    public void addTorque(Vector3 newtonMetres) {
        force[3] += newtonMetres.x();
        force[4] += newtonMetres.y();
        force[5] += newtonMetres.z();
    }

    @Override
    public void resist(double linear, double angular) {
        for (int axis = 0; axis < 3; axis++) {
            force[axis] += -linear * velocity[axis];
            force[3 + axis] += -angular * velocity[3 + axis];
        }
    }

    @Override
    public boolean isAsleep() {
        return asleep;
    }

    @Override
    public void wake() {
        asleep = false;
        restingStepsLeft = STEPS_TO_FALL_ASLEEP;
    }

    private static void set(double[] array, Vector3 vector) {
        array[0] = vector.x();
        array[1] = vector.y();
        array[2] = vector.z();
    }

    @Override
    public void save(StateWriter out) {
        out.putDoubles(position);
        out.putDoubles(quaternion);
        out.putDoubles(rotation);
        out.putDoubles(velocity);
        out.putDoubles(force);
        out.putBoolean(asleep);
        out.putInt(restingStepsLeft);
    }

    /** Takes on a state; the shapes of the body take on theirs afterwards. */
    @Override
    public void restore(StateReader in) {
        in.getDoubles(position);
        hasMoved = true;
        in.getDoubles(quaternion);
        in.getDoubles(rotation);
        in.getDoubles(velocity);
        in.getDoubles(force);
        asleep = in.getBoolean();
        restingStepsLeft = in.getInt();
        turns++;
    }
}
