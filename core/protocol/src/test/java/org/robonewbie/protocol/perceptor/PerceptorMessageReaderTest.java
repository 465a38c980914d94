package org.robonewbie.protocol.perceptor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.JointAngles.ExtraHinge;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;

class PerceptorMessageReaderTest {

    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    @Test
    void readsTimeAndGameState() {
        PerceptorMessage message =
                read("(time (now 46.20))(GS (unum 3) (team right) (sl 1) (sr 2) (t 12.34) (pm corner_kick_left))");

        assertThat(message.seconds()).hasValue(46.2);
        assertThat(message.gameState())
                .contains(new GameState(
                        OptionalInt.of(3),
                        Optional.of(TeamSide.RIGHT),
                        OptionalInt.of(1),
                        OptionalInt.of(2),
                        12.34,
                        "corner_kick_left"));
        assertThat(message.gameState().orElseThrow().playMode()).contains(PlayMode.CORNER_KICK_LEFT);
    }

    @Test
    void keepsThePlayModeOfANewerServer() {
        GameState state = read("(GS (t 0.00) (pm kick_catch_left))").gameState().orElseThrow();

        assertThat(state.playModeName()).isEqualTo("kick_catch_left");
        assertThat(state.playMode()).isEmpty();
        assertThat(state.leftScore()).isEmpty();
    }

    @Test
    void skipsUnknownPartsOfTheGameState() {
        GameState state = read("(GS (k left) (ti (1 2)) (t 5.00) (pm PlayOn) (foul 3))")
                .gameState()
                .orElseThrow();

        assertThat(state.playSeconds()).isEqualTo(5);
        assertThat(state.playModeName()).isEqualTo("PlayOn");
    }

    @Test
    void readsGyroAndAccelerometer() {
        PerceptorMessage message = read("(GYR (n torso) (rt 0.24 -0.05 0.02))(ACC (n torso) (a -0.00 nan 9.80))");

        assertThat(message.gyro()).contains(new Vector3(0.24, -0.05, 0.02));
        assertThat(message.accelerometer()).contains(new Vector3(-0.0, Double.NaN, 9.8));
    }

    @Test
    void readsJointAnglesInAnyOrder() {
        JointAngles angles =
                read("(HJ (ax -12.50) (n llj4))(HJ (n hj1) (ax 3.00))").jointAngles();

        assertThat(angles.degrees(Joint.LEFT_KNEE_PITCH)).hasValue(-12.5);
        assertThat(angles.degrees(Joint.NECK_YAW)).hasValue(3);
        assertThat(angles.degrees(Joint.NECK_PITCH)).isEmpty();
        assertThat(angles.degreesOr(Joint.NECK_PITCH, 7)).isEqualTo(7);
    }

    @Test
    void readsToes() {
        PerceptorMessage message = read("(FRP (n rf1) (c 0.01 0.02 0.03) (f 1.00 2.00 3.00))(HJ (n rlj7) (ax 5.00))");

        assertThat(message.jointAngles().extraHinges()).containsExactly(new ExtraHinge("rlj7", 5));
        assertThat(message.footForces().rightToe())
                .contains(new FootForce(new Vector3(0.01, 0.02, 0.03), new Vector3(1, 2, 3)));
        assertThat(message.footForces().right()).isEmpty();
    }

    @Test
    void readsFootForces() {
        FootForces forces = read("(FRP (n lf) (c 0 0 -0.01) (f 0 0 22.5))").footForces();

        assertThat(forces.left()).contains(new FootForce(new Vector3(0, 0, -0.01), new Vector3(0, 0, 22.5)));
        assertThat(forces.right()).isEmpty();
    }

    @Test
    void readsWhatTheCameraSees() {
        Vision vision = read("(See (G2R (pol 17.55 -3.33 4.31)) (B (pol 8.51 -0.21 -0.17))"
                        + " (P (team myteam) (id 3) (rlowerarm (pol 0.18 -35.78 -21.65)))"
                        + " (L (pol 12.11 -40.77 -2.40) (pol 12.95 37.76 nan)))")
                .vision()
                .orElseThrow();

        assertThat(vision.landmarks())
                .containsExactly(new SeenLandmark(Landmark.GOAL_POST_2_RIGHT, new PolarPosition(17.55, -3.33, 4.31)));
        assertThat(vision.ball()).contains(new PolarPosition(8.51, -0.21, -0.17));
        assertThat(vision.players()).hasSize(1);
        SeenPlayer player = vision.players().get(0);
        assertThat(player.team()).isEqualTo("myteam");
        assertThat(player.number()).isEqualTo(3);
        assertThat(player.parts())
                .containsExactly(new SeenBodyPart(BodyPart.RIGHT_LOWER_ARM, new PolarPosition(0.18, -35.78, -21.65)));
        assertThat(vision.lines())
                .containsExactly(new SeenLine(
                        new PolarPosition(12.11, -40.77, -2.4), new PolarPosition(12.95, 37.76, Double.NaN)));
    }

    @Test
    void tellsAnEmptyPictureFromNone() {
        assertThat(read("(See )").vision()).contains(Vision.NOTHING);
        assertThat(read("(See)").vision()).contains(Vision.NOTHING);
        assertThat(read("(time (now 1.00))").vision()).isEmpty();
    }

    @Test
    void readsTruePositionsWhereTheServerSendsThem() {
        Vision vision = read("(See (mypos -1.00 0.50 0.54) (myorien 12.00) (ballpos 0.00 0.00 0.04))")
                .vision()
                .orElseThrow();

        assertThat(vision.ownPosition()).contains(new Vector3(-1, 0.5, 0.54));
        assertThat(vision.ownOrientationDegrees()).hasValue(12);
        assertThat(vision.ballPosition()).contains(new Vector3(0, 0, 0.04));
    }

    @Test
    void readsPlayersOfVeryOldServers() {
        SeenPlayer player = read("(See (P (team A) (id 2) (pol 1.00 2.00 3.00)))")
                .vision()
                .orElseThrow()
                .players()
                .get(0);

        assertThat(player.position()).contains(new PolarPosition(1, 2, 3));
        assertThat(player.parts()).isEmpty();
    }

    @Test
    void skipsWhatItDoesNotKnowInAPicture() {
        Vision vision = read("(See (CNR (ffs 1 2 3 4)) (P (team A) (id 1) (tail (pol 1 2 3))) (B (pol 1 2 3)))")
                .vision()
                .orElseThrow();

        assertThat(vision.ball()).contains(new PolarPosition(1, 2, 3));
        assertThat(vision.players().get(0).parts()).isEmpty();
    }

    @Test
    void hearsWithAndWithoutTeamNames() {
        PerceptorMessage message = read("(hear Alpha 0.12 33.90 hallo)(hear Alpha 0.24 self me)(hear 1.50 -20.00 old)");

        assertThat(message.heard())
                .containsExactly(
                        new Heard(Optional.of("Alpha"), 0.12, OptionalDouble.of(33.9), "hallo"),
                        new Heard(Optional.of("Alpha"), 0.24, OptionalDouble.empty(), "me"),
                        new Heard(Optional.empty(), 1.5, OptionalDouble.of(-20), "old"));
        assertThat(message.heard().get(1).isOwn()).isTrue();
    }

    @Test
    void ignoresHearsThatMakeNoSense() {
        assertThat(read("(hear)(hear a)(hear a b c d)(hear 1 2 3 4 5)(hear (a) b c)")
                        .heard())
                .isEmpty();
    }

    @Test
    void leavesOutWhatIsIncomplete() {
        PerceptorMessage message =
                read("(GYR (n torso) (rt 1 2))(ACC (n torso) (a))(HJ (n hj1))(HJ (ax 5))(HJ (n) (ax 5))"
                        + "(FRP (n lf) (c 1 2 3))(time)(See (B (pol 1 2)) (B) (L (pol 1 2 3)) (mypos 1) (myorien x))");

        assertThat(message)
                .isEqualTo(new PerceptorMessage(
                        OptionalDouble.empty(),
                        Optional.empty(),
                        List.of(),
                        Optional.empty(),
                        Optional.empty(),
                        JointAngles.NONE,
                        FootForces.NONE,
                        Optional.of(Vision.NOTHING)));
    }

    @Test
    void doesNotTakeACutNumberForTheWholeOne() {
        PerceptorMessage message = read("(time (now 1.00))(HJ (n hj1) (ax 4");

        assertThat(message.seconds()).hasValue(1);
        assertThat(message.jointAngles()).isEqualTo(JointAngles.NONE);
    }

    @Test
    void skipsUnknownPerceptors() {
        PerceptorMessage message =
                read("(AgentState (temp 48) (battery 75))(HJ (n tail) (ax 1))(TCH n x (val 1))(time (now 2.00))");

        assertThat(message.seconds()).hasValue(2);
    }

    @Test
    void readsEachMessageAnew() {
        read(
                "(time (now 1.00))(GS (t 0.00) (pm PlayOn))(HJ (n hj1) (ax 5.00))(hear A 1.00 self x)(See (B (pol 1 2 3)))");

        PerceptorMessage second = read("");

        assertThat(second.seconds()).isEmpty();
        assertThat(second.gameState()).isEmpty();
        assertThat(second.jointAngles()).isEqualTo(JointAngles.NONE);
        assertThat(second.heard()).isEmpty();
        assertThat(second.vision()).isEmpty();
    }

    private PerceptorMessage read(String text) {
        MessageBuffer buffer = new MessageBuffer();
        buffer.append(text);
        return reader.read(buffer);
    }
}
