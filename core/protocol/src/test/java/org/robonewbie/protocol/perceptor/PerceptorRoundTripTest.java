package org.robonewbie.protocol.perceptor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;
import org.robonewbie.nao.BodyPart;
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

class PerceptorRoundTripTest {

    @Property(tries = 300, shrinking = ShrinkingMode.OFF, edgeCases = EdgeCasesMode.NONE)
    void everyMessageThatCanBeWrittenIsReadTheSame(@ForAll("messages") PerceptorMessage message) {
        MessageBuffer buffer = new MessageBuffer();
        new PerceptorMessageWriter(buffer).write(message);

        PerceptorMessage read = new PerceptorMessageReader().read(buffer);

        assertThat(read).isEqualTo(message);
    }

    @Provide
    Arbitrary<PerceptorMessage> messages() {
        return Combinators.combine(
                        numbers(), gameStates(), heards().list().ofMaxSize(3), vectors(), angles(), forces(), visions())
                .as((seconds, state, heard, vector, angles, forces, vision) -> new PerceptorMessage(
                        OptionalDouble.of(seconds), state, heard, vector, vector, angles, forces, vision));
    }

    private static Arbitrary<Double> numbers() {
        Arbitrary<Double> hundredths =
                Arbitraries.integers().between(-100_000, 100_000).map(n -> n / 100.0);
        return Arbitraries.oneOf(hundredths, Arbitraries.of(-0.0, Double.NaN));
    }

    private static Arbitrary<String> words() {
        return Arbitraries.strings().withChars("abcXYZ019_-.").ofMinLength(1).ofMaxLength(20);
    }

    private static Arbitrary<Optional<GameState>> gameStates() {
        Arbitrary<String> playModes = Arbitraries.of(PlayMode.class).map(PlayMode::simSparkName);
        Arbitrary<Integer> goals = Arbitraries.integers().between(0, 99);
        return Combinators.combine(
                        Arbitraries.integers().between(1, 11),
                        Arbitraries.of(TeamSide.class),
                        Arbitraries.of(true, false),
                        goals,
                        goals,
                        numbers(),
                        playModes)
                .as((number, side, first, left, right, seconds, playMode) -> new GameState(
                        first ? OptionalInt.of(number) : OptionalInt.empty(),
                        first ? Optional.of(side) : Optional.empty(),
                        OptionalInt.of(left),
                        OptionalInt.of(right),
                        seconds,
                        playMode))
                .optional();
    }

    private static Arbitrary<Heard> heards() {
        Arbitrary<OptionalDouble> directions = numbers().map(OptionalDouble::of);
        return Combinators.combine(
                        words().optional(),
                        numbers(),
                        Arbitraries.oneOf(directions, Arbitraries.of(OptionalDouble.empty())),
                        words())
                .as(Heard::new);
    }

    private static Arbitrary<Optional<Vector3>> vectors() {
        return Combinators.combine(numbers(), numbers(), numbers())
                .as(Vector3::new)
                .optional();
    }

    private static Arbitrary<JointAngles> angles() {
        Arbitrary<List<ExtraHinge>> toes = numbers()
                .optional()
                .map(degrees -> degrees.stream()
                        .flatMap(angle -> Stream.of(new ExtraHinge("rlj7", angle), new ExtraHinge("llj7", angle)))
                        .toList());
        return Combinators.combine(numbers().array(double[].class).ofSize(22), toes)
                .as((degrees, extra) -> JointAngles.measured(joint -> degrees[joint.ordinal()], extra));
    }

    private static Arbitrary<FootForces> forces() {
        Arbitrary<Vector3> vectors =
                Combinators.combine(numbers(), numbers(), numbers()).as(Vector3::new);
        Arbitrary<Optional<FootForce>> force =
                Combinators.combine(vectors, vectors).as(FootForce::new).optional();
        return Combinators.combine(force, force, force, force).as(FootForces::new);
    }

    private static Arbitrary<PolarPosition> positions() {
        return Combinators.combine(numbers(), numbers(), numbers()).as(PolarPosition::new);
    }

    private static Arbitrary<Optional<Vision>> visions() {
        Arbitrary<SeenLandmark> landmarks =
                Combinators.combine(Arbitraries.of(Landmark.class), positions()).as(SeenLandmark::new);
        Arbitrary<SeenBodyPart> parts =
                Combinators.combine(Arbitraries.of(BodyPart.class), positions()).as(SeenBodyPart::new);
        Arbitrary<SeenPlayer> players = Combinators.combine(
                        words(),
                        Arbitraries.integers().between(0, 11),
                        parts.list().ofMaxSize(5),
                        positions().optional())
                .as(SeenPlayer::new);
        Arbitrary<SeenLine> lines =
                Combinators.combine(positions(), positions()).as(SeenLine::new);
        return Combinators.combine(
                        landmarks.list().ofMaxSize(8),
                        positions().optional(),
                        players.list().ofMaxSize(4),
                        lines.list().ofMaxSize(5),
                        vectors(),
                        numbers().map(OptionalDouble::of),
                        vectors())
                .as(Vision::new)
                .optional();
    }
}
