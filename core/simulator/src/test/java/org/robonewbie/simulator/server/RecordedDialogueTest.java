package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SimulationCycle;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * Repeats what an agent said to a real rcssserver3d 0.7.3 and compares the answers, field by field, to the last printed
 * digit. Only the time differs, since the real server had run before.
 */
class RecordedDialogueTest {

    private static final int CYCLES_UNTIL_BALL_RESTS = 100;

    /** Vision came with the first message of the recordings, so the agent had been connected for two cycles before. */
    private static final int CYCLES_BEFORE_SCENE = 1;

    @Test
    void oneAgentHearsWhatItHeardFromTheRealServer() throws IOException {
        List<String> recorded = recording("a_agent_100msgs_sync_fast_nonoise");
        Conversation conversation = new Conversation();
        conversation.cycles(CYCLES_UNTIL_BALL_RESTS);
        Conversation.Speaker agent = conversation.connect();
        conversation.cycles(CYCLES_BEFORE_SCENE);
        List<String> answers = new ArrayList<>();

        agent.say("(scene rsg/agent/nao/nao.rsg)(syn)");
        conversation.cycles(3);
        answers.add(agent.hear());
        agent.say("(init (unum 1)(teamname X))(syn)");
        conversation.cycles(1);
        answers.add(agent.hear());
        agent.say("(beam -3 0.5 0)(syn)");
        while (answers.size() < recorded.size()) {
            conversation.cycles(1);
            answers.add(agent.hear());
            agent.say("(he1 0)(syn)");
        }

        assertThat(differences(recorded, answers)).isEmpty();
    }

    /**
     * As in the recording, the robots of Alpha are beamed when they sleep already, so that they hang in the air, and those of
     * Beta while they still move.
     */
    @Test
    void fourAgentsHearEachOtherAsOnTheRealServer() throws IOException {
        List<String> recorded = recording("a_agent_two_teams_hear_playon_nonoise");
        Conversation conversation = new Conversation();
        conversation.cycles(CYCLES_UNTIL_BALL_RESTS);
        List<Conversation.Speaker> agents = new ArrayList<>();
        agents.add(conversation.join("Alpha", 1));
        agents.add(conversation.join("Alpha", 2));
        conversation.cycles(200);
        agents.add(conversation.join("Beta", 1));
        agents.add(conversation.join("Beta", 2));
        agents.get(0).say("(beam -3 0 0)");
        agents.get(1).say("(beam -1.5 1 180)");
        agents.get(2).say("(beam -2 0 0)");
        agents.get(3).say("(beam -4 -1 0)");
        conversation.cycles(200);
        do {
            conversation.cycles(1);
        } while (!conversation.newestMessage(0).contains("See"));
        List<String> answers = new ArrayList<>();

        for (int i = 1; i <= recorded.size(); i++) {
            if (i % 20 == 7) {
                agents.get(1).say("(say hallo)");
            }
            if (i % 20 == 10) {
                agents.get(2).say("(say boo)");
            }
            if (i % 20 == 13) {
                agents.get(0).say("(say me)");
            }
            if (i == 42) {
                conversation.playOn();
            }
            conversation.cycles(1);
            answers.add(conversation.newestMessage(0));
        }

        assertThat(differences(recorded, answers)).isEmpty();
    }

    /** Names what differs, such as {@code message 3: (B (pol 3.04 0.00 -9.71)) became …}. */
    private static List<String> differences(List<String> recorded, List<String> answers) {
        List<String> differences = new ArrayList<>();
        for (int i = 0; i < recorded.size(); i++) {
            String expected = comparable(recorded.get(i));
            String actual = comparable(answers.get(i));
            if (!expected.equals(actual)) {
                int start = StringDifference.start(expected, actual);
                differences.add("message " + (i + 1) + ": " + StringDifference.around(expected, start) + " became "
                        + StringDifference.around(actual, start));
            }
        }
        return differences;
    }

    private static final class StringDifference {

        static int start(String first, String second) {
            int i = 0;
            while (i < Math.min(first.length(), second.length()) && first.charAt(i) == second.charAt(i)) {
                i++;
            }
            return i;
        }

        static String around(String text, int position) {
            return text.substring(Math.max(0, position - 30), Math.min(text.length(), position + 20));
        }
    }

    private static String comparable(String message) {
        return message.replaceAll("\\(time \\(now [0-9.]+\\)\\)", "").replace("-0.00", "0.00");
    }

    private static List<String> recording(String name) throws IOException {
        String path = "/org/robonewbie/simulator/messages/" + name + ".txt.gz";
        try (InputStream stream = RecordedDialogueTest.class.getResourceAsStream(path);
                BufferedReader reader = new BufferedReader(
                        new InputStreamReader(new GZIPInputStream(stream), StandardCharsets.US_ASCII))) {
            return reader.lines().filter(line -> line.startsWith("(")).toList();
        }
    }

    /** A server without threads and clock. */
    private static final class Conversation {

        private final SimulationCycle cycle;

        Conversation() {
            cycle = new SimulationCycle(
                    WorldSettings.league()
                            .withParameters(SoccerParameters.league()
                                    .with("BeamNoiseXY=0")
                                    .with("BeamNoiseAngle=0"))
                            .withNoise(false),
                    RecordingTarget.NONE,
                    new RecordingConsole(),
                    Console.silent());
        }

        Speaker connect() {
            LocalLink link = new LocalLink(() -> {});
            cycle.connect(link.serverEnd(), true);
            return new Speaker(new TestAgent(link));
        }

        void cycles(int count) {
            for (int i = 0; i < count; i++) {
                cycle.readMessages();
                cycle.run();
            }
        }

        Speaker join(String team, int number) {
            Speaker speaker = connect();
            speaker.say("(scene rsg/agent/nao/nao.rsg)");
            cycles(1);
            speaker.say("(init (unum " + number + ")(teamname " + team + "))");
            cycles(1);
            return speaker;
        }

        /** What the agent with this index will get in the next cycle. */
        String newestMessage(int index) {
            return cycle.agents().get(index).connection().newestMessage().toString();
        }

        void playOn() {
            cycle.match().setPlayMode(PlayMode.PLAY_ON);
        }

        static final class Speaker {

            private final TestAgent agent;

            Speaker(TestAgent agent) {
                this.agent = agent;
            }

            void say(String text) {
                try {
                    agent.send(text);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            }

            String hear() throws IOException {
                return agent.receiveText().toString();
            }
        }
    }
}
