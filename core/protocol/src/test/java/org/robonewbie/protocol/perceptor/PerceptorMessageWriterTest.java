package org.robonewbie.protocol.perceptor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.JointAngles.ExtraHinge;

class PerceptorMessageWriterTest {

    private static final FootForce FORCE = new FootForce(new Vector3(0, 0.03, -0.01), new Vector3(-0.02, 0.11, 22.52));

    @Test
    void putsABlankIntoAnEmptyPicture() {
        assertThat(written(message(JointAngles.NONE, FootForces.NONE, Optional.of(Vision.NOTHING))))
                .isEqualTo("(See )");
    }

    @Test
    void separatesTruePositionsFromTheRestOfThePicture() {
        Vision vision = new Vision(
                List.of(),
                Optional.of(new PolarPosition(1, 2, 3)),
                List.of(),
                List.of(new Vision.SeenLine(new PolarPosition(1, 1, 1), new PolarPosition(2, 2, 2))),
                Optional.of(new Vector3(-1, 0, 0.5)),
                OptionalDouble.of(-90),
                Optional.of(new Vector3(0, 0, 0.042)));

        assertThat(written(message(JointAngles.NONE, FootForces.NONE, Optional.of(vision))))
                .isEqualTo(
                        "(See (B (pol 1.00 2.00 3.00)) (mypos -1.00 0.00 0.50) (myorien -90.00) (ballpos 0.00 0.00 0.04)"
                                + " (L (pol 1.00 1.00 1.00) (pol 2.00 2.00 2.00)))");
    }

    @Test
    void putsForcesAndToesWhereTheServerPutsThem() {
        JointAngles angles =
                JointAngles.measured(joint -> 0, List.of(new ExtraHinge("llj7", 2), new ExtraHinge("rlj7", 1)));
        FootForces forces =
                new FootForces(Optional.of(FORCE), Optional.of(FORCE), Optional.of(FORCE), Optional.of(FORCE));

        String text = written(message(angles, forces, Optional.empty()));

        String force = " (c 0.00 0.03 -0.01) (f -0.02 0.11 22.52))";
        assertThat(text)
                .contains("(HJ (n rlj5) (ax 0.00))(FRP (n rf)" + force + "(HJ (n rlj6) (ax 0.00))(FRP (n rf1)" + force
                        + "(HJ (n rlj7) (ax 1.00))(HJ (n llj1) (ax 0.00))")
                .endsWith("(HJ (n llj5) (ax 0.00))(FRP (n lf)" + force + "(HJ (n llj6) (ax 0.00))(FRP (n lf1)" + force
                        + "(HJ (n llj7) (ax 2.00))");
    }

    @Test
    void leavesOutWhatOldServersDoNotSend() {
        GameState state = new GameState(
                OptionalInt.empty(), Optional.empty(), OptionalInt.empty(), OptionalInt.empty(), 0, "PlayOn");
        Heard heard = new Heard(Optional.empty(), 1, OptionalDouble.of(90), "hi");

        assertThat(written(new PerceptorMessage(
                        OptionalDouble.empty(),
                        Optional.of(state),
                        List.of(heard),
                        Optional.empty(),
                        Optional.empty(),
                        JointAngles.NONE,
                        FootForces.NONE,
                        Optional.empty())))
                .isEqualTo("(GS (t 0.00) (pm PlayOn))(hear 1.00 90.00 hi)");
    }

    @Test
    void tellsTheTeamOnce() {
        GameState state = new GameState(
                OptionalInt.of(1), Optional.of(TeamSide.RIGHT), OptionalInt.of(2), OptionalInt.of(3), 4, "PlayOn");

        assertThat(written(new PerceptorMessage(
                        OptionalDouble.of(1),
                        Optional.of(state),
                        List.of(),
                        Optional.empty(),
                        Optional.empty(),
                        JointAngles.NONE,
                        FootForces.NONE,
                        Optional.empty())))
                .isEqualTo("(time (now 1.00))(GS (unum 1) (team right) (sl 2) (sr 3) (t 4.00) (pm PlayOn))");
    }

    private static PerceptorMessage message(JointAngles angles, FootForces forces, Optional<Vision> vision) {
        return new PerceptorMessage(
                OptionalDouble.empty(),
                Optional.empty(),
                List.of(),
                Optional.empty(),
                Optional.empty(),
                angles,
                forces,
                vision);
    }

    private static String written(PerceptorMessage message) {
        MessageBuffer buffer = new MessageBuffer();
        new PerceptorMessageWriter(buffer).write(message);
        return buffer.toString();
    }
}
