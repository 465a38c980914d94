package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.tcp.FrameEncoder;

/** What the agents of FC Portugal need beyond what all agents need; their messages are read as they read them. */
@Timeout(120)
class FcPortugalExpectationsTest {

    private static final Set<String> TAGS = Set.of(
            "time",
            "now",
            "GS",
            "unum",
            "team",
            "sl",
            "sr",
            "t",
            "pm",
            "GYR",
            "ACC",
            "HJ",
            "FRP",
            "n",
            "rt",
            "a",
            "ax",
            "c",
            "f",
            "See",
            "G1L",
            "G2L",
            "G1R",
            "G2R",
            "F1L",
            "F2L",
            "F1R",
            "F2R",
            "B",
            "P",
            "L",
            "pol",
            "id",
            "head",
            "rlowerarm",
            "llowerarm",
            "rfoot",
            "lfoot",
            "hear");

    @AutoClose
    private final LeagueServer server = new LeagueServer();

    private final TestAgent agent = server.join("Stars", 1);

    FcPortugalExpectationsTest() throws IOException {}

    @Test
    void numbersHaveTwoDecimalsAndNoExponent() throws IOException {
        for (int i = 0; i < 60; i++) {
            agent.send("(lae1 0.0000001)(rle3 " + Math.sin(i) + ")(syn)");
            String text = agent.receiveText().toString();
            FcPortugalParser parser = new FcPortugalParser(text);
            for (String tag = parser.nextTag(); !tag.isEmpty(); tag = parser.nextTag()) {
                int count = switch (tag) {
                    case "now", "t", "ax" -> 1;
                    case "rt", "a", "c", "f", "pol" -> 3;
                    default -> 0;
                };
                for (int number = 0; number < count; number++) {
                    assertThat(parser.number()).isBetween(-1000.0, 1000.0);
                }
            }
            assertThat(text).doesNotContainPattern("\\.[0-9]{3}|\\.[0-9][ )]|[0-9]e");
        }
    }

    @Test
    void eachTagIsKnownAndFollowedByABlankAlsoWhenNothingIsSeen() throws IOException {
        server.control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        server.control()
                .order(new Order.PlaceRobot(new PlayerNumber(TeamSide.LEFT, 1), new Vector3(-14.9, 9.9, 60), 135));
        Set<String> tags = new TreeSet<>();
        StringBuilder all = new StringBuilder();

        for (int i = 0; i < 60; i++) {
            agent.send("(lae1 -5)(rae1 -5)(he2 5)(say x)(syn)");
            String text = agent.receiveText().toString();
            all.append(text);
            tags.addAll(new FcPortugalParser(text).allTags());
        }

        assertThat(all.toString()).contains("(See )").doesNotContain("(See)");
        assertThat(TAGS).containsAll(tags);
        assertThat(tags).contains("time", "GS", "GYR", "ACC", "HJ", "See", "hear");
    }

    @Test
    void playModesHaveTheNamesThatTheAgentLooksUp() throws IOException {
        List<String> names = new ArrayList<>();
        for (PlayMode mode : PlayMode.simSparkModes()) {
            server.control().order(new Order.ChangePlayMode(mode));
            agent.exchange("(syn)");
            agent.send("(syn)");
            FcPortugalParser parser = new FcPortugalParser(agent.receiveText().toString());
            for (String tag = parser.nextTag(); !tag.equals("pm"); tag = parser.nextTag()) {
                assertThat(tag).isNotEmpty();
            }
            names.add(parser.word());
        }

        assertThat(names)
                .containsExactly(
                        "BeforeKickOff",
                        "KickOff_Left",
                        "KickOff_Right",
                        "PlayOn",
                        "KickIn_Left",
                        "KickIn_Right",
                        "corner_kick_left",
                        "corner_kick_right",
                        "goal_kick_left",
                        "goal_kick_right",
                        "offside_left",
                        "offside_right",
                        "GameOver",
                        "Goal_Left",
                        "Goal_Right",
                        "free_kick_left",
                        "free_kick_right",
                        "direct_free_kick_left",
                        "direct_free_kick_right",
                        "pass_left",
                        "pass_right");
    }

    @Test
    void lengthAndTextLeaveTheServerInOnePiece() throws IOException {
        List<Integer> pieces = new ArrayList<>();
        WritableByteChannel channel = new WritableByteChannel() {
            @Override
            public int write(ByteBuffer bytes) {
                pieces.add(bytes.remaining());
                bytes.position(bytes.limit());
                return pieces.get(pieces.size() - 1);
            }

            @Override
            public boolean isOpen() {
                return true;
            }

            @Override
            public void close() {}
        };
        MessageBuffer message = new MessageBuffer();
        message.append("(time (now 0.02))");

        new FrameEncoder().send(channel, message);

        assertThat(pieces).containsExactly(4 + message.length());
    }

    @Test
    void linesComeWithBothEndsForTheLocalisation() throws IOException {
        agent.exchange("(beam -5 0 0)(syn)");
        List<SeenLine> lines = List.of();
        for (int i = 0; i < 6; i++) {
            lines = agent.exchange("(syn)")
                    .vision()
                    .map(vision -> vision.lines())
                    .filter(seen -> !seen.isEmpty())
                    .orElse(lines);
        }

        assertThat(lines).hasSizeGreaterThan(5);
        assertThat(lines)
                .allSatisfy(line -> assertThat(line.start().distanceMetres()).isBetween(0.1, 40.0));
        assertThat(lines).allSatisfy(line -> assertThat(line.end()).isNotEqualTo(line.start()));
    }

    @Test
    void visionComesInEachThirdMessage() throws IOException {
        StringBuilder pattern = new StringBuilder();

        for (int i = 0; i < 12; i++) {
            pattern.append(agent.exchange("(syn)").vision().isPresent() ? 'S' : '-');
        }

        assertThat(pattern.toString()).matches("(S--){4}|(-S-){4}|(--S){4}");
    }

    @Test
    void passIsAcceptedAndGrantedBesideTheRestingBall() throws IOException {
        server.control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        server.control().order(new Order.PlaceRobot(new PlayerNumber(TeamSide.LEFT, 1), new Vector3(-0.4, 0, 0.4), 0));
        LeagueServer.cycles(agent, 10);

        agent.exchange("(pass)(syn)");

        assertThat(LeagueServer.cycles(agent, 2)).isEqualTo(PlayMode.PASS_LEFT);
    }

    @Test
    void twentyCharactersAreHeardWithTeamTimeAndDirectionAndMoreAreNot() throws IOException {
        String text = "abcdefghij0123456789";
        agent.send("(say " + text + ")(syn)");
        assertThat(agent.receiveText().toString() + nextText()).contains("(hear Stars 0.00 self " + text + ")");

        agent.send("(say " + text + "x)(syn)");
        assertThat(agent.receiveText().toString() + nextText()).doesNotContain("hear");
    }

    @Test
    void measuresAreDisturbedAsByTheOriginal() throws IOException {
        agent.exchange("(beam -5 0 0)(syn)");
        LeagueServer.cycles(agent, 100);
        List<Double> distances = new ArrayList<>();
        for (int i = 0; i < 300; i++) {
            agent.exchange("(syn)")
                    .vision()
                    .flatMap(vision -> vision.ball())
                    .ifPresent(ball -> distances.add(ball.distanceMetres()));
        }

        double mean = distances.stream().mapToDouble(value -> value).average().orElseThrow();
        double sigma = Math.sqrt(distances.stream()
                .mapToDouble(value -> (value - mean) * (value - mean))
                .average()
                .orElseThrow());
        assertThat(sigma / mean * 100).isCloseTo(0.0965, within(0.03));
    }

    private String nextText() throws IOException {
        agent.send("(syn)");
        return agent.receiveText().toString();
    }
}
