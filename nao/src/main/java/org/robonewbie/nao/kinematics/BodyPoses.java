package org.robonewbie.nao.kinematics;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.Shape;

/** Where the links of a robot are in one posture, as seen from the torso in the body frame. Unmodifiable. */
public final class BodyPoses {

    static final String HEAD = "head";

    private final NaoModel model;
    private final List<Pose> poses;

    BodyPoses(NaoModel model, List<Pose> poses) {
        this.model = model;
        this.poses = List.copyOf(poses);
    }

    /**
     * Lists the poses of all links.
     *
     * @return the centre and turn of each link in the order of {@link NaoModel#links()}; no link is turned in the construction
     *     pose
     */
    public List<Pose> links() {
        return poses;
    }

    /**
     * Looks up a link.
     *
     * @param name the link's name in {@link NaoModel}, such as {@code lfoot}
     * @return its centre and turn
     * @throws IllegalArgumentException if the robot has no such link
     */
    public Pose link(String name) {
        return poses.get(model.linkIndex(name));
    }

    /**
     * Looks up a foot.
     *
     * @param leg which leg's
     * @return centre and turn of the foot's box; the sole is 1 cm below the centre
     */
    public Pose foot(Leg leg) {
        return link(leg.footLink());
    }

    /**
     * Looks up the camera, which sits in the centre of the head and looks along the head's x axis.
     *
     * @return its place and turn
     */
    public Pose camera() {
        return link(HEAD);
    }

    /**
     * Finds the corners of a sole, for a look at the balance.
     *
     * @param leg which leg's foot
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

    /**
     * Calculates the point in which the robot would balance on a needle.
     *
     * @return the centre of mass of all links in metres
     */
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
}
