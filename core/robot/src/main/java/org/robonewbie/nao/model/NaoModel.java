package org.robonewbie.nao.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/**
 * The kinematic tree of the robot: 23 links joined by 22 hinges, or 25 links and 24 hinges with toes, in SimSpark's order.
 *
 * <p>Source: the scene files {@code nao_hetero.rsg}, {@code naoneckhead.rsg}, {@code naoarm.rsg}, {@code naoleg.rsg} and
 * {@code naolegtoe.rsg} of rcssserver3d 0.7.3. All positions are in SimSpark's frame: x to the robot's right, y forward,
 * z up, metres, in the construction pose.
 */
public final class NaoModel {

    /** The first link, the root of the tree. */
    public static final String TORSO = "body";

    private static final double MAX_RADIANS_PER_SECOND = 6.13954;
    private static final double HALF_ROOT = Math.sqrt(0.5);
    private static final Vector3 X_AXIS = new Vector3(1, 0, 0);
    private static final Vector3 Y_AXIS = new Vector3(0, 1, 0);
    private static final Vector3 Z_AXIS = new Vector3(0, 0, 1);
    private static final double FOOT_LENGTH = 0.16;
    private static final List<NaoModel> MODELS =
            Arrays.stream(RobotType.values()).map(NaoModel::new).toList();

    private final RobotType type;
    private final List<Link> links = new ArrayList<>();
    private final List<Hinge> hinges = new ArrayList<>();
    private final List<Link> allLinks = Collections.unmodifiableList(links);
    private final List<Hinge> allHinges = Collections.unmodifiableList(hinges);
    private final Map<String, Integer> linkOfName = new HashMap<>();
    private final Map<String, OptionalInt> hingeOfEffector = new HashMap<>();
    private final int[] hingeOfJoint;

    private NaoModel(RobotType type) {
        this.type = type;
        links.add(new Link(TORSO, box(0.10, 0.10, 0.18), 1.2171, Vector3.ZERO, true));
        addHead();
        addArm(1);
        addArm(-1);
        addLeg(1);
        addLeg(-1);
        links.forEach(link -> linkOfName.put(link.name(), linkOfName.size()));
        hinges.forEach(hinge -> hingeOfEffector.put(hinge.effectorName(), OptionalInt.of(hingeOfEffector.size())));
        hingeOfJoint = Arrays.stream(Joint.values())
                .mapToInt(joint -> hingeIndex(joint.effectorName()).orElseThrow())
                .toArray();
    }

    /**
     * Returns the model of a robot type.
     *
     * @param type the robot type
     * @return its model
     */
    public static NaoModel of(RobotType type) {
        return MODELS.get(type.ordinal());
    }

    /** {@return the robot type} */
    public RobotType type() {
        return type;
    }

    /** {@return the links in SimSpark's order: the torso first, and each parent before its children} */
    public List<Link> links() {
        return allLinks;
    }

    /**
     * {@return the hinges in SimSpark's order, which is also their order in a perceptor message: head, right arm, left arm, right
     * leg, left leg}
     */
    public List<Hinge> hinges() {
        return allHinges;
    }

    /**
     * Returns the index of a link.
     *
     * @param name a link's name
     * @return its index in {@link #links()}
     * @throws IllegalArgumentException if the robot has no such link
     */
    public int linkIndex(String name) {
        Integer index = linkOfName.get(name);
        if (index == null) {
            throw new IllegalArgumentException("Robot " + type + " has no link \"" + name + "\".");
        }
        return index;
    }

    /**
     * Returns the index of a joint's hinge.
     *
     * @param joint a joint
     * @return its index in {@link #hinges()}
     */
    public int hingeIndex(Joint joint) {
        return hingeOfJoint[joint.ordinal()];
    }

    /**
     * Returns the index of the hinge that an effector drives.
     *
     * @param effectorName SimSpark's name, such as {@code lle4}
     * @return its index in {@link #hinges()}; empty if this robot has no such hinge
     */
    public OptionalInt hingeIndex(String effectorName) {
        return hingeOfEffector.getOrDefault(effectorName, OptionalInt.empty());
    }

    private void addHead() {
        Vector3 neck = new Vector3(0, 0, 0.09);
        Vector3 head = neck.plus(new Vector3(0, 0, 0.065));
        links.add(new Link("neck", new Shape.Capsule(0.015, 0.08), 0.05, neck, true));
        links.add(new Link("head", new Shape.Sphere(0.065), 0.35, head, true));
        addHinge("he1", "neck", TORSO, neck, Z_AXIS);
        addHinge("he2", "head", "neck", head.plus(new Vector3(0, 0, -0.005)), X_AXIS);
    }

    private void addArm(int side) {
        String prefix = side > 0 ? "r" : "l";
        Vector3 shoulder = mirrored(new Vector3(0.098, 0, 0.075), side);
        Vector3 upperArm = shoulder.plus(mirrored(new Vector3(0.01, 0.02, 0), side));
        Vector3 upperArmHinge = upperArm.plus(mirrored(new Vector3(-0.01, -0.02, 0), side));
        Vector3 elbow = upperArm.plus(mirrored(type.elbowFromUpperArm(), side));
        Vector3 lowerArm = elbow.plus(new Vector3(0, 0.05, 0));
        links.add(new Link(prefix + "shoulder", new Shape.Sphere(0.01), 0.07, shoulder, false));
        links.add(new Link(prefix + "upperarm", box(0.07, 0.08, 0.06), 0.15, upperArm, true));
        links.add(new Link(prefix + "elbow", new Shape.Sphere(0.01), 0.035, elbow, false));
        links.add(new Link(prefix + "lowerarm", box(0.05, 0.11, 0.05), 0.2, lowerArm, true));

        addHinge(prefix + "ae1", prefix + "shoulder", TORSO, shoulder, X_AXIS);
        addHinge(prefix + "ae2", prefix + "upperarm", prefix + "shoulder", upperArmHinge, Z_AXIS);
        addHinge(prefix + "ae3", prefix + "elbow", prefix + "upperarm", elbow, Y_AXIS);
        addHinge(
                prefix + "ae4", prefix + "lowerarm", prefix + "elbow", lowerArm.plus(new Vector3(0, -0.05, 0)), Z_AXIS);
    }

    private void addLeg(int side) {
        String prefix = side > 0 ? "r" : "l";
        Vector3 hip = mirrored(type.hipFromTorso(), side);
        Vector3 hipAxis = new Vector3(-HALF_ROOT, 0, side * HALF_ROOT);
        Vector3 thigh = hip.plus(type.thighFromHip());
        Vector3 shank = thigh.plus(new Vector3(0, 0.005, -0.125));
        Vector3 knee = shank.plus(new Vector3(0, -0.01, 0.045));
        Vector3 ankle = shank.plus(type.ankleFromShank());
        links.add(new Link(prefix + "hip1", new Shape.Sphere(0.01), 0.09, hip, false));
        links.add(new Link(prefix + "hip2", new Shape.Sphere(0.01), 0.125, hip, false));
        links.add(new Link(prefix + "thigh", box(0.07, 0.07, 0.14), 0.275, thigh, true));
        links.add(new Link(prefix + "shank", box(0.08, 0.07, 0.11), 0.225, shank, true));
        links.add(new Link(prefix + "ankle", new Shape.Sphere(0.01), 0.125, ankle, false));

        addHinge(prefix + "le1", prefix + "hip1", TORSO, hip, hipAxis);
        addHinge(prefix + "le2", prefix + "hip2", prefix + "hip1", hip, Y_AXIS);
        addHinge(prefix + "le3", prefix + "thigh", prefix + "hip2", hip, X_AXIS);
        addHinge(prefix + "le4", prefix + "shank", prefix + "thigh", knee, X_AXIS);
        addHinge(prefix + "le5", prefix + "ankle", prefix + "shank", ankle, X_AXIS, type.anklePitchSpeed());
        addFoot(prefix, ankle);
    }

    private void addFoot(String prefix, Vector3 ankle) {
        double footLength = FOOT_LENGTH - type.toeLength();
        double toeMass = 0.2 * 0.5 * type.toeLength() / FOOT_LENGTH;
        Vector3 foot = ankle.plus(new Vector3(0, footLength / 2 - 0.05, -0.04));
        Vector3 footHinge = new Vector3(ankle.x(), foot.y() - 0.03, ankle.z() - 0.005);
        links.add(new Link(prefix + "foot", box(0.08, footLength, 0.02), 0.2 - toeMass, foot, true));
        addHinge(prefix + "le6", prefix + "foot", prefix + "ankle", footHinge, Y_AXIS, type.ankleRollSpeed());
        if (type.hasToes()) {
            Vector3 toe = foot.plus(new Vector3(0, FOOT_LENGTH / 2, -0.005));
            links.add(new Link(prefix + "toe", box(0.08, type.toeLength(), 0.01), toeMass, toe, true));
            hinges.add(new Hinge(
                    prefix + "lj7",
                    prefix + "le7",
                    prefix + "toe",
                    prefix + "foot",
                    toe.plus(new Vector3(0, -type.toeLength() / 2, -0.005)),
                    X_AXIS,
                    -1,
                    70,
                    MAX_RADIANS_PER_SECOND));
        }
    }

    private void addHinge(String effectorName, String child, String parent, Vector3 anchor, Vector3 axis) {
        addHinge(effectorName, child, parent, anchor, axis, MAX_RADIANS_PER_SECOND);
    }

    private void addHinge(
            String effectorName,
            String child,
            String parent,
            Vector3 anchor,
            Vector3 axis,
            double maxRadiansPerSecond) {
        Joint joint = Joint.ofEffector(effectorName).orElseThrow();
        hinges.add(new Hinge(
                joint.perceptorName(),
                effectorName,
                child,
                parent,
                anchor,
                axis,
                joint.minDegrees(),
                joint.maxDegrees(),
                maxRadiansPerSecond));
    }

    private static Shape box(double x, double y, double z) {
        return new Shape.Box(new Vector3(x, y, z));
    }

    private static Vector3 mirrored(Vector3 right, int side) {
        return new Vector3(side * right.x(), right.y(), right.z());
    }
}
