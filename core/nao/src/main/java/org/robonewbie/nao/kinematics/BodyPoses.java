package org.robonewbie.nao.kinematics;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.Shape;

/**
 * Where the links of a robot are in one posture: as seen from the torso in the body frame, or in the world frame if they come from
 * a {@link BodyState}. Unmodifiable.
 */
public final class BodyPoses {

    static final String HEAD = "head";

    /** A corner that is not higher than this touches the ground; soles of a robot that stands are a little uneven. */
    private static final double TOUCH_METRES = 0.012;

    private static final int CORNERS = 8;

    private final NaoModel model;
    private final List<Pose> poses;

    BodyPoses(NaoModel model, List<Pose> poses) {
        this.model = model;
        this.poses = List.copyOf(poses);
    }

    /** The same links as seen from where the torso has this pose. */
    BodyPoses seenFrom(Pose torso) {
        return new BodyPoses(model, poses.stream().map(torso::times).toList());
    }

    /** {@return the pose of each link in the order of {@link NaoModel#links()}; in the construction pose no link is rotated} */
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

    /** {@return the pose of the camera, which sits in the centre of the head and looks along the head's x axis} */
    public Pose camera() {
        return link(HEAD);
    }

    /**
     * Returns the corners of a sole, from which the support polygon is made.
     *
     * @param leg the leg of the foot
     * @return front left, front right, rear right and rear left corner, in metres
     */
    public List<Vector3> soleCorners(Leg leg) {
        Link foot = model.links().get(model.linkIndex(leg.footLink()));
        Vector3 half = ((Shape.Box) foot.shape()).size().times(0.5);
        Pose pose = foot(leg);
        return List.of(
                pose.transform(new Vector3(half.y(), half.x(), -half.z())),
                pose.transform(new Vector3(half.y(), -half.x(), -half.z())),
                pose.transform(new Vector3(-half.y(), -half.x(), -half.z())),
                pose.transform(new Vector3(-half.y(), half.x(), -half.z())));
    }

    /** {@return the centre of mass of all links in metres} */
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

    /** The convex hull of all corners of solid links that touch the ground. */
    List<Vector3> supportPolygon() {
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
     * Returns the corners of the smallest box around a link's shape.
     *
     * @param link its index in {@link NaoModel#links()}
     * @return eight points in metres; bit 0 of an index is the side along SimSpark's x axis of the link, bit 1 along y, bit 2
     *     along z
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
