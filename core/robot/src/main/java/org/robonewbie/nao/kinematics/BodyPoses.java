package org.robonewbie.nao.kinematics;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;

/**
 * The poses of all links of a robot: relative to the torso in the body frame, or in the world frame if they come from a {@link
 * BodyState}. Immutable.
 */
public final class BodyPoses {

    static final String HEAD = "head";

    /**
     * Height, in metres, below which a corner counts as touching the ground; the soles of a standing robot tilt
     * slightly.
     */
    private static final double TOUCH_METRES = 0.012;

    private static final int CORNERS = 8;

    private final NaoModel model;
    private final List<Pose> poses;

    BodyPoses(NaoModel model, List<Pose> poses) {
        this.model = model;
        this.poses = List.copyOf(poses);
    }

    /** Transforms poses relative to the torso to the frame in which the torso's pose is given. */
    BodyPoses withTorso(Pose torso) {
        return new BodyPoses(model, poses.stream().map(torso::times).toList());
    }

    /** {@return the pose of each link in the order of {@link NaoModel#links()}; in the construction pose, no link is rotated} */
    public List<Pose> links() {
        return poses;
    }

    /**
     * Returns the pose of a link.
     *
     * @param name the link's name in {@link NaoModel}, such as {@code lfoot}
     * @return its centre and orientation
     * @throws IllegalArgumentException if the robot has no such link
     */
    public Pose link(String name) {
        return poses.get(model.linkIndex(name));
    }

    /**
     * Returns the pose of a foot.
     *
     * @param leg the leg
     * @return centre and orientation of the foot's box; the sole is 1 cm below the centre
     */
    public Pose foot(Leg leg) {
        return link(leg.footLink());
    }

    /** {@return the pose of the camera, which is at the centre of the head and looks along the head's x axis} */
    public Pose camera() {
        return link(HEAD);
    }

    /**
     * Returns the corners of a sole.
     *
     * @param leg the leg
     * @return the front left, front right, rear right and rear left corners, in metres
     */
    public List<Vector3> soleCorners(Leg leg) {
        List<Vector3> corners = corners(model.linkIndex(leg.footLink()));
        return List.of(corners.get(5), corners.get(4), corners.get(6), corners.get(7));
    }

    /** {@return the centre of mass of the robot in metres} */
    public Vector3 centreOfMass() {
        Vector3 sum = Vector3.ZERO;
        double mass = 0;
        for (int i = 0; i < poses.size(); i++) {
            double linkMass = model.links().get(i).massKg();
            sum = sum.plus(poses.get(i).position().times(linkMass));
            mass += linkMass;
        }
        return sum.times(1 / mass);
    }

    /**
     * Returns the support polygon: the convex hull of all points that touch the ground, or nearly do. The robot keeps its balance
     * while its centre of mass is above this polygon. Requires poses in the world frame.
     *
     * @return the corners on the ground counter-clockwise, seen from above; empty if nothing touches the ground
     */
    public List<Vector3> supportPolygon() {
        List<Vector3> touching = new ArrayList<>();
        for (int i = 0; i < poses.size(); i++) {
            if (model.links().get(i).collides()) {
                corners(i).stream()
                        .filter(corner -> corner.z() < TOUCH_METRES)
                        .map(corner -> new Vector3(corner.x(), corner.y(), 0))
                        .forEach(touching::add);
            }
        }
        return ConvexHull.of(touching);
    }

    /**
     * Returns the corners of the bounding box of a link.
     *
     * @param link the link's index in {@link NaoModel#links()}
     * @return eight points in metres; bits 0, 1 and 2 of a corner's index are set on the negative side of the link's x,
     *     y and z axes, respectively, in SimSpark's frame
     */
    public List<Vector3> corners(int link) {
        Vector3 size = model.links().get(link).shape().size();
        List<Vector3> corners = new ArrayList<>(CORNERS);
        for (int i = 0; i < CORNERS; i++) {
            double right = (i & 1) == 0 ? size.x() : -size.x();
            double forward = (i & 2) == 0 ? size.y() : -size.y();
            double up = (i & 4) == 0 ? size.z() : -size.z();
            Vector3 half = new Vector3(right, forward, up).times(0.5);
            corners.add(poses.get(link).transform(SimSparkFrame.toBody(half)));
        }
        return corners;
    }
}
