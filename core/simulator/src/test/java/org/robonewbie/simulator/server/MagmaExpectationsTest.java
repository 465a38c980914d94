package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What the agents of magmaOffenburg need beyond what all agents need. */
@Timeout(120)
class MagmaExpectationsTest {

    private static final String NUMBER = "-?[0-9]+\\.[0-9]{2}";
    private static final String THREE = NUMBER + " " + NUMBER + " " + NUMBER;
    private static final String GAME_STATE =
            "\\(GS (\\(unum [0-9]+\\) \\(team (left|right)\\) )?\\(sl [0-9]+\\) \\(sr [0-9]+\\)" + " \\(t " + NUMBER
                    + "\\) \\(pm [A-Za-z_]+\\)\\)";

    @AutoClose
    private final LeagueServer server = new LeagueServer();

    MagmaExpectationsTest() throws IOException {}

    @Test
    void gameStateHasNoOtherNodesThanThoseOfTheOriginal() throws IOException {
        for (String text : messages(60)) {
            assertThat(all("\\(GS .*?\\)\\)", text)).singleElement().asString().matches(GAME_STATE);
        }
    }

    @Test
    void stateOfTheBatteryWhichWouldHaveToBeWholeNumbersIsNotSent() throws IOException {
        assertThat(messages(30)).noneMatch(text -> text.contains("AgentState"));
    }

    @Test
    void forceGyroAndAccelerationHaveExactlyThreePartsInTheirOrder() throws IOException {
        int forces = 0;
        for (String text : messages(120)) {
            assertThat(all("\\(GYR .*?\\)\\)", text))
                    .singleElement()
                    .asString()
                    .matches("\\(GYR \\(n torso\\) \\(rt " + THREE + "\\)\\)");
            assertThat(all("\\(ACC .*?\\)\\)", text))
                    .singleElement()
                    .asString()
                    .matches("\\(ACC \\(n torso\\) \\(a " + THREE + "\\)\\)");
            for (String force : all("\\(FRP .*?\\)\\)", text)) {
                assertThat(force).matches("\\(FRP \\(n [lr]f\\) \\(c " + THREE + "\\) \\(f " + THREE + "\\)\\)");
                forces++;
            }
        }
        assertThat(forces).isGreaterThan(50);
    }

    /** Collects an agent's messages from its first one on. */
    private List<String> messages(int count) throws IOException {
        TestAgent agent = server.connect();
        agent.send("(scene rsg/agent/nao/nao.rsg)(syn)");
        List<String> messages = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            messages.add(agent.receiveText().toString());
            agent.send(i == 1 ? "(init (unum 1)(teamname Stars))(syn)" : "(syn)");
        }
        return messages;
    }

    private static List<String> all(String pattern, String text) {
        return Pattern.compile(pattern)
                .matcher(text)
                .results()
                .map(MatchResult::group)
                .toList();
    }
}
