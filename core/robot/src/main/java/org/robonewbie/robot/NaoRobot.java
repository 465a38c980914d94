package org.robonewbie.robot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.model.Shape;

/** The five NAOs of SimSpark: {@link NaoModel} in the body frame. In the stance all joints are at 0°. */
public final class NaoRobot {

    private static final List<RobotModel> MODELS =
            Arrays.stream(RobotType.values()).map(NaoRobot::model).toList();

    private NaoRobot() {}

    /**
     * Returns the model of a robot type.
     *
     * @param type the robot type
     * @return its model, named {@code nao0} to {@code nao4}
     */
    public static RobotModel of(RobotType type) {
        return MODELS.get(type.ordinal());
    }

    /**
     * Returns whether a model is one of the five NAOs.
     *
     * @param model the model of any robot
     * @return whether {@link #of} returns it for one of the types
     */
    public static boolean isNao(RobotModel model) {
        return MODELS.contains(model);
    }

    /**
     * Returns the robot type of a model.
     *
     * @param model the model of any robot
     * @return the robot type; empty if the model is none of the NAOs'
     */
    public static Optional<RobotType> typeOf(RobotModel model) {
        int index = MODELS.indexOf(model);
        return index < 0 ? Optional.empty() : Optional.of(RobotType.values()[index]);
    }

    private static RobotModel model(RobotType type) {
        NaoModel nao = NaoModel.of(type);
        List<RobotBody> bodies = new ArrayList<>();
        nao.links().forEach(link -> bodies.add(body(nao, link)));
        List<RobotJoint> joints = new ArrayList<>();
        nao.hinges().forEach(hinge -> joints.add(joint(nao, hinge, joints.size())));
        return new RobotModel("nao" + type.ordinal(), bodies, joints, soleDepth(nao));
    }

    private static RobotBody body(NaoModel nao, Link link) {
        int parent = nao.hinges().stream()
                .filter(hinge -> hinge.child().equals(link.name()))
                .mapToInt(hinge -> nao.linkIndex(hinge.parent()))
                .findFirst()
                .orElse(RobotBody.NO_PARENT);
        Vector3 origin = parent < 0 ? Vector3.ZERO : nao.links().get(parent).position();
        Shape shape = turned(link.shape());
        MassDistribution mass = MassDistribution.of(shape, link.massKg());
        return new RobotBody(
                link.name(),
                parent,
                new Pose(SimSparkFrame.toBody(link.position().minus(origin)), Rotation.NONE),
                mass.massKg(),
                Pose.ORIGIN,
                mass.inertia(),
                List.of(new PlacedShape(shape, Pose.ORIGIN, link.collides())));
    }

    private static RobotJoint joint(NaoModel nao, Hinge hinge, int index) {
        int body = nao.linkIndex(hinge.child());
        return new RobotJoint(
                index,
                hinge.jointName(),
                hinge.perceptorName(),
                hinge.effectorName(),
                body,
                SimSparkFrame.toBody(hinge.anchor().minus(nao.links().get(body).position())),
                SimSparkFrame.toBody(hinge.axis()),
                hinge.minDegrees(),
                hinge.maxDegrees(),
                new Motor.Speed(hinge.maxRadiansPerSecond()),
                0);
    }

    /** Exchanges x and y of a box; spheres and capsules look the same from all sides. */
    private static Shape turned(Shape shape) {
        return shape instanceof Shape.Box box
                ? new Shape.Box(
                        new Vector3(box.size().y(), box.size().x(), box.size().z()))
                : shape;
    }

    private static double soleDepth(NaoModel nao) {
        return nao.links().stream()
                .mapToDouble(
                        link -> link.shape().size().z() / 2 - link.position().z())
                .max()
                .orElseThrow();
    }
}
