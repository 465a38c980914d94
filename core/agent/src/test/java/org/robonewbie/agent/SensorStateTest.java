package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.agent.perception.HeardMessage;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.T1Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.perceptor.Heard;

class SensorStateTest {

    private final RobotRuntime runtime = new RobotRuntime("test");
    private final Robot nao = new Robot(runtime);

    @Test
    void turnsVectorsIntoTheBodysFrame() {
        runtime.sense(Messages.standing()
                .gyro(10, 20, 30)
                .accelerometer(1, 2, 9)
                .leftFoot(new Vector3(0.01, 0.02, -0.01), new Vector3(1, 2, 22))
                .build());

        assertThat(nao.getGyro()).isEqualTo(new Vector3(20, -10, 30));
        assertThat(nao.getAcceleration()).isEqualTo(new Vector3(2, -1, 9));
        assertThat(nao.getLeftFootPressure().point()).isEqualTo(new Vector3(0.02, -0.01, -0.01));
        assertThat(nao.getLeftFootPressure().force()).isEqualTo(new Vector3(2, -1, 22));
        assertThat(nao.getLeftFootPressure().isTouching()).isTrue();
        assertThat(nao.getRightFootPressure().isTouching()).isFalse();
    }

    @Test
    void reportsThatANaoHasNoJointsOfAT1() {
        nao.setJointAngle(T1Joint.WAIST, 30);

        assertThat(nao.getJointAngle(T1Joint.WAIST)).isZero();
        assertThat(runtime.diagnostics().reported())
                .singleElement()
                .asString()
                .contains(
                        "This robot is a NAO, which does not have the joints of a T1: run the program with --robot T1");
    }

    @Test
    void readsTheGame() {
        runtime.sense(Messages.standing()
                .at(3.5)
                .in(PlayMode.KICK_OFF_LEFT)
                .on(TeamSide.RIGHT)
                .build());

        assertThat(nao.getTime()).isEqualTo(3.5);
        assertThat(nao.getPlayTime()).isEqualTo(3.5);
        assertThat(nao.getPlayMode()).isEqualTo(PlayMode.KICK_OFF_LEFT);
        assertThat(nao.getTeamSide()).isEqualTo(TeamSide.RIGHT);
        assertThat(nao.getNumber()).isEqualTo(4);
        assertThat(nao.getOwnScore()).isEqualTo(1);
        assertThat(nao.getOpponentScore()).isEqualTo(2);
    }

    @Test
    void keepsNumberAndSideThatAreSentOnlyOnce() {
        runtime.sense(Messages.standing().on(TeamSide.RIGHT).build());
        runtime.sense(Messages.standing().withoutNumber().build());

        assertThat(nao.getNumber()).isEqualTo(4);
        assertThat(nao.getTeamSide()).isEqualTo(TeamSide.RIGHT);
    }

    @Test
    void keepsTheLastReadingWhenTheNextIsNoNumber() {
        runtime.sense(Messages.standing().gyro(1, 2, 3).accelerometer(0, 0, 9).build());
        runtime.sense(Messages.standing()
                .gyro(Double.NaN, 0, 0)
                .accelerometer(0, Double.POSITIVE_INFINITY, 0)
                .build());

        assertThat(nao.getGyro()).isEqualTo(new Vector3(2, -1, 3));
        assertThat(nao.getAcceleration()).isEqualTo(new Vector3(0, 0, 9));
    }

    @Test
    void readsJointAnglesInDegrees() {
        runtime.sense(Messages.standing()
                .posture(Posture.ZERO.with(Joint.RIGHT_ARM_YAW, 42.5))
                .build());

        assertThat(nao.getJointAngle(Joint.RIGHT_ARM_YAW)).isEqualTo(42.5);
    }

    @Test
    void hearsOthersButNotItself() {
        Heard own = new Heard(Optional.of("Blue"), 1, OptionalDouble.empty(), "me");
        Heard other = new Heard(Optional.of("Blue"), 1, OptionalDouble.of(-30), "100%");

        runtime.sense(Messages.standing().heard(own, other).build());

        assertThat(nao.getHeard())
                .isEqualTo(List.of(new HeardMessage("100%", Optional.of("Blue"), OptionalDouble.of(-30))));
    }

    @Test
    void feelsThatItLiesOnItsBack() {
        for (int i = 0; i < 30; i++) {
            runtime.sense(Messages.standing().accelerometer(0, 9.81, 0).build());
        }

        assertThat(nao.isFallen()).isTrue();
        assertThat(nao.getBodyPosition()).isEqualTo(BodyPosition.LYING_ON_BACK);
    }
}
