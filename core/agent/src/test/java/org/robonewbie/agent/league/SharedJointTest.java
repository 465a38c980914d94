package org.robonewbie.agent.league;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.robot.BoosterK1;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.NaoRobot;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

class SharedJointTest {

    private static final RobotModel NAO = NaoRobot.of(RobotType.TYPE_0);
    private static final Vector3 FORWARD = new Vector3(1, 0, 0);

    static Stream<Arguments> partsOfArmsAndHead() {
        Vector3 left = new Vector3(0, 1, 0);
        Vector3 right = new Vector3(0, -1, 0);
        return Stream.of(BoosterT1.MODEL, BoosterK1.MODEL)
                .flatMap(model -> Stream.of(
                        Arguments.of(model, "lupperarm", outer(model, "lae3"), left),
                        Arguments.of(model, "llowerarm", outer(model, "lae4"), left),
                        Arguments.of(model, "rupperarm", outer(model, "rae3"), right),
                        Arguments.of(model, "rlowerarm", outer(model, "rae4"), right),
                        Arguments.of(model, "head", outer(model, "he2"), FORWARD)));
    }

    /** Returns the name of the body that a motor moves. */
    private static String outer(RobotModel model, String motor) {
        RobotJoint joint = model.joint(motor).orElseThrow();
        return model.bodies().get(joint.body()).name();
    }

    @ParameterizedTest
    @MethodSource("partsOfArmsAndHead")
    void armsAndHeadPointWhereThoseOfANaoPoint(RobotModel model, String naoPart, String part, Vector3 along) {
        Random random = new Random(1);
        List<SharedJoint> shared = SharedJoint.of(model);
        for (int i = 0; i < 500; i++) {
            double[] nao = NAO.stanceDegrees();
            double[] robot = model.stanceDegrees();
            for (SharedJoint joint : shared) {
                double degrees = joint.joint().minDegrees()
                        + random.nextDouble()
                                * (joint.joint().maxDegrees() - joint.joint().minDegrees());
                nao[NAO.joint(joint.joint().name()).orElseThrow().index()] = degrees;
                robot[joint.index()] = joint.fromNao(degrees);
            }

            Vector3 expected = pose(NAO, nao, naoPart).rotation().apply(FORWARD);
            Vector3 direction = pose(model, robot, part).rotation().apply(along);

            assertThat(degreesBetween(expected, direction)).isLessThan(0.5);
        }
    }

    @ParameterizedTest
    @MethodSource("partsOfArmsAndHead")
    void measuredAnglesAreConvertedBack(RobotModel model) {
        SharedJoint.of(model)
                .forEach(joint -> assertThat(joint.toNao(joint.fromNao(12.5))).isEqualTo(12.5));
    }

    private static Pose pose(RobotModel model, double[] degrees, String body) {
        return model.bodyPoses(degrees).get(model.bodyIndex(body));
    }

    private static double degreesBetween(Vector3 one, Vector3 other) {
        return Angles.atan2(one.cross(other).length(), one.dot(other));
    }
}
