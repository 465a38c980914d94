package org.robonewbie.protocol.effector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Random;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.RobotJoint;

class LeagueMessageWriterTest {

    private static final int MESSAGES = 1_000_000;
    private static final double[] ODD = {
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        Double.MAX_VALUE,
        -Double.MAX_VALUE,
        Double.MIN_VALUE,
        -0.0,
        1e300,
        -1e-300
    };

    private final MessageBuffer message = new MessageBuffer();
    private final LeagueMessageWriter writer = new LeagueMessageWriter(message, BoosterT1.MODEL);

    @Test
    void writesTheWordsOfTheServer() {
        writer.join("Blue", 2);
        writer.beam(new Pose2d(-2, 0.5, 90));
        writer.motor(0, 20, 30, 40, 1.5, -2);
        writer.say("hallo");
        writer.nothing();

        assertThat(message)
                .hasToString("(init T1 Blue 2)(beam -2 0.5 90)(he1 20 30 40 1.5 -2)(SPK say 100 aGFsbG8=)(syn)");
    }

    @Test
    void anyNumbersBecomeFiniteAndStayInRange() {
        Random random = new Random(1);
        SexpReader reader = new SexpReader();
        IntFunction<Double> any = kind -> switch (kind) {
            case 0 -> ODD[random.nextInt(ODD.length)];
            case 1 -> Double.longBitsToDouble(random.nextLong());
            default -> 1000 * random.nextGaussian();
        };
        for (int i = 0; i < MESSAGES; i++) {
            RobotJoint joint = BoosterT1.MODEL
                    .joints()
                    .get(random.nextInt(BoosterT1.MODEL.joints().size()));
            message.clear();
            writer.motor(
                    joint.index(),
                    any.apply(random.nextInt(3)),
                    any.apply(random.nextInt(3)),
                    any.apply(random.nextInt(3)),
                    any.apply(random.nextInt(3)),
                    any.apply(random.nextInt(3)));

            double strongest = ((Motor.Torque) joint.motor()).maxNewtonMetres();
            reader.start(message);
            if (!(reader.nextList(0)
                    && reader.atomIs(joint.effectorName())
                    && isNextWithin(reader, joint.minDegrees(), joint.maxDegrees())
                    && isNextWithin(reader, -1000, 1000)
                    && isNextWithin(reader, 0, 500)
                    && isNextWithin(reader, 0, 20)
                    && isNextWithin(reader, -strongest, strongest)
                    && reader.next() == Token.CLOSE
                    && reader.next() == Token.END)) {
                throw new AssertionError("Message " + i + " is wrong: " + message);
            }
        }
    }

    private static boolean isNextWithin(SexpReader reader, double least, double most) {
        return reader.nextNumber() && reader.number() >= least - 5e-4 && reader.number() <= most + 5e-4;
    }

    @Test
    void aBeamIsFiniteToo() {
        writer.beam(new Pose2d(Double.NaN, 1e9, Double.NEGATIVE_INFINITY));

        assertThat(message).hasToString("(beam 0 100 0)");
    }

    @Test
    void refusesJointsThatTheRobotDoesNotHave() {
        assertThatThrownBy(() -> writer.motor(23, 0, 0, 0, 0, 0)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThat(message.length()).isZero();
    }

    @Test
    void refusesTextsThatTheServerWouldDrop() {
        assertThatThrownBy(() -> writer.say("elevenchars"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("at most 10 characters, but \"elevenchars\" has 11");
        assertThat(message.length()).isZero();
    }

    @Test
    void refusesTeamNamesThatWouldBreakTheMessage() {
        assertThatThrownBy(() -> writer.join("a) (b", 1)).isInstanceOf(IllegalArgumentException.class);
        assertThat(message.length()).isZero();
    }
}
