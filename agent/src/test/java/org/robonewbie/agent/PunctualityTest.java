package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.log.LogLine;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import student.Dreamer;

class PunctualityTest {

    @Test
    void reportsACycleForWhichAServerInRealTimeDidNotWait() throws Exception {
        try (ScriptedServer server = ScriptedServer.inRealTime(script(100))) {
            Nao nao = Nao.connect(options(server));
            while (nao.getTime() < 1.5 && nao.sense()) {
                nao.act();
            }
            nao.sense();
            thinkForMilliseconds(30);
            Dreamer.dreamUntil(server::isPlayed);
            nao.act();
            List<String> lines = nao.log().lines().stream().map(LogLine::text).toList();
            nao.close();

            assertThat(nao.mistakes().reported())
                    .singleElement()
                    .asString()
                    .contains("ms, but the simulator waits only 20 ms and has gone on; compute less in a cycle, and log"
                            + " instead of printing. Late cycles so far: ");
            assertThat(lines).anyMatch(line -> line.matches("cycle \\d+ came late: it took \\d+ ms"));
        }
    }

    @Test
    void reportsLateCyclesAgainAfterTenSeconds() throws Exception {
        try (ScriptedServer server = ScriptedServer.inRealTime(script(100, 0.2))) {
            Nao nao = Nao.connect(options(server));
            for (double seconds : new double[] {3, 5, 13}) {
                while (nao.getTime() < seconds && nao.sense()) {
                    nao.act();
                }
                nao.sense();
                thinkForMilliseconds(30);
                Dreamer.dreamUntil(server::isPlayed);
                nao.act();
            }
            nao.close();

            assertThat(nao.mistakes().reported()).hasSize(2).allMatch(line -> line.contains("Late cycles so far: "));
        }
    }

    @Test
    void saysInWhichLineALateCycleSpentItsTime() throws Exception {
        Mistakes mistakes = new Mistakes(new PrintStream(OutputStream.nullOutputStream()));
        try (Watchdog watchdog = new Watchdog(mistakes, Optional.empty())) {
            watchdog.thinkBegins();
            Dreamer.dreamUntil(() -> !watchdog.slowPlace().isEmpty());
            String slowPlace = watchdog.slowPlace();
            boolean forgotten = isForgottenWithTheNextThought(watchdog);

            assertThat(slowPlace).matches("Dreamer\\.java:\\d+");
            assertThat(forgotten).isTrue();
        }
    }

    @Test
    void neverCallsAnAgentLateForWhichTheServerWaits() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(100))) {
            Nao nao = Nao.connect(options(server));
            while (nao.getTime() < 1.5 && nao.sense()) {
                nao.act();
            }
            nao.sense();
            thinkForMilliseconds(30);
            nao.act();
            nao.close();

            assertThat(nao.mistakes().reported()).isEmpty();
        }
    }

    /** On a busy computer the next thought may itself be slow before anybody has looked; so there are some of them. */
    private static boolean isForgottenWithTheNextThought(Watchdog watchdog) {
        for (int i = 0; i < 100; i++) {
            watchdog.thinkBegins();
            if (watchdog.slowPlace().isEmpty()) {
                return true;
            }
        }
        return false;
    }

    private static Options options(ScriptedServer server) {
        return Options.none().with("host", "127.0.0.1").with("port", Integer.toString(server.port()));
    }

    private static void thinkForMilliseconds(int milliseconds) {
        long end = System.nanoTime() + milliseconds * 1_000_000L;
        while (System.nanoTime() < end) {
            Thread.onSpinWait();
        }
    }

    private static List<PerceptorMessage> script(int length) {
        return script(length, 0.02);
    }

    private static List<PerceptorMessage> script(int length, double secondsPerMessage) {
        List<PerceptorMessage> script = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            script.add(Messages.standing().at(secondsPerMessage * i).build());
        }
        return script;
    }
}
