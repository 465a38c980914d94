package org.robonewbie.agent.league;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.T1Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorCommand.Synchronise;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotJoint;

class LeaguePortTest {

    private static final String GAME = "(time (now 1.0))(GS (t 0.0)(pm BeforeKickOff)(tl Blue)(sl 0)(sr 0))";

    private final Server server = new Server();
    private final RobotRuntime robot = new RobotRuntime("test");
    private final LeaguePort port = new LeaguePort(
            server,
            robot,
            new LeaguePlayer(BoosterT1.MODEL, "Blue", 2),
            LearnedWalk.of(BoosterT1.MODEL, Optional.empty()),
            true);

    @Test
    void joinsWithItsFirstMessage() throws IOException {
        send(CreateRobot.of(0));

        assertThat(server.sent).containsExactly("(init T1 Blue 2)");
    }

    @Test
    void answersEachMessageWithTheTargetsOfAllMotors() throws IOException {
        send(new Beam(new Pose2d(-2, 0, 90)));

        String sent = server.sent.get(0);
        assertThat(sent).startsWith("(beam -2 0 90)");
        for (RobotJoint joint : BoosterT1.MODEL.joints()) {
            assertThat(sent).containsOnlyOnce("(" + joint.effectorName() + " ");
        }
    }

    @Test
    void armsAreMeasuredWithTheAnglesOfANao() throws IOException {
        receive(GAME + joint("q_laj1", -120) + joint("q_laj2", -60) + joint("q_hj2", 20));

        assertThat(port.message().jointAngles().degrees(Joint.LEFT_SHOULDER_PITCH))
                .hasValue(30);
        assertThat(port.message().jointAngles().degrees(Joint.LEFT_SHOULDER_YAW))
                .hasValue(30);
        assertThat(port.message().jointAngles().degrees(Joint.NECK_PITCH)).hasValue(-20);
        assertThat(port.message().jointAngles().degrees(Joint.LEFT_KNEE_PITCH)).isEmpty();
        assertThat(port.message().footForces().left()).isEmpty();
    }

    @Test
    void aSpeedMovesTheTargetOfAnArm() throws IOException {
        receive(GAME + joint("q_laj1", -90));
        for (int i = 0; i < 50; i++) {
            send();
        }

        send(speed(Joint.LEFT_SHOULDER_PITCH, 100));
        double first = target("lae1");
        send();

        assertThat(target("lae1") - first).isCloseTo(-2, within(1e-3));
    }

    @Test
    void aTargetNeverRunsFarAheadOfItsJoint() throws IOException {
        receive(GAME + joint("q_laj1", -90));
        for (int i = 0; i < 50; i++) {
            send();
        }
        for (int i = 0; i < 50; i++) {
            send(speed(Joint.LEFT_SHOULDER_PITCH, 300));
        }

        assertThat(target("lae1")).isCloseTo(-100, within(1e-9));
    }

    @Test
    void reportsOnceThatLegsStandByThemselves() throws IOException {
        send(speed(Joint.LEFT_KNEE_PITCH, 50), speed(Joint.RIGHT_KNEE_PITCH, 50));
        send(speed(Joint.LEFT_KNEE_PITCH, 50));

        assertThat(robot.diagnostics().reported())
                .singleElement()
                .asString()
                .contains("The T1 stands and walks by itself: commands and motions for its legs are ignored")
                .contains("LEFT_KNEE_PITCH");
    }

    @Test
    void jointsOfAT1AreReadAndMovedWithTheirOwnAngles() throws IOException {
        receive(GAME + joint("q_tj1", 12.5) + joint("q_llj4", 41));
        assertThat(robot.sensors().ownJoints().orElseThrow().degrees(T1Joint.WAIST))
                .isEqualTo(12.5);
        assertThat(robot.sensors().ownJoints().orElseThrow().degrees(T1Joint.LEFT_KNEE_PITCH))
                .isEqualTo(41);

        robot.commands().setJointAngle(T1Joint.WAIST, 30);
        robot.commands().setJointAngle(T1Joint.LEFT_KNEE_PITCH, 60, 100, 3);
        robot.commands().setJointAngle(T1Joint.LEFT_SHOULDER_PITCH, -45);
        send();

        assertThat(motor("te1")).isEqualTo("30 0 200 5 0");
        assertThat(motor("lle4")).isEqualTo("60 0 100 3 0");
        assertThat(motor("rle4")).isEqualTo("1 0 200 5 0");
        assertThat(motor("lae1")).isEqualTo("-45 0 60 1.5 0");
    }

    @Test
    void aSpeedForANaosJointMovesAnArmOnFromItsOwnTarget() throws IOException {
        receive(GAME + joint("q_laj1", -45));
        robot.commands().setJointAngle(T1Joint.LEFT_SHOULDER_PITCH, -45, 20, 1);
        for (int i = 0; i < 50; i++) {
            send();
        }

        send(speed(Joint.LEFT_SHOULDER_PITCH, 100));

        assertThat(motor("lae1")).isEqualTo("-47 -100 60 1.5 0");
    }

    @Test
    void targetsBeyondTheRangeAreLimitedAndReported() throws IOException {
        receive(GAME);
        robot.commands().setJointAngle(T1Joint.WAIST, 120, 900, -1);
        robot.commands().setJointAngle(T1Joint.LEFT_KNEE_PITCH, Double.NaN);
        send();

        assertThat(motor("te1")).isEqualTo("89.954 0 500 0 0");
        assertThat(motor("lle4")).isEqualTo("1 0 200 5 0");
        assertThat(String.join("\n", robot.diagnostics().reported()))
                .contains("Joint angle 120.0 for WAIST is beyond its range of -90 to 90 degrees")
                .contains("Stiffness 900.0 and damping -1.000 of WAIST are limited to 0 to 500 Nm/rad")
                .contains("A target for LEFT_KNEE_PITCH that is not a finite number is ignored");
    }

    @Test
    void walkingTakesTheJointsBackButTheHead() throws IOException {
        receive(GAME);
        robot.commands().setJointAngle(T1Joint.WAIST, 30);
        for (int i = 0; i < 50; i++) {
            send();
        }
        assertThat(target("te1")).isEqualTo(30);

        for (int i = 0; i < 100; i++) {
            robot.walk().towards(0.5, 0, 0);
            robot.commands().setJointAngle(T1Joint.WAIST, 30);
            robot.commands().setJointAngle(T1Joint.NECK_YAW, 20);
            robot.act();
            send();
        }

        assertThat(target("te1")).isZero();
        assertThat(target("he1")).isEqualTo(20);
        assertThat(String.join("\n", robot.diagnostics().reported()))
                .contains("While the T1 walks, only its head obeys: the target for WAIST is ignored");
    }

    @Test
    void raisedArmsMakeTheRobotLeanBack() throws IOException {
        receive(GAME + joint("q_laj1", -90));
        for (int i = 0; i < 50; i++) {
            send();
        }

        assertThat(target("lle5")).isBetween(-19.0, -18.0);
    }

    @Test
    void aBeamStartsFromStretchedJointsAndEndsInTheStance() throws IOException {
        receive(GAME);
        for (int i = 0; i < 50; i++) {
            send();
        }
        double stance = target("lle4");

        send(new Beam(Pose2d.ORIGIN));
        double first = target("lle4");
        for (int i = 0; i < 50; i++) {
            send();
        }

        assertThat(first).isBetween(0.0, 2.0);
        assertThat(target("lle4")).isEqualTo(stance).isEqualTo(40);
    }

    @Test
    void aBeamInPlayIsNotSent() throws IOException {
        receive("(GS (t 0.0)(pm PlayOn)(tl Blue)(sl 0)(sr 0))");

        send(new Beam(Pose2d.ORIGIN));

        assertThat(server.sent.get(0)).doesNotContain("beam");
    }

    @Test
    void theRightTeamBeamsInItsOwnFrame() throws IOException {
        receive("(GS (t 0.0)(pm BeforeKickOff)(tl Red)(tr Blue)(sl 0)(sr 0))");

        send(new Beam(new Pose2d(-2, 1, 90)));

        assertThat(server.sent.get(0)).startsWith("(beam -2 -1 90)");
    }

    @Test
    void theCameraTurnsWithTheNeck() throws IOException {
        Pose ahead = robot.sensors().cameraPose();
        receive(GAME + joint("q_hj2", 90));
        Pose down = robot.sensors().cameraPose();

        assertThat(ahead.position().distanceTo(new Vector3(0.1125, 0, 0.42485))).isLessThan(1e-9);
        assertThat(down.position().distanceTo(new Vector3(0.1825, 0, 0.25485))).isLessThan(1e-9);
        assertThat(down.rotation().apply(new Vector3(1, 0, 0)).z()).isCloseTo(-1, within(1e-9));
    }

    @Test
    void picturesContainTheTruth() throws IOException {
        receive("(GS (t 0.0)(pm PlayOn)(tl Red)(tr Blue)(sl 0)(sr 0))(quat (n torso_quat) (q 1 0 0 0))"
                + "(pos (n torso_pos) (p 3 2 0.6))(See (B (pol 2 0 0)))" + joint("q_hj2", 0));

        Vision seen = port.message().vision().orElseThrow();
        assertThat(seen.ownPosition().orElseThrow().distanceTo(new Vector3(-3.1125, -2, 1.02485)))
                .isLessThan(1e-9);
        assertThat(Math.abs(seen.ownOrientationDegrees().orElseThrow())).isCloseTo(180, within(1e-9));
        assertThat(seen.ballPosition().orElseThrow().distanceTo(new Vector3(-5.1125, -2, 1.02485)))
                .isLessThan(1e-9);
    }

    @Test
    void aFallenRobotLiesStretchedUntilItIsPlaced() throws IOException {
        for (int i = 0; i < 80; i++) {
            receive(GAME + "(ACC (n torso_acc) (a 9.81 0 0))");
            send(speed(Joint.LEFT_SHOULDER_PITCH, 100), speed(Joint.LEFT_KNEE_PITCH, 50));
        }

        assertThat(target("lae1")).isZero();
        assertThat(target("lle4")).isZero();
        assertThat(robot.diagnostics().reported())
                .filteredOn(report -> report.contains("has fallen and cannot get up"))
                .hasSize(1);
        for (int i = 0; i < 80; i++) {
            receive(GAME + "(ACC (n torso_acc) (a 0 0 9.81))");
            send();
        }
        assertThat(target("lle4")).isEqualTo(40);
    }

    @Test
    void aRobotThatTheRefereePlacesStartsFromStretchedJoints() throws IOException {
        receive(GAME + joint("q_laj1", -90));
        for (int i = 0; i < 50; i++) {
            send();
        }

        receive(GAME + joint("q_laj1", 0));
        send();

        assertThat(target("lle4")).isBetween(0.0, 2.0);
    }

    @Test
    void hasNoForceSensorsInItsFeet() {
        assertThat(robot.sensors().hasFootSensors()).isFalse();
        assertThat(robot.sensors().modelName()).isEqualTo("T1");
    }

    @Test
    void saysWhatTheServerPassesOn() throws IOException {
        send(new Say("hallo"), new Say("aVeryLongText"));

        assertThat(server.sent.get(0)).startsWith("(SPK say 100 aGFsbG8=)(he1 ");
        assertThat(robot.diagnostics().reported()).singleElement().asString().contains("at most 10 characters");
    }

    @Test
    void saysWhyTheServerMayHaveClosedTheConnection() {
        assertThatThrownBy(port::receive)
                .isInstanceOf(IOException.class)
                .hasMessage("it closed the connection. It has number 2 of team Blue already (choose another --number),"
                        + " both teams are full, or it does not know the robot T1.");
    }

    @Test
    void recognisesAServerThatSpeaksSimSpark() {
        server.next.add("(time (now 1.00))(GS (t 0.00) (pm BeforeKickOff))(HJ (n hj1) (ax 0.00))");

        assertThatThrownBy(port::receive)
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith("it speaks SimSpark's protocol, so it has NAOs only: leave out --robot T1");
    }

    private static SetHingeSpeed speed(Joint joint, double degreesPerSecond) {
        return new SetHingeSpeed(joint.effectorName(), PortableMath.toRadians(degreesPerSecond));
    }

    private void receive(String message) throws IOException {
        server.next.add(message + joint("q_hj1", 0));
        port.receive();
        robot.sense(port.message());
    }

    private void send(EffectorCommand... commands) throws IOException {
        List<EffectorCommand> all = new ArrayList<>(List.of(commands));
        all.add(new Synchronise());
        port.send(all);
    }

    private static String joint(String name, double degrees) {
        return "(HJ (n " + name + ")(ax " + degrees + ")(vx 0.0))";
    }

    private double target(String motor) {
        String numbers = motor(motor);
        return Double.parseDouble(numbers.substring(0, numbers.indexOf(' ')));
    }

    /** Returns the numbers of a motor in the last answer. */
    private String motor(String name) {
        String last = server.sent.get(server.sent.size() - 1);
        String after = last.substring(last.indexOf("(" + name + " ") + name.length() + 2);
        return after.substring(0, after.indexOf(')'));
    }

    /** Connection to a server that sends the given messages and then ends. */
    private static final class Server implements AgentLink {

        private final List<String> next = new ArrayList<>();
        private final List<String> sent = new ArrayList<>();

        @Override
        public void send(MessageBuffer message) {
            sent.add(message.toString());
        }

        @Override
        public boolean receive(MessageBuffer message) {
            if (next.isEmpty()) {
                return false;
            }
            message.clear();
            message.append(next.remove(0));
            return true;
        }

        @Override
        public void close() {
            // nothing to close
        }
    }
}
