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
 * The robot's body: 23 links in a tree, joined by 22 hinges (25 and 24 with toes), in SimSpark's order.
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
     * Returns the body of a robot type.
     *
     * @param type the robot type
     * @return its body
     */
    public static NaoModel of(RobotType type) {
        return MODELS.get(type.ordinal());
    }

    /** {@return the robot type of this body} */
    public RobotType type() {
        return type;
    }

    /** {@return the rigid bodies in SimSpark's order; the torso comes first and each parent before its children} */
    public List<Link> links() {
        return allLinks;
    }

    /**
     * {@return the hinges in SimSpark's order, in which a perceptor message reports them: head, right arm, left arm, right leg,
     * left leg}
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
            throw new IllegalArgumentException("Link \"" + name + "\" does not exist in robot " + type);
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
     * Finds the hinge that an effector moves.
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
        addHinge(Joint.NECK_YAW, "neck", TORSO, neck, Z_AXIS, MAX_RADIANS_PER_SECOND);
        addHinge(
                Joint.NECK_PITCH, "head", "neck", head.plus(new Vector3(0, 0, -0.005)), X_AXIS, MAX_RADIANS_PER_SECOND);
    }

    private void addArm(int side) {
        String prefix = side > 0 ? "r" : "l";
        Vector3 shoulder = mirrored(new Vector3(0.098, 0, 0.075), side);
        Vector3 upperArm = shoulder.plus(mirrored(new Vector3(0.01, 0.02, 0), side));
        Vector3 elbow = upperArm.plus(mirrored(type.elbowFromUpperArm(), side));
        Vector3 lowerArm = elbow.plus(new Vector3(0, 0.05, 0));
        links.add(new Link(prefix + "shoulder", new Shape.Sphere(0.01), 0.07, shoulder, false));
        links.add(new Link(prefix + "upperarm", box(0.07, 0.08, 0.06), 0.15, upperArm, true));
        links.add(new Link(prefix + "elbow", new Shape.Sphere(0.01), 0.035, elbow, false));
        links.add(new Link(prefix + "lowerarm", box(0.05, 0.11, 0.05), 0.2, lowerArm, true));

        boolean right = side > 0;
        addHinge(
                right ? Joint.RIGHT_SHOULDER_PITCH : Joint.LEFT_SHOULDER_PITCH,
                prefix + "shoulder",
                TORSO,
                shoulder,
                X_AXIS,
                MAX_RADIANS_PER_SECOND);
        addHinge(
                right ? Joint.RIGHT_SHOULDER_YAW : Joint.LEFT_SHOULDER_YAW,
                prefix + "upperarm",
                prefix + "shoulder",
                upperArm.plus(mirrored(new Vector3(-0.01, -0.02, 0), side)),
                Z_AXIS,
                MAX_RADIANS_PER_SECOND);
        addHinge(
                right ? Joint.RIGHT_ARM_ROLL : Joint.LEFT_ARM_ROLL,
                prefix + "elbow",
                prefix + "upperarm",
                elbow,
                Y_AXIS,
                MAX_RADIANS_PER_SECOND);
        addHinge(
                right ? Joint.RIGHT_ARM_YAW : Joint.LEFT_ARM_YAW,
                prefix + "lowerarm",
                prefix + "elbow",
                lowerArm.plus(new Vector3(0, -0.05, 0)),
                Z_AXIS,
                MAX_RADIANS_PER_SECOND);
    }

    private void addLeg(int side) {
        String prefix = side > 0 ? "r" : "l";
        Vector3 hip = mirrored(type.hipFromTorso(), side);
        Vector3 thigh = hip.plus(type.thighFromHip());
        Vector3 shank = thigh.plus(new Vector3(0, 0.005, -0.125));
        Vector3 ankle = shank.plus(type.ankleFromShank());
        links.add(new Link(prefix + "hip1", new Shape.Sphere(0.01), 0.09, hip, false));
        links.add(new Link(prefix + "hip2", new Shape.Sphere(0.01), 0.125, hip, false));
        links.add(new Link(prefix + "thigh", box(0.07, 0.07, 0.14), 0.275, thigh, true));
        links.add(new Link(prefix + "shank", box(0.08, 0.07, 0.11), 0.225, shank, true));
        links.add(new Link(prefix + "ankle", new Shape.Sphere(0.01), 0.125, ankle, false));

        boolean right = side > 0;
        addHinge(
                right ? Joint.RIGHT_HIP_YAW_PITCH : Joint.LEFT_HIP_YAW_PITCH,
                prefix + "hip1",
                TORSO,
                hip,
                new Vector3(-HALF_ROOT, 0, side * HALF_ROOT),
                MAX_RADIANS_PER_SECOND);
        addHinge(
                right ? Joint.RIGHT_HIP_ROLL : Joint.LEFT_HIP_ROLL,
                prefix + "hip2",
                prefix + "hip1",
                hip,
                Y_AXIS,
                MAX_RADIANS_PER_SECOND);
        addHinge(
                right ? Joint.RIGHT_HIP_PITCH : Joint.LEFT_HIP_PITCH,
                prefix + "thigh",
                prefix + "hip2",
                hip,
                X_AXIS,
                MAX_RADIANS_PER_SECOND);
        addHinge(
                right ? Joint.RIGHT_KNEE_PITCH : Joint.LEFT_KNEE_PITCH,
                prefix + "shank",
                prefix + "thigh",
                shank.plus(new Vector3(0, -0.01, 0.045)),
                X_AXIS,
                MAX_RADIANS_PER_SECOND);
        addHinge(
                right ? Joint.RIGHT_FOOT_PITCH : Joint.LEFT_FOOT_PITCH,
                prefix + "ankle",
                prefix + "shank",
                ankle,
                X_AXIS,
                type.anklePitchSpeed());
        addFoot(side, ankle);
    }

    private void addFoot(int side, Vector3 ankle) {
        String prefix = side > 0 ? "r" : "l";
        double footLength = FOOT_LENGTH - type.toeLength();
        double toeMass = 0.2 * 0.5 * type.toeLength() / FOOT_LENGTH;
        Vector3 foot = ankle.plus(new Vector3(0, footLength / 2 - 0.05, -0.04));
        links.add(new Link(prefix + "foot", box(0.08, footLength, 0.02), 0.2 - toeMass, foot, true));
        addHinge(
                side > 0 ? Joint.RIGHT_FOOT_ROLL : Joint.LEFT_FOOT_ROLL,
                prefix + "foot",
                prefix + "ankle",
                new Vector3(ankle.x(), foot.y() - 0.03, ankle.z() - 0.005),
                Y_AXIS,
                type.ankleRollSpeed());
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

    private void addHinge(
            Joint joint, String child, String parent, Vector3 anchor, Vector3 axis, double maxRadiansPerSecond) {
        hinges.add(new Hinge(
                joint.perceptorName(),
                joint.effectorName(),
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
