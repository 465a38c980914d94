package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Java features that do not work in the static page, and the messages about them: the table of docs/web.md, row by row. */
@Tag("slow")
@InBrowser
@Timeout(300)
class WhatThePageLacksTest {

    private static final String ROOM = "document.querySelector('#program-room').innerText";

    private final Chromium browser;
    private StaticServer server;

    WhatThePageLacksTest(Chromium browser) {
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

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "new Thread(() -> {}).start();                    | This page has no threads: let think() do a little",
                "new java.util.Timer();                           | This page has no threads: let think() do a little",
                "new java.util.concurrent.atomic.AtomicInteger(); | This page has no threads: let think() do a little",
                "java.util.concurrent.Executors.newCachedThreadPool(); | This page has no threads: let think() do a little",
                "java.nio.file.Path.of(\"x\");                    | Programs on this page cannot use files or the keyboard",
                "new java.net.Socket();                           | Programs on this page cannot use files or the keyboard",
                "new java.io.File(\"x\");                       | Programs on this page cannot use files or the keyboard",
                "new java.util.Scanner(\"x\");                    | Programs on this page cannot use files or the keyboard",
                "java.time.LocalDate.now();                       | Time on the pitch is nao.getTime(), in seconds",
                "new java.util.Date();                            | Time on the pitch is nao.getTime(), in seconds",
                "new org.robonewbie.exercises.Grader();           | Programs on this page cannot start trials",
                "org.robonewbie.trial.Trial.class.getName();      | Programs on this page cannot start trials",
                "org.robonewbie.simulator.server.Simulator.class.getName(); | Programs on this page cannot start trials",
                "new javax.swing.JFrame();                        | Programs on this page cannot open windows",
                "new java.awt.Color(1);                           | Programs on this page cannot open windows",
                "try { Thread.sleep(5); } catch (Exception e) {}   | This page has no threads: let think() do a little",
                "java.util.concurrent.TimeUnit.SECONDS.sleep(1);  | This page has no threads: let think() do a little",
                "java.util.EnumMap<?, ?> map = null;              | does not provide java.util.EnumMap: use HashMap or TreeMap instead",
                "java.math.BigDecimal one = null;                 | does not provide java.math.BigDecimal: use double instead",
                "java.util.UUID.randomUUID();                     | This page does not provide java.util.UUID"
            })
    void compilerNamesTheMissingClassAndAnAlternative(String statement, String said) {
        think(statement);

        browser.await(ROOM + ".includes(" + Chromium.quoted(said) + ")");
        assertThat(remarks()).containsAnyOf("cannot find symbol", "does not exist", "cannot access");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"a\".describeConstable();                     | The page does not provide java.lang.String.describeConstable. RoboNewbie on your computer supports this.",
                "log.info(String.class.getPackageName());       | java.lang.Class.getPackageName is not available. The page cannot do this; RoboNewbie on your computer can.",
                "log.info(getClass().getPackageName());         | Class.getPackageName() is not available for a class of the program. The page cannot do this",
                "java.util.Arrays.hashCode(new int[] {1});      | hashCode with an array of numbers or characters is not available",
                "String.valueOf(new char[] {'a'});              | with an array of numbers or characters is not available",
                "new StringBuilder().append(new Letters());     | An object of the program cannot be passed to Java classes as a java.lang.CharSequence",
                "log.info(String.format(\"%tY\", 1L));          | Unknown format conversion: t",
                "while (true) {}                                | Stopped at MyAgent.java:4: the program has executed 5000000 instructions"
            })
    void missingFeatureIsReportedWithItsLine(String statement, String said) {
        think(statement);
        browser.click("#program-run");

        browser.await(ROOM + ".includes(" + Chromium.quoted(said) + ")");
    }

    @ParameterizedTest
    @CsvSource({"1.5", "3.0"})
    void numbersAreWrittenWithAPointWhateverTheLocaleIs(String number) {
        think("log.info(\"written \" + String.format(java.util.Locale.GERMANY, \"%.1f\", " + number + "));");
        browser.click("#program-run");

        browser.await(ROOM + ".includes('written " + number + "')");
    }

    @Test
    void classThatExtendsOneOfJavasIsRefusedBeforeItRuns() {
        type("""
                import org.robonewbie.agent.Agent;
                public class MyAgent extends Agent {
                    static class Try extends java.util.ArrayList<String> {}
                    protected void think() { new Try(); }
                }
                """);
        browser.click("#program-run");

        browser.await(ROOM + ".includes('Try extends java.util.ArrayList, which this page does not support')");
    }

    @Test
    void documentedArrayMethodsWork() {
        think("double[] a = {3, 1}; java.util.Arrays.sort(a); int[] b = new int[2]; java.util.Arrays.fill(b, 7);"
                + " log.info(java.util.Arrays.toString(java.util.Arrays.copyOf(a, 1)) + java.util.Arrays.toString(b)"
                + " + java.util.Arrays.stream(a).sum() + java.util.Arrays.equals(b, b.clone())"
                + " + java.util.Arrays.toString(java.util.Arrays.copyOfRange(b, 1, 2)));"
                + " int[] c = {1, 2, 3}; System.arraycopy(c, 0, c, 1, 2); log.info(java.util.Arrays.toString(c));"
                + " java.util.List<double[]> d = java.util.List.of(a); Object e = new int[2][3];"
                + " log.info(d.get(0)[1] + \" \" + (e instanceof int[][]) + (e instanceof double[][]));");
        browser.click("#program-run");

        browser.await(ROOM + ".includes('[1.0][7, 7]4.0true[7]')");
        browser.await(ROOM + ".includes('[1, 1, 2]')");
        browser.await(ROOM + ".includes('3.0 truefalse')");
    }

    private String remarks() {
        return browser.evaluate("document.querySelector('#program-remarks').innerText")
                .getAsString();
    }

    private void think(String statement) {
        type(
                "import org.robonewbie.agent.Agent;\npublic class MyAgent extends Agent {\n    protected void think() {\n        "
                        + statement
                        + "\n    }\n    static class Letters implements CharSequence {\n"
                        + "        public int length() { return 1; }\n        public char charAt(int i) { return 'a'; }\n"
                        + "        public CharSequence subSequence(int a, int b) { return this; }\n    }\n}\n");
    }

    private void type(String text) {
        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted(text) + ")");
    }
}
