package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Somebody programs in the static page: javac and the machine for its classes are there. */
@InBrowser
@Timeout(300)
class ProgramInThePageTest {

    private static final String HEAD = "import org.robonewbie.agent.*;\nimport org.robonewbie.nao.Joint;\n";

    private final Chromium browser;
    private StaticServer server;

    ProgramInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
        browser.visit(server.address() + "#program");
        browser.await("studio.rooms.program?.files?.file !== undefined");
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void firstProgramRaisesTheArmTo31Degrees() {
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('left shoulder 31.2 degrees')");

        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void mistakeStandsAtItsLineInTheWordsOfJavac() {
        type(
                HEAD
                        + "public class MyAgent extends Agent {\n    protected void think() {\n        nao.sayy(\"x\");\n    }\n}\n");

        browser.await("document.querySelector('#program-room').innerText.includes('cannot find symbol')");

        assertThat(browser.evaluate("document.querySelector('#program-remarks').innerText")
                        .getAsString())
                .contains("5");
    }

    @ParameterizedTest
    @CsvSource({
        "new Thread(() -> {}).start();, This page has no threads",
        "new org.robonewbie.exercises.Grader();, press Check",
        "new java.util.Scanner(System.in);, neither files nor a keyboard",
        "java.time.Instant.now();, nao.getTime()"
    })
    void whatThePageLacksIsToldWithWhatToDo(String statement, String advice) {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n        " + statement
                + "\n    }\n}\n");

        browser.await("document.querySelector('#program-room').innerText.includes(" + Chromium.quoted(advice) + ")");
    }

    @Test
    void robotInTheHandWaitsInTheMiddleOfItsProgram() {
        type("""
                import org.robonewbie.agent.Nao;
                public class MyAgent {
                    public static void main(String[] args) {
                        try (Nao nao = Nao.connect(args)) {
                            nao.perform("wave");
                            System.out.println("waved until " + nao.getTime());
                        }
                    }
                }
                """);
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('waved until')");
    }

    @Test
    void endlessLoopIsStoppedAndNamed() {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n        while (true) {\n"
                + "        }\n    }\n}\n");
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('Stopped at MyAgent.java:5')");
    }

    @Test
    void stoppedLoopShowsNoCallsOfThePageItself() {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n        while (true) {\n"
                + "        }\n    }\n}\n");
        browser.click("#program-run");
        browser.await("document.querySelector('#program-room').innerText.includes('Stopped at MyAgent.java:5')");

        assertThat(browser.evaluate("document.querySelector('#program-room').innerText")
                        .getAsString())
                .doesNotContain("Fake");
    }

    @Test
    void firstProgramOfTheReadmeRunsInTheFileThatIsOpen() throws IOException {
        Matcher block =
                Pattern.compile("(?ms)^```java\\R(.*?)^```").matcher(Files.readString(Path.of("..", "README.md")));
        assertThat(block.find()).isTrue();
        type(block.group(1));
        browser.click("#program-run");

        browser.await("studio.state.frame.cycle > 100");
        assertThat(browser.evaluate("document.querySelector('#program-state').innerText")
                        .getAsString())
                .startsWith("MyAgent.java is running");
    }

    @Test
    void pageWithoutARobotSaysWhatToDoHere() {
        type("""
                public class MyAgent {
                    public static void main(String[] args) {
                        System.out.println("done");
                    }
                }
                """);
        browser.click("#program-run");
        browser.await("studio.state.scene?.robots.length === 0");
        browser.evaluate("location.hash = '#field'");

        browser.await("document.querySelector('#banner').innerText.includes('Choose an agent in the bar')");
    }

    @Test
    void enumerationsAndRecordsOfTheProgramWork() {
        type("""
                import org.robonewbie.agent.Agent;
                public class MyAgent extends Agent {
                    enum Mood { GLAD }
                    record Pair(int one, Mood other) {}
                    protected void think() {
                        System.out.println(new Pair(1, Mood.GLAD));
                    }
                }
                """);
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('Pair[one=1, other=GLAD]')");
    }

    @Test
    void exceptionIsNamedWithItsLineAndTheRobotGoesOn() {
        type(HEAD + "public class MyAgent extends Agent {\n    protected void think() {\n"
                + "        int[] numbers = {1, 2};\n        log.info(\"\" + numbers[2]);\n    }\n}\n");
        browser.click("#program-run");

        browser.await("document.querySelector('#program-room').innerText.includes('MyAgent.java:6')");
        assertThat(browser.evaluate("document.querySelector('#program-state').innerText")
                        .getAsString())
                .contains("is running");
    }

    private void type(String text) {
        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted(text) + ")");
    }
}
