package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/**
 * Rigid body with Newton-Euler dynamics.
 *
 * <p>Arrays of three elements hold x, y, z. Arrays of six elements hold a linear part and then an angular part, along
 * the world axes.
 */
final class Body implements RigidBody, Restorable {

    /** Placeholder for the bodies of an unused contact. */
    static final Body NONE =
            new Body(new MassDistribution(1, new Vector3(1, 1, 1)), Vector3.ZERO, new UpdateSequence());

    private static final double GRAVITY = -9.81;
    private static final double RESTING_SPEED_SQUARED = 0.01 * 0.01;
    private static final int STEPS_TO_FALL_ASLEEP = 10;

    double inverseMass;
    /** Rotation from body to world axes, row-major. */
    final double[] rotation = Rotations.identity();
    /** Inverse inertia tensor in world axes for the current step, row-major. */
    final double[] inverseInertia = new double[9];

    final double[] velocity = new double[6];
    /** Accumulated force and torque of this step, excluding constraint forces. */
    final double[] force = new double[6];
    /** Unconstrained velocity after the step, divided by the duration h of the step: v/h + M⁻¹ f. */
    final double[] unconstrained = new double[6];
    /** Acceleration due to the constraint forces: M⁻¹ Jᵀ λ. */
    final double[] acceleration = new double[6];
    /** Joints of this body: hinges first, then the contacts of this step. */
    final List<ConstraintJoint> joints = new ArrayList<>();
    /** Index of this body in its island, valid during the step. */
    int islandIndex;
    /** Whether the body has already been added to an island in this step. */
    boolean visited;

    /** Grip of the surface, as a multiple of the grip of its material. */
    double grip = 1;

    private final MassDistribution nominal;
    private double mass;
    private final double[] inertia = new double[3];
    private final boolean isotropic;
    private final double[] position = new double[3];
    /** Cached result of {@link #position}, which is called several times per step. */
    private Vector3 cachedPosition = Vector3.ZERO;

    private boolean positionChanged = true;
    private Vector3 cachedVelocity = Vector3.ZERO;

    private final double[] quaternion = {1, 0, 0, 0};
    private final UpdateSequence updates;
    private final List<CollisionShape> shapes = new ArrayList<>();
    private final List<ShapeOffset> offsets = new ArrayList<>(0);
    private boolean asleep;
    private int rotationVersion;
    private int restingStepsLeft = STEPS_TO_FALL_ASLEEP;

    Body(MassDistribution distribution, Vector3 position, UpdateSequence updates) {
        this.updates = updates;
        nominal = distribution;
        setMassFactor(1);
        Vector3 moments = distribution.inertia();
        isotropic = moments.x() == moments.y() && moments.y() == moments.z();
        set(this.position, position);
    }

    @Override
    public void setMassFactor(double factor) {
        mass = factor * nominal.massKg();
        inverseMass = 1 / mass;
        set(inertia, nominal.inertia().times(factor));
    }

    @Override
    public void setGrip(double factor) {
        grip = factor;
    }

    double[] centre() {
        return position;
    }

    /** Transforms a point from the world frame to the body frame and writes the result starting at an index. */
    void toLocal(double[] point, double[] to, int at) {
        Rotations.applyInverse(
                rotation, point[0] - position[0], point[1] - position[1], point[2] - position[2], to, at);
    }

    double[] orientation() {
        return quaternion;
    }

    /** Returns a version number that changes with the orientation, so that derived values can be cached. */
    int rotationVersion() {
        return rotationVersion;
    }

    void attach(CollisionShape shape) {
        shapes.add(shape);
        shape.moved(updates);
    }

    /** Attaches a shape whose pose follows the body. */
    void attach(ShapeOffset offset) {
        offsets.add(offset);
        offset.follow(pose());
    }

    private void moveOffsets() {
        for (int i = 0; i < offsets.size(); i++) {
            offsets.get(i).follow(pose());
        }
    }

    void removeContacts() {
        while (!joints.isEmpty() && joints.get(joints.size() - 1) instanceof ContactJoint) {
            joints.remove(joints.size() - 1);
        }
    }

    void unvisit() {
        visited = false;
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).visited = false;
        }
    }

    /** Puts the body to sleep after ten consecutive steps at rest, like ODE's auto-disable. */
    void updateSleep() {
        if (asleep || joints.isEmpty()) {
            return;
        }
        restingStepsLeft = isResting() ? restingStepsLeft - 1 : STEPS_TO_FALL_ASLEEP;
        if (restingStepsLeft <= 0) {
            asleep = true;
            Arrays.fill(velocity, 0);
        }
    }

    /** Includes the body in the step because its island is awake. Does not reset the count of steps at rest. */
    void resume() {
        asleep = false;
    }

    private boolean isResting() {
        return Rotations.dot(velocity, 0, velocity, 0) <= RESTING_SPEED_SQUARED
                && Rotations.dot(velocity, 3, velocity, 3) <= RESTING_SPEED_SQUARED;
    }

    /** Adds weight and gyroscopic torque, and updates the inertia in world axes. */
    void addGravityAndGyroscopicTorque(double seconds) {
        force[2] += mass * GRAVITY;
        Rotations.rotateDiagonal(rotation, 1 / inertia[0], 1 / inertia[1], 1 / inertia[2], inverseInertia);
        if (!isotropic) {
            Gyroscope.addTorque(rotation, inertia, velocity, seconds, force);
        }
    }

    /** Computes the unconstrained motion. Call after all forces have been added. */
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

    /** Integrates velocities and then, with the new velocities, the pose (semi-implicit Euler, as in ODE). */
    void integrate(double seconds) {
        for (int axis = 0; axis < 3; axis++) {
            velocity[axis] += seconds * (acceleration[axis] + force[axis] * inverseMass);
            velocity[3 + axis] +=
                    seconds * (acceleration[3 + axis] + Rotations.dot(inverseInertia, 3 * axis, force, 3));
        }
        for (int axis = 0; axis < 3; axis++) {
            position[axis] += seconds * velocity[axis];
        }
        positionChanged = true;
        Rotations.integrate(quaternion, velocity, seconds);
        Rotations.toMatrix(quaternion, rotation);
        rotationVersion++;
        Arrays.fill(force, 0);
        notifyShapes();
    }

    private void notifyShapes() {
        moveOffsets();
        for (int i = 0; i < shapes.size(); i++) {
            shapes.get(i).moved(updates);
        }
    }

    @Override
    public Vector3 position() {
        if (positionChanged) {
            cachedPosition = new Vector3(position[0], position[1], position[2]);
            positionChanged = false;
        }
        return cachedPosition;
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
    public Vector3 localAngularVelocity() {
        return directionToLocal(velocity[3], velocity[4], velocity[5]);
    }

    @Override
    public boolean isWithin(double metres) {
        return Math.abs(position[0]) < metres && Math.abs(position[1]) < metres && Math.abs(position[2]) < metres;
    }

    @Override
    public Vector3 velocity() {
        if (!isVelocity(cachedVelocity)) {
            cachedVelocity = new Vector3(velocity[0], velocity[1], velocity[2]);
        }
        return cachedVelocity;
    }

    /** Returns whether a vector equals the velocity. Distinguishes 0 from -0. */
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
    public void setPosition(Vector3 centre) {
        set(position, centre);
        positionChanged = true;
        notifyShapes();
    }

    @Override
    public void setRotation(RotationMatrix matrix) {
        Rotations.copy(matrix, rotation);
        Rotations.toQuaternion(rotation, quaternion);
        Rotations.orthonormalise(rotation);
        rotationVersion++;
        notifyShapes();
    }

    @Override
    public void setVelocity(Vector3 metresPerSecond) {
        set(velocity, metresPerSecond);
    }

    @Override
    public void setAngularVelocity(Vector3 radiansPerSecond) {
        Rotations.set(velocity, 3, radiansPerSecond.x(), radiansPerSecond.y(), radiansPerSecond.z());
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
    public void addDamping(double linear, double angular) {
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
        Rotations.set(array, 0, vector.x(), vector.y(), vector.z());
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

    /** Restores the state. Restore the body's shapes afterwards. */
    @Override
    public void restore(StateReader in) {
        in.getDoubles(position);
        positionChanged = true;
        in.getDoubles(quaternion);
        in.getDoubles(rotation);
        in.getDoubles(velocity);
        in.getDoubles(force);
        asleep = in.getBoolean();
        restingStepsLeft = in.getInt();
        rotationVersion++;
        moveOffsets();
    }
}
