package org.robonewbie.simulator.world;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.BoundingBox;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/**
 * One robot's body in the world: its motors, its true pose, and what its inertial and force sensors feel.
 *
 * <p>Frames are SimSpark's: a link has x to the robot's right, y forward, z up. Indices of hinges and links are those of
 * {@link NaoModel}.
 *
 * <pre>{@code
 * robot.setMotorSpeed(Joint.LEFT_KNEE_PITCH, -1.0);
 * world.step();
 * double degrees = robot.jointDegrees(Joint.LEFT_KNEE_PITCH);
 * }</pre>
 */
public final class Robot {

    /** Where the torso's centre of a new robot is, in the world frame. */
    public static final Vector3 START_POSITION = new Vector3(0, -1, 1.5);

    private static final Drag DRAG = new Drag(0.01, 0.01);

    private final NaoModel model;
    private final Assembly assembly;
    private final List<RigidBody> bodies;
    private final List<MotorHinge> hinges;
    private final Accelerometer accelerometer = new Accelerometer();
    private final Map<FootSensor, FootPlate> plates = new EnumMap<>(FootSensor.class);
    private final List<FootPlate> allPlates;
    private Optional<Beam> beam = Optional.empty();

    private record Beam(Vector3 position, double yawDegrees) {}

    Robot(Assembly assembly, RobotType type) {
        this.model = NaoModel.of(type);
        this.assembly = assembly;
        RobotBuilder builder = new RobotBuilder(this, assembly);
        this.bodies = builder.addBodies(START_POSITION);
        this.hinges = builder.addHinges(bodies, START_POSITION);
        addFootPlates();
        allPlates = List.copyOf(plates.values());
    }

    /**
     * Describes the robot's links and hinges.
     *
     * @return the model of its type
     */
    public NaoModel model() {
        return model;
    }

    /**
     * Commands a motor as SimSpark does: the speed is cut to what the motor can do, ignored while the joint is on or
     * beyond one of its stops, and kept until the next command. A speed other than 0 wakes a sleeping limb.
     *
     * @param hingeIndex index of the hinge
     * @param radiansPerSecond the speed; 0 holds the joint; NaN is ignored
     */
    public void setMotorSpeed(int hingeIndex, double radiansPerSecond) {
        Hinge hinge = model.hinges().get(hingeIndex);
        if (Double.isNaN(radiansPerSecond)) {
            return;
        }
        double limit = hinge.maxRadiansPerSecond();
        double speed = Math.max(-limit, Math.min(limit, radiansPerSecond));
        double degrees = jointDegrees(hingeIndex);
        if (degrees > hinge.minDegrees() && degrees < hinge.maxDegrees()) {
            hinges.get(hingeIndex).setSpeed(speed);
        }
        if (speed != 0) {
            bodies.get(model.linkIndex(hinge.child())).wake();
        }
    }

    /**
     * Commands the motor of a joint.
     *
     * @param joint the joint
     * @param radiansPerSecond the speed
     * @see #setMotorSpeed(int, double)
     */
    public void setMotorSpeed(Joint joint, double radiansPerSecond) {
        setMotorSpeed(model.hingeIndex(joint), radiansPerSecond);
    }

    /**
     * Measures the angle of a hinge.
     *
     * @param hingeIndex index of the hinge
     * @return degrees, slightly beyond the stops at times
     */
    public double jointDegrees(int hingeIndex) {
        return PortableMath.toDegrees(hinges.get(hingeIndex).angleRadians());
    }

    /**
     * Measures the angle of a joint.
     *
     * @param joint the joint
     * @return degrees, slightly beyond the stops at times
     */
    public double jointDegrees(Joint joint) {
        return jointDegrees(model.hingeIndex(joint));
    }

    /** {@return the torso's pose in the world frame} */
    public BodyPose torso() {
        return bodies.get(0).pose();
    }

    /** {@return the direction in which the torso faces in degrees, 0 along the world's x axis, positive to the left} */
    public double headingDegrees() {
        return BodyState.headingDegrees(bodies.get(0).axisY());
    }

    /** {@return how far the torso leans to any side in degrees: 0 upright, 180 upside down} */
    public double tiltDegrees() {
        return BodyState.tiltDegrees(bodies.get(0).upwards());
    }

    /** {@return whether the torso is tilted by more than 60 degrees or its centre is lower than 0.2 m} */
    public boolean isFallen() {
        return BodyState.isFallen(tiltDegrees(), linkPosition(0).z());
    }

    /** {@return whether the robot is on its feet, as {@link BodyState#isStanding()} has it} */
    public boolean isStanding() {
        return BodyState.isStanding(tiltDegrees(), linkPosition(0).z());
    }

    /** {@return the torso's pose and all joint angles, as they are now} */
    public BodyState body() {
        return BodyState.measured(model.type(), torso().toBodyAxes(), this::jointDegrees);
    }

    /** {@return the velocity of the torso in the world frame, metres per second} */
    public Vector3 torsoVelocity() {
        return bodies.get(0).velocity();
    }

    /**
     * Returns the pose of a link.
     *
     * @param linkIndex index of the link
     * @return its pose in the world frame
     */
    public BodyPose linkPose(int linkIndex) {
        return bodies.get(linkIndex).pose();
    }

    /**
     * Returns where a link is.
     *
     * @param linkIndex index of the link
     * @return its centre in the world frame
     */
    public Vector3 linkPosition(int linkIndex) {
        return bodies.get(linkIndex).position();
    }

    /** {@return the gyro: the torso's angular velocity about its own axes in degrees per second} */
    public Vector3 gyroDegreesPerSecond() {
        return bodies.get(0).ownAngularVelocity().times(PortableMath.toDegrees(1));
    }

    /**
     * {@return the accelerometer: specific force along the torso's own axes in metres per second squared, (0, 0, 9.81) at rest;
     * as in SimSpark one step older than the gyro}
     */
    public Vector3 acceleration() {
        return accelerometer.reading();
    }

    /**
     * Feels what the feet touch.
     *
     * @return point and force of each plate in the frame of its link; empty where nothing was touched in the last step
     */
    public FootForces footForces() {
        return new FootForces(
                reading(FootSensor.LEFT_FOOT),
                reading(FootSensor.RIGHT_FOOT),
                reading(FootSensor.LEFT_TOE),
                reading(FootSensor.RIGHT_TOE));
    }

    /**
     * Pushes the torso at its centre during the next step, as a hand or another robot would.
     *
     * @param newtons the force in the world frame; cut to 1000 N
     */
    public void push(Vector3 newtons) {
        bodies.get(0).wake();
        bodies.get(0).addForce(WorldLimits.force(newtons));
    }

    /**
     * Moves the robot as it is, without turning it or its joints, and stops all movement; it is not woken.
     *
     * @param position new centre of the torso in the world frame, metres
     */
    public void moveTo(Vector3 position) {
        Vector3 way = WorldLimits.place(position).minus(torso().position());
        for (RigidBody body : bodies) {
            body.setPosition(body.position().plus(way));
            stop(body);
        }
    }

    /**
     * Sets pose and motion of all links and wakes them; all motors stop until they are commanded again.
     *
     * @param links one motion for each link of the {@link #model}, in its order, with joints that hold together
     */
    public void place(List<LinkMotion> links) {
        for (int i = 0; i < bodies.size(); i++) {
            RigidBody body = bodies.get(i);
            LinkMotion motion = links.get(i);
            body.setPosition(WorldLimits.place(motion.pose().position()));
            body.setRotation(motion.pose().rotation());
            body.setVelocity(motion.velocity());
            body.setAngularVelocity(motion.radiansPerSecond());
        }
        hinges.forEach(hinge -> hinge.setSpeed(0));
        beam = Optional.empty();
        wake();
    }

    /**
     * Places the robot upright with its joints as they are and stops all motion; it is not woken.
     *
     * @param position new centre of the torso in the world frame, metres
     * @param yawDegrees rotation about the vertical: 0 looks along the world's y axis, -90 along its x axis
     */
    public void moveUpright(Vector3 position, double yawDegrees) {
        BodyPose torso = torso();
        Vector3 place = WorldLimits.place(position);
        double yaw = Double.isFinite(yawDegrees) ? PortableMath.toRadians(yawDegrees) : 0;
        RotationMatrix turn = RotationMatrix.aboutZ(yaw).after(torso.rotation().inverse());
        for (RigidBody body : bodies) {
            Vector3 fromTorso = body.position().minus(torso.position());
            body.setPosition(place.plus(turn.apply(fromTorso)));
            body.setRotation(turn.after(body.rotation()));
            stop(body);
        }
    }

    /**
     * Beams the robot within the next step; the last call before it counts.
     *
     * <p>The same as {@link #moveUpright}, but later, as in the original: the accelerometer of that step still feels the
     * movement before.
     *
     * @param position new centre of the torso in the world frame, metres
     * @param yawDegrees turn about the vertical: 0 looks along the world's y axis, -90 along its x axis
     */
    public void beam(Vector3 position, double yawDegrees) {
        beam = Optional.of(new Beam(position, yawDegrees));
    }

    /**
     * Makes all links heavier or lighter than those of the type, to try what a robot can carry; no part of a saved state.
     *
     * @param factor mass as a multiple of the type's, above 0
     */
    public void setMassFactor(double factor) {
        bodies.forEach(body -> body.setMassFactor(factor));
    }

    /** Wakes a sleeping robot. */
    public void wake() {
        bodies.forEach(RigidBody::wake);
    }

    /**
     * Measures the room that the robot takes.
     *
     * @return the smallest box along the world's axes around all links that can touch something
     */
    public BoundingBox boundingBox() {
        BoundingBox box = BoundingBox.of(model.links().get(0).shape(), torso());
        for (int i = 1; i < bodies.size(); i++) {
            Link link = model.links().get(i);
            if (link.collides()) {
                box = box.union(BoundingBox.of(link.shape(), linkPose(i)));
            }
        }
        return box;
    }

    /** {@return whether the robot has rested so long that the engine leaves it out of the step} */
    public boolean isAsleep() {
        return bodies.get(0).isAsleep();
    }

    void prepareStep() {
        accelerometer.measure(bodies.get(0));
        allPlates.forEach(FootPlate::clear);
        if (beam.isPresent()) {
            moveUpright(beam.get().position(), beam.get().yawDegrees());
            beam = Optional.empty();
        }
        DRAG.applyTo(bodies);
    }

    void addContact(int linkIndex, Contact contact) {
        for (int i = 0; i < allPlates.size(); i++) {
            allPlates.get(i).addContact(linkIndex, contact);
        }
    }

    void finishStep() {
        if (!WorldLimits.areWithin(bodies)) {
            rebuild();
        }
        for (int i = 0; i < allPlates.size(); i++) {
            FootPlate plate = allPlates.get(i);
            plate.update(bodies.get(plate.link()));
        }
    }

    /** Puts a robot that was torn apart into the pose of a new one. */
    private void rebuild() {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).setRotation(RotationMatrix.IDENTITY);
            bodies.get(i).setPosition(START_POSITION.plus(model.links().get(i).position()));
            stop(bodies.get(i));
        }
        wake();
    }

    void remove() {
        assembly.remove();
    }

    private void addFootPlates() {
        for (int i = 0; i < model.links().size(); i++) {
            for (FootSensor sensor : FootSensor.values()) {
                if (model.links().get(i).name().equals(sensor.linkName())) {
                    plates.put(sensor, new FootPlate(i));
                }
            }
        }
    }

    private Optional<FootForce> reading(FootSensor sensor) {
        FootPlate plate = plates.get(sensor);
        return plate == null ? Optional.empty() : plate.reading();
    }

    private static void stop(RigidBody body) {
        body.setVelocity(Vector3.ZERO);
        body.setAngularVelocity(Vector3.ZERO);
    }

    /** Writes what sensors remember and where the robot is about to be beamed; the engine keeps its limbs. */
    void save(StateWriter out) {
        accelerometer.save(out);
        plates.values().forEach(plate -> plate.save(out));
        out.putOptional(beam, target -> {
            out.putVector(target.position());
            out.putDouble(target.yawDegrees());
        });
    }

    void restore(StateReader in) {
        accelerometer.restore(in);
        plates.values().forEach(plate -> plate.restore(in));
        beam = in.getOptional(() -> new Beam(in.getVector(), in.getDouble()));
    }
}
