package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotModels;
import org.robonewbie.robot.RobotState;

/**
 * The bodies of one robot in an RSMP scene, with the model that they belong to.
 *
 * <p>RSMP does not name models. A shipped model is recognised by its bodies: each lies where the model puts it at some angle of its
 * joint. Any other robot gets a model built from the scene, see {@link RsmpModel}.
 */
final class RsmpFigure {

    /** Largest deviation from a shipped model in metres and radians; the server rounds to four decimals. */
    private static final double TOLERANCE = 0.002;

    private final RsmpNode torso;
    private final RobotModel model;
    private final List<RsmpNode> bodies;
    private final boolean shipped;

    private RsmpFigure(RsmpNode torso, RobotModel model, List<RsmpNode> bodies, boolean shipped) {
        this.torso = torso;
        this.model = model;
        this.bodies = bodies;
        this.shipped = shipped;
    }

    /**
     * Recognises a robot.
     *
     * @param torso its torso in a full scene
     * @param last the same player's figure in the last full scene; a robot of the same nodes keeps its model
     */
    static RsmpFigure of(RsmpNode torso, Optional<RsmpFigure> last) {
        if (last.isPresent() && last.get().torso.isBuiltLike(torso)) {
            return last.get().with(torso);
        }
        return RobotModels.all().stream()
                .flatMap(model ->
                        bodies(model, torso).stream().map(bodies -> new RsmpFigure(torso, model, bodies, true)))
                .filter(figure -> figure.deviation() < TOLERANCE)
                .min(Comparator.comparingDouble(RsmpFigure::deviation))
                .orElseGet(() -> new RsmpFigure(torso, RsmpModel.of(torso), List.of(), false));
    }

    private RsmpFigure with(RsmpNode newTorso) {
        List<RsmpNode> newBodies = shipped ? bodies(model, newTorso).orElseThrow() : List.of();
        return new RsmpFigure(newTorso, model, newBodies, shipped);
    }

    /** Returns the state of the robot, given the pose of its torso's parent in the world frame. */
    RobotState state(Pose parent) {
        Pose pose = parent.times(torso.pose());
        if (!shipped) {
            return new RobotState.OfModel(model, pose, RsmpModel.degrees(model, torso));
        }
        double[] degrees = new double[model.joints().size()];
        for (RobotJoint joint : model.joints()) {
            degrees[joint.index()] = degrees(joint, turn(joint));
        }
        return RobotState.of(model, pose, degrees);
    }

    /**
     * Assigns nodes to the bodies of a model: the last transforms below a node are the bodies that it carries, those before are
     * its shapes.
     */
    private static Optional<List<RsmpNode>> bodies(RobotModel model, RsmpNode torso) {
        List<RsmpNode> nodes = new ArrayList<>();
        nodes.add(torso);
        int[] used = new int[model.bodies().size()];
        for (int i = 1; i < model.bodies().size(); i++) {
            int parent = model.bodies().get(i).parent();
            List<RsmpNode> transforms = nodes.get(parent).transforms();
            int first = transforms.size() - children(model, parent);
            if (first < 0) {
                return Optional.empty();
            }
            nodes.add(transforms.get(first + used[parent]++));
        }
        return Optional.of(nodes);
    }

    private static int children(RobotModel model, int parent) {
        return (int)
                model.bodies().stream().filter(body -> body.parent() == parent).count();
    }

    /** Returns the largest deviation of a body from where the model puts it at the nearest angle of its joint. */
    private double deviation() {
        double worst = 0;
        boolean[] hinged = new boolean[bodies.size()];
        for (RobotJoint joint : model.joints()) {
            Pose turn = turn(joint);
            Rotation ideal = Rotation.about(joint.axis(), degrees(joint, turn));
            Vector3 place = joint.anchor().minus(ideal.apply(joint.anchor()));
            worst = Math.max(worst, deviation(turn, new Pose(place, ideal)));
            hinged[joint.body()] = true;
        }
        for (int i = 1; i < hinged.length; i++) {
            if (!hinged[i]) {
                worst = Math.max(
                        worst,
                        deviation(bodies.get(i).pose(), model.bodies().get(i).pose()));
            }
        }
        return worst;
    }

    private static double deviation(Pose pose, Pose ideal) {
        double angle = pose.rotation().inverse().times(ideal.rotation()).angleDegrees();
        return Math.max(pose.position().minus(ideal.position()).length(), PortableMath.toRadians(angle));
    }

    /** Returns the motion of a joint's body from its pose at 0°. */
    private Pose turn(RobotJoint joint) {
        RobotBody body = model.bodies().get(joint.body());
        return body.pose().inverse().times(bodies.get(joint.body()).pose());
    }

    /** Returns the angle about a joint's axis that best matches a rotation, from -180 to 180 degrees. */
    private static double degrees(RobotJoint joint, Pose turn) {
        Rotation rotation = turn.rotation();
        Vector3 axis = joint.axis();
        double sine = rotation.x() * axis.x() + rotation.y() * axis.y() + rotation.z() * axis.z();
        double degrees = 2 * PortableMath.toDegrees(PortableMath.atan2(sine, rotation.w()));
        return degrees > 180 ? degrees - 360 : degrees < -180 ? degrees + 360 : degrees;
    }
}
