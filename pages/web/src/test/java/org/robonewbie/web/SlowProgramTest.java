package org.robonewbie.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.robonewbie.pagejvm.JavaSource;
import org.robonewbie.pagejvm.Program;

/** Messages of the page about idle or slow programs, which no other thread can watch there. */
class SlowProgramTest {

    @Test
    void namesTheLineOfAProgramThatComputesTooMuchInEachCycle() {
        String said = saidBy("Slow", """
                import org.robonewbie.agent.Agent;
                public class Slow extends Agent {
                    private double sum;
                    protected void think() {
                        for (int i = 0; i < 100000; i++) {
                            sum += Math.sin(i);
                        }
                    }
                }
                """);

        assertThat(said)
                .containsOnlyOnce("The program executes more than 500000 instructions in one cycle")
                .containsPattern("at Slow\\.java:[56]\\. There are 50 cycles per simulated second")
                .contains("Compute less in a cycle");
    }

    @Test
    void isSilentAboutAProgramThatIsSlowAtItsBeginning() {
        String said = saidBy("Table", """
                import org.robonewbie.agent.Agent;
                public class Table extends Agent {
                    private double sum;
                    protected void think() {
                        for (int i = 0; sum == 0 && i < 100000; i++) {
                            double value = Math.sin(i);
                        }
                        sum = 1;
                    }
                }
                """);

        assertThat(said).isEmpty();
    }

    @Test
    void saysThatThinkIsMisspelt() {
        assertThat(saidBy("Speller", """
                import org.robonewbie.agent.Agent;
                public class Speller extends Agent {
                    protected void thnik() {}
                }
                """)).contains("Speller has no think(); did you mean thnik()?");
        assertThat(saidBy("Timer", """
                import org.robonewbie.agent.Agent;
                public class Timer extends Agent {
                    protected void think(double seconds) {}
                }
                """))
                .contains("Timer has no think(); think(...) is never called, since think() has no parameters");
    }

    private static String saidBy(String name, String source) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PrintStream output = new PrintStream(bytes, true, StandardCharsets.UTF_8);
        HeadlessRun.of(new Program(JavaSource.compile(name, source).values()), output, 1, 0.6);
        return bytes.toString(StandardCharsets.UTF_8);
    }
}
