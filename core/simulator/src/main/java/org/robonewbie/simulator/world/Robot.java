package org.robonewbie.simulator.world;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.NaoRobot;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.BoundingBox;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/**
 * Simulated robot body with motors, inertial sensors and force sensors.
 *
 * <p>The body can be that of any {@link RobotModel}. Frames are SimSpark's: in the frame of a link, x points to the robot's right,
 * y forward, z up. Links are the model's bodies and hinges are its joints, with the same indices.
 *
 * <pre>{@code
 * robot.setMotorSpeed(Joint.LEFT_KNEE_PITCH, -1.0);
 * world.step();
 * double degrees = robot.jointDegrees(Joint.LEFT_KNEE_PITCH);
 * }</pre>
 */
public final class Robot {

    /** Maximum torque of a motor that is commanded by speed, in newton metres. */
    public static final double MAX_TORQUE = 10;

    /** Position of a new robot's torso in the world frame. */
    public static final Vector3 START_POSITION = new Vector3(0, -1, 1.5);

    /** Links with force sensors, in the order of {@link FootForces}. Only robot type 4 has toes. */
    private static final List<String> FOOT_LINKS = List.of("lfoot", "rfoot", "ltoe", "rtoe");

    /** Linear and angular drag (SimSpark: {@code dragcontroller.cpp}). */
    private static final double DRAG = 0.01;

    private final RobotModel model;
    private final Optional<RobotType> type;
    private final Assembly assembly;
    private final List<RobotLink> links;
    private final List<RigidBody> bodies;
    private final List<MotorHinge> hinges;
    private final Accelerometer accelerometer = new Accelerometer();
    private final List<FootPlate> plates;
    private Optional<Beam> beam = Optional.empty();
    private Vector3 externalForce = Vector3.ZERO;
    private Vector3 externalTorque = Vector3.ZERO;

    private record Beam(Vector3 position, double yawDegrees) {}

    Robot(Assembly assembly, RobotModel model) {
        this.model = model;
        this.type = NaoRobot.typeOf(model);
        this.assembly = assembly;
        RobotBuilder builder = new RobotBuilder(this, assembly);
        this.links = builder.addLinks(START_POSITION);
        this.bodies = links.stream().map(RobotLink::body).toList();
        this.hinges = builder.addHinges(links, START_POSITION);
        this.plates = footPlates(model);
    }

    /** {@return the model of the robot} */
    public RobotModel model() {
        return model;
    }

    /** {@return whether the robot is a NAO} */
    public boolean isNao() {
        return type.isPresent();
    }

    /**
     * Returns the type of a NAO.
     *
     * @return the robot type
     * @throws IllegalStateException if the robot is not a NAO
     */
    public RobotType type() {
        if (type.isEmpty()) {
            throw new IllegalStateException("The robot is a " + model.name() + ". Only a NAO can be used here.");
        }
        return type.get();
    }

    /**
     * Returns the links and hinges of a NAO.
     *
     * @return the model in SimSpark's frame
     * @throws IllegalStateException if the robot is not a NAO
     */
    public NaoModel nao() {
        return NaoModel.of(type());
    }

    /**
     * Sets the target speed of a motor, as in SimSpark. The speed is limited to the motor's maximum, if it has one, ignored while the
     * joint is at or beyond a stop, and kept until the next command. A speed other than 0 wakes a sleeping limb.
     *
     * @param hingeIndex index of the hinge
     * @param radiansPerSecond target speed; 0 holds the joint; NaN is ignored
     */
    public void setMotorSpeed(int hingeIndex, double radiansPerSecond) {
        RobotJoint joint = model.joints().get(hingeIndex);
        if (Double.isNaN(radiansPerSecond)) {
            return;
        }
        double limit = joint.motor() instanceof Motor.Speed motor ? motor.maxRadiansPerSecond() : WorldLimits.MAX_SPEED;
        double speed = Math.max(-limit, Math.min(limit, radiansPerSecond));
        double degrees = jointDegrees(hingeIndex);
        if (degrees > joint.minDegrees() && degrees < joint.maxDegrees()) {
            hinges.get(hingeIndex).setSpeed(speed);
        }
        if (speed != 0) {
            bodies.get(joint.body()).wake();
        }
    }

    /**
     * Sets the target speed of the motor of a joint of this robot's model.
     *
     * @param joint the joint
     * @param radiansPerSecond target speed
     * @see #setMotorSpeed(int, double)
     */
    public void setMotorSpeed(RobotJoint joint, double radiansPerSecond) {
        setMotorSpeed(joint.index(), radiansPerSecond);
    }

    /**
     * Sets the target speed of the motor of a NAO's joint.
     *
     * @param joint the joint
     * @param radiansPerSecond target speed
     * @see #setMotorSpeed(int, double)
     */
    public void setMotorSpeed(Joint joint, double radiansPerSecond) {
        setMotorSpeed(nao().hingeIndex(joint), radiansPerSecond);
    }

    /**
     * Returns the angle of a hinge.
     *
     * @param hingeIndex index of the hinge
     * @return degrees; can slightly exceed the stops
     */
    public double jointDegrees(int hingeIndex) {
        return PortableMath.toDegrees(hinges.get(hingeIndex).angleRadians());
    }

    /**
     * Returns the angle of a joint of this robot's model.
     *
     * @param joint the joint
     * @return degrees; can slightly exceed the stops
     */
    public double jointDegrees(RobotJoint joint) {
        return jointDegrees(joint.index());
    }

    /**
     * Returns the angle of a NAO's joint.
     *
     * @param joint the joint
     * @return degrees; can slightly exceed the stops
     */
    public double jointDegrees(Joint joint) {
        return jointDegrees(nao().hingeIndex(joint));
    }

    /**
     * Returns the speed of a joint.
     *
     * @param joint the joint
     * @return degrees per second, without noise
     */
    public double jointDegreesPerSecond(Joint joint) {
        return jointDegreesPerSecond(nao().hingeIndex(joint));
    }

    /**
     * Returns the speed of a hinge.
     *
     * @param hingeIndex index of the hinge
     * @return degrees per second, without noise
     */
    public double jointDegreesPerSecond(int hingeIndex) {
        return PortableMath.toDegrees(hinges.get(hingeIndex).radiansPerSecond());
    }

    /**
     * Returns the torque that the motor and the stop of a joint exerted in the last step.
     *
     * @param joint the joint
     * @return newton metres; a positive torque increases the angle
     */
    public double jointTorque(Joint joint) {
        return hinges.get(nao().hingeIndex(joint)).torque();
    }

    /** {@return the torso's pose in the world frame} */
    public BodyPose torso() {
        return links.get(0).pose();
    }

    /** {@return the heading of the torso in degrees, 0 along the world's x axis, positive to the left} */
    public double headingDegrees() {
        return BodyState.headingDegrees(links.get(0).axisY());
    }

    /** {@return the tilt of the torso in degrees: 0 upright, 180 upside down} */
    public double tiltDegrees() {
        return BodyState.tiltDegrees(links.get(0).upwards());
    }

    /** {@return whether the robot is on its feet, as defined by {@link RobotState#isStanding}} */
    public boolean isStanding() {
        return RobotState.isStanding(model, tiltDegrees(), linkPosition(0).z());
    }

    /** {@return whether the robot has fallen, as defined by {@link RobotState#isFallen}} */
    public boolean isFallen() {
        return RobotState.isFallen(model, tiltDegrees(), linkPosition(0).z());
    }

    /**
     * Returns the current torso pose and joint angles of a NAO.
     *
     * @return the state
     * @throws IllegalStateException if the robot is not a NAO
     */
    public BodyState body() {
        return BodyState.measured(type(), torso().toBodyAxes(), this::jointDegrees);
    }

    /** {@return the current torso pose and joint angles} */
    public RobotState state() {
        return isNao()
                ? new RobotState.OfNao(body())
                : new RobotState.OfModel(
                        model,
                        torso().toBodyAxes(),
                        IntStream.range(0, hinges.size())
                                .mapToDouble(this::jointDegrees)
                                .toArray());
    }

    /** {@return the velocity of the torso in the world frame in metres per second} */
    public Vector3 torsoVelocity() {
        return bodies.get(0).velocity();
    }

    /**
     * Returns the pose of a link.
     *
     * @param linkIndex index of the link
     * @return pose in the world frame
     */
    public BodyPose linkPose(int linkIndex) {
        return links.get(linkIndex).pose();
    }

    /**
     * Returns the position of a link.
     *
     * @param linkIndex index of the link
     * @return origin of the link's frame in the world frame, metres; for a NAO, the centre of the link
     */
    public Vector3 linkPosition(int linkIndex) {
        return links.get(linkIndex).position();
    }

    /** {@return the gyroscope reading: angular velocity of the torso about its axes in degrees per second} */
    public Vector3 gyroDegreesPerSecond() {
        return bodies.get(0).localAngularVelocity().times(PortableMath.toDegrees(1));
    }

    /**
     * {@return the accelerometer reading: proper acceleration along the torso's axes in metres per second squared, (0, 0,
     * 9.81) at rest; as in SimSpark, one step older than the gyroscope reading}
     */
    public Vector3 acceleration() {
        return accelerometer.reading();
    }

    /**
     * {@return the readings of the foot force sensors, in the frames of their links; empty for a sensor that had no
     * contact in the last step}
     */
    public FootForces footForces() {
        return new FootForces(reading(0), reading(1), reading(2), reading(3));
    }

    /**
     * Sets the readings of the foot force sensors, which another physics engine has computed.
     *
     * @param forces the readings until the next step, in the frames of their links
     */
    public void setFootForces(FootForces forces) {
        List<Optional<FootForce>> all = List.of(forces.left(), forces.right(), forces.leftToe(), forces.rightToe());
        for (int i = 0; i < plates.size(); i++) {
            plates.get(i).set(all.get(i));
        }
    }

    /**
     * Applies an external force to the centre of the torso in the next step.
     *
     * @param newtons force in the world frame, limited to 1000 N per axis
     */
    public void push(Vector3 newtons) {
        bodies.get(0).wake();
        Vector3 force = WorldLimits.force(newtons);
        bodies.get(0).addForce(force);
        externalForce = externalForce.plus(force);
    }

    /**
     * Applies an external torque to the torso in the next step.
     *
     * @param newtonMetres torque in the world frame
     */
    public void twist(Vector3 newtonMetres) {
        bodies.get(0).wake();
        bodies.get(0).addTorque(newtonMetres);
        externalTorque = externalTorque.plus(newtonMetres);
    }

    /** {@return the sum of all {@linkplain #push pushes} since the last step, in newtons} */
    public Vector3 externalForce() {
        return externalForce;
    }

    /** {@return the sum of all {@linkplain #twist twists} since the last step, in newton metres} */
    public Vector3 externalTorque() {
        return externalTorque;
    }

    /**
     * Translates the robot and stops all motion. Does not wake it.
     *
     * @param position new position of the torso in the world frame, metres
     */
    public void moveTo(Vector3 position) {
        Vector3 offset = WorldLimits.position(position).minus(torso().position());
        for (RigidBody body : bodies) {
            body.setPosition(body.position().plus(offset));
            stop(body);
        }
    }

    /**
     * Sets the poses and velocities of all links and wakes them. All motors hold their angles until the next command.
     *
     * @param motions one motion per body of the {@link #model}, consistent with its joints
     */
    public void place(List<LinkMotion> motions) {
        for (int i = 0; i < bodies.size(); i++) {
            RigidBody body = bodies.get(i);
            LinkMotion motion = motions.get(i);
            BodyPose pose = motion.pose();
            links.get(i).place(new BodyPose(WorldLimits.position(pose.position()), pose.rotation()));
            body.setVelocity(motion.velocity());
            body.setAngularVelocity(motion.radiansPerSecond());
        }
        hinges.forEach(hinge -> hinge.setSpeed(0));
        beam = Optional.empty();
        wake();
    }

    /**
     * Places the robot upright at a position without changing its joints, and stops all motion. Does not wake it.
     *
     * @param position new position of the torso in the world frame, metres
     * @param yawDegrees rotation about the vertical axis: 0 faces along the world's y axis, -90 along its x axis
     */
    public void moveUpright(Vector3 position, double yawDegrees) {
        double yaw = Double.isFinite(yawDegrees) ? PortableMath.toRadians(yawDegrees) : 0;
        move(position, RotationMatrix.aboutZ(yaw).after(torso().rotation().inverse()));
    }

    /**
     * Translates the robot, turns it about the vertical axis through its torso, and stops all motion. Does not wake it.
     *
     * @param position new position of the torso in the world frame, metres
     * @param degrees angle of the turn, counter-clockwise
     */
    public void moveAndTurn(Vector3 position, double degrees) {
        move(position, RotationMatrix.aboutZ(PortableMath.toRadians(degrees)));
    }

    private void move(Vector3 position, RotationMatrix rotation) {
        Vector3 target = WorldLimits.position(position);
        Vector3 torso = torso().position();
        for (RigidBody body : bodies) {
            Vector3 fromTorso = body.position().minus(torso);
            body.setPosition(target.plus(rotation.apply(fromTorso)));
            body.setRotation(rotation.after(body.rotation()));
            stop(body);
        }
    }

    /**
     * Beams the robot in the next step. The last call before the step takes precedence.
     *
     * <p>Like {@link #moveUpright}, but deferred as in rcssserver3d: the accelerometer of that step still measures the previous
     * motion.
     *
     * @param position new position of the torso in the world frame, metres
     * @param yawDegrees rotation about the vertical axis: 0 faces along the world's y axis, -90 along its x axis
     */
    public void beam(Vector3 position, double yawDegrees) {
        beam = Optional.of(new Beam(position, yawDegrees));
    }

    /**
     * Scales the masses of all links. The factor is not part of a saved state.
     *
     * @param factor multiple of the robot type's mass, above 0
     */
    public void setMassFactor(double factor) {
        bodies.forEach(body -> body.setMassFactor(factor));
    }

    /** {@return the mass of the torso in kilograms, without the factor of {@link #setMassFactor}} */
    public double torsoMass() {
        return model.bodies().get(0).massKg();
    }

    /**
     * Scales the maximum torque of a motor. The factor is not part of a saved state.
     *
     * @param joint the joint
     * @param factor multiple of the motor's torque, above 0
     */
    public void setStrength(Joint joint, double factor) {
        int hinge = nao().hingeIndex(joint);
        hinges.get(hinge).setMaxTorque(factor * maxTorque(model.joints().get(hinge)));
    }

    /**
     * Scales the grip of the soles. The factor is not part of a saved state.
     *
     * @param factor above 0; at 0.5 the soles slip twice as fast as at 1 under the same force
     */
    public void setSoleGrip(double factor) {
        plates.forEach(plate -> bodies.get(plate.link()).setGrip(factor));
    }

    /** Restores the robot type's mass, strength and grip. */
    public void restoreProperties() {
        setMassFactor(1);
        setSoleGrip(1);
        model.joints().forEach(joint -> hinges.get(joint.index()).setMaxTorque(maxTorque(joint)));
    }

    /** Returns the maximum torque of a joint's motor in newton metres. */
    static double maxTorque(RobotJoint joint) {
        return joint.motor() instanceof Motor.Torque torque ? torque.maxNewtonMetres() : MAX_TORQUE;
    }

    /** Wakes a sleeping robot. */
    public void wake() {
        bodies.forEach(RigidBody::wake);
    }

    /** {@return the bounding box of the torso's centre and all shapes that collide} */
    public BoundingBox boundingBox() {
        Vector3 centre = linkPosition(0);
        BoundingBox box = new BoundingBox(centre, centre);
        for (int i = 0; i < links.size(); i++) {
            box = links.get(i).addTo(box);
        }
        return box;
    }

    /** {@return whether the robot is asleep, so that steps skip it} */
    public boolean isAsleep() {
        return bodies.get(0).isAsleep();
    }

    void prepareStep() {
        accelerometer.measure(bodies.get(0));
        plates.forEach(FootPlate::clear);
        if (beam.isPresent()) {
            moveUpright(beam.get().position(), beam.get().yawDegrees());
            beam = Optional.empty();
        }
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).addDamping(DRAG, DRAG);
        }
    }

    void addContact(int linkIndex, Contact contact) {
        for (int i = 0; i < plates.size(); i++) {
            plates.get(i).addContact(linkIndex, contact);
        }
    }

    void finishStep() {
        if (!WorldLimits.areWithin(bodies)) {
            rebuild();
        }
        for (int i = 0; i < plates.size(); i++) {
            FootPlate plate = plates.get(i);
            plate.update(bodies.get(plate.link()));
        }
        forgetExternalForces();
    }

    void forgetExternalForces() {
        externalForce = Vector3.ZERO;
        externalTorque = Vector3.ZERO;
    }

    /** Resets the robot to its initial pose after its links have been torn apart. */
    private void rebuild() {
        for (int i = 0; i < bodies.size(); i++) {
            links.get(i).putToStart(START_POSITION);
            stop(bodies.get(i));
        }
        wake();
    }

    void remove() {
        assembly.remove();
    }

    private static List<FootPlate> footPlates(RobotModel model) {
        List<String> names = model.bodies().stream().map(RobotBody::name).toList();
        return FOOT_LINKS.stream()
                .filter(names::contains)
                .map(name -> new FootPlate(names.indexOf(name)))
                .toList();
    }

    private Optional<FootForce> reading(int foot) {
        return foot < plates.size() ? plates.get(foot).reading() : Optional.empty();
    }

    private static void stop(RigidBody body) {
        body.setVelocity(Vector3.ZERO);
        body.setAngularVelocity(Vector3.ZERO);
    }

    /** Saves the state of the sensors and a pending beam. The engine saves the links. */
    void save(StateWriter out) {
        accelerometer.save(out);
        plates.forEach(plate -> plate.save(out));
        out.putOptional(beam, target -> {
            out.putVector(target.position());
            out.putDouble(target.yawDegrees());
        });
    }

    void restore(StateReader in) {
        forgetExternalForces();
        accelerometer.restore(in);
        plates.forEach(plate -> plate.restore(in));
        beam = in.getOptional(() -> new Beam(in.getVector(), in.getDouble()));
    }
}
