package org.robonewbie.protocol.perceptor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.EnumSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.FieldMarking;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.protocol.RecordedMessages;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenMarking;
import org.robonewbie.robot.BoosterK1;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotModel;

class LeagueMessageReaderTest {

    private static final Vector3 Y = new Vector3(0, 1, 0);
    private static final Vector3 Z = new Vector3(0, 0, 1);
    private static final List<String> T1 = RecordedMessages.load(RecordedMessages.LEAGUE_T1);

    private final LeagueMessageReader reader = new LeagueMessageReader(BoosterT1.MODEL, "RoboNewbie", 2);

    @Test
    void readsTheFirstMessageOfAT1() {
        LeaguePerception read = read(T1.get(0));

        PerceptorMessage message = read.message();
        assertThat(message.seconds()).hasValue(863.55);
        GameState game = message.gameState().orElseThrow();
        assertThat(game.playMode()).contains(PlayMode.BEFORE_KICK_OFF);
        assertThat(game.side()).contains(TeamSide.LEFT);
        assertThat(game.number()).isEqualTo(OptionalInt.of(2));
        assertThat(game.leftScore()).isEqualTo(OptionalInt.of(0));
        assertThat(read.position()).contains(new Vector3(-5, 21, 0.673));
        assertThat(read.orientation().orElseThrow().apply(new Vector3(1, 0, 0)).y())
                .isCloseTo(-1, within(1e-9));
        Vision vision = message.vision().orElseThrow();
        assertThat(vision.ball()).contains(new PolarPosition(21.5, 13.46, -2.63));
        assertThat(vision.landmarks())
                .contains(new SeenLandmark(Landmark.FLAG_2_LEFT, new PolarPosition(44.94, -30.05, -1.4)))
                .contains(new SeenLandmark(Landmark.GOAL_POST_1_LEFT, new PolarPosition(29.49, -49.73, 1.42)))
                .hasSize(6);
    }

    @Test
    void placesEachMarkingWhereTheServerHasIt() {
        Set<FieldMarking> seen = EnumSet.noneOf(FieldMarking.class);
        for (String message : T1) {
            LeaguePerception read = read(message);
            Pose camera = camera(read);
            List<SeenMarking> markings =
                    read.message().vision().map(Vision::markings).orElse(List.of());
            for (SeenMarking marking : markings) {
                PolarPosition polar = marking.position();
                Rotation direction =
                        Rotation.about(Z, polar.horizontalDegrees()).times(Rotation.about(Y, -polar.verticalDegrees()));
                Vector3 place = camera.transform(direction.apply(new Vector3(polar.distanceMetres(), 0, 0)));
                assertThat(place.distanceTo(marking.marking().position()))
                        .as(marking.marking().name())
                        .isLessThan(0.1);
                seen.add(marking.marking());
            }
        }

        assertThat(seen).hasSizeGreaterThan(15);
    }

    /** Returns the pose of the camera in the world frame. */
    private static Pose camera(LeaguePerception read) {
        double[] degrees = IntStream.range(0, BoosterT1.MODEL.joints().size())
                .mapToDouble(read.joints()::degrees)
                .toArray();
        Pose head = BoosterT1.MODEL.bodyPoses(degrees).get(BoosterT1.MODEL.bodyIndex("H2"));
        return new Pose(read.position().orElseThrow(), read.orientation().orElseThrow())
                .times(head)
                .times(new Pose(new Vector3(0.05, 0, 0.12), Rotation.NONE));
    }

    @Test
    void readsAllJointsOfEachMessage() {
        T1.forEach(message -> assertThat(joints(read(message), BoosterT1.MODEL)).allMatch(Double::isFinite));
        LeagueMessageReader ofK1 = new LeagueMessageReader(BoosterK1.MODEL, "RoboNewbie", 2);
        RecordedMessages.load(RecordedMessages.LEAGUE_K1)
                .forEach(message -> assertThat(joints(ofK1.read(buffer(message)), BoosterK1.MODEL))
                        .allMatch(Double::isFinite));
    }

    @Test
    void turnsTheSensorsOfTheTorsoIntoSimSparksFrame() {
        LeaguePerception read = read("(GYR (n torso_gyro) (rt 1.0 2.0 3.0))(ACC (n torso_acc) (a 4.0 5.0 9.8))");

        assertThat(read.message().gyro()).contains(new Vector3(-2, 1, 3));
        assertThat(read.message().accelerometer()).contains(new Vector3(-5, 4, 9.8));
    }

    @Test
    void hearsOthers() {
        LeaguePerception read = read("(MIC mic (30 aGFsbG8=)(-5 %%%)(x aGFsbG8=)(7))");

        assertThat(read.message().heard()).singleElement().satisfies(heard -> {
            assertThat(heard.text()).isEqualTo("hallo");
            assertThat(heard.directionDegrees()).hasValue(30);
            assertThat(heard.isOwn()).isFalse();
        });
    }

    @Test
    void seesPlayersWithTheirHeadsAndFeet() {
        LeaguePerception read = read("(See (P (team Blue)(id 3)(head (pol 2.0 1.0 3.0))(lfoot (pol 2.1 0.5 -20.0))))");

        assertThat(read.message().vision().orElseThrow().players())
                .singleElement()
                .satisfies(player -> {
                    assertThat(player.team()).isEqualTo("Blue");
                    assertThat(player.number()).isEqualTo(3);
                    assertThat(player.parts()).hasSize(2);
                });
    }

    @Test
    void theSideFollowsFromTheTeams() {
        assertThat(read("(GS (t 1.5)(pm PlayOn)(tl Red)(tr RoboNewbie)(sl 1)(sr 2))")
                        .message()
                        .gameState()
                        .orElseThrow()
                        .side())
                .contains(TeamSide.RIGHT);
        assertThat(read("(GS (t 1.5)(pm PlayOn)(tl Red)(sl 1)(sr 2))")
                        .message()
                        .gameState()
                        .orElseThrow()
                        .side())
                .isEmpty();
    }

    @Test
    void ignoresWhatIsIncompleteOrNotFinite() {
        LeaguePerception read = read("(quat (n q) (q 0 0 0 0))(pos (n p) (p 1 2))(HJ (n q_hj1)(ax 3.0)(vx ");

        assertThat(read.orientation()).isEmpty();
        assertThat(read.position()).isEmpty();
        assertThat(read.joints().degrees(0)).isNaN();
    }

    @Property
    void bearsAnyBytes(@ForAll byte[] bytes) {
        MessageBuffer message = new MessageBuffer();
        message.set(bytes);

        assertThat(reader.read(message)).isNotNull();
    }

    @Property(tries = 2000)
    void bearsDamagedMessages(@ForAll long seed) {
        Random random = new Random(seed);
        byte[] bytes = T1.get(random.nextInt(T1.size())).getBytes(StandardCharsets.US_ASCII);
        for (int i = 0; i < 20; i++) {
            bytes[random.nextInt(bytes.length)] = (byte) "() .-e0nanHJSeeMIC".charAt(random.nextInt(18));
        }
        MessageBuffer message = new MessageBuffer();
        message.set(bytes);

        assertThat(reader.read(message)).isNotNull();
    }

    private LeaguePerception read(String message) {
        return reader.read(buffer(message));
    }

    private static List<Double> joints(LeaguePerception read, RobotModel model) {
        return IntStream.range(0, model.joints().size())
                .mapToObj(i -> read.joints().degrees(i) + read.joints().degreesPerSecond(i))
                .toList();
    }

    private static MessageBuffer buffer(String message) {
        MessageBuffer buffer = new MessageBuffer();
        buffer.append(message);
        return buffer;
    }
}
