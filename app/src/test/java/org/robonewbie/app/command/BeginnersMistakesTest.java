package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.process.JavaCommand;

/** What whole programs with the mistakes of beginners say, and with which exit code their process ends. */
class BeginnersMistakesTest {

    private static final String[] SHORT = {"--headless", "--fast", "--seed", "1", "--seconds", "0.8"};

    @TempDir
    private Path folder;

    private record Ended(int exitCode, String output) {}

    @Tag("slow")
    @Test
    void sleepingIsNamedWithLineAndTime() throws Exception {
        Ended ended = agent("Sleeper", "", "try { Thread.sleep(100); } catch (InterruptedException e) { }");

        assertThat(ended.exitCode()).isZero();
        assertThat(ended.output())
                .containsOnlyOnce(
                        " ms; it is called 50 times per simulated second. Count cycles or compare nao.getTime()"
                                + " instead. (Sleeper.java:7)")
                .containsPattern("think\\(\\) slept \\d{3,} ms;")
                .doesNotContain("without a mistake");
    }

    @Tag("slow")
    @Test
    void sleepingBetweenTwoMessagesIsNamedToo() throws Exception {
        Ended ended = main("Stepper", """
                try (Nao nao = Nao.connect(args)) {
                    while (nao.sense()) {
                        nao.act();
                        java.util.concurrent.TimeUnit.MILLISECONDS.sleep(100);
                    }
                }
                """);

        assertThat(ended.output())
                .containsPattern(
                        "The program slept \\d{3,} ms; sense\\(\\) must be called 50 times per simulated second\\."
                                + " Count cycles or compare nao\\.getTime\\(\\) instead\\. \\(Stepper\\.java:\\d+\\)");
    }

    @Test
    void thinkThatIsMisspeltIsAskedFor() throws Exception {
        Ended ended = agent("Speller", "protected void thnik() { }", null);

        assertThat(ended.output())
                .contains("Speller has no think(); did you mean thnik()?")
                .doesNotContain("without a mistake");
    }

    @Tag("slow")
    @Test
    void missingMotionOfAProgramInTheHandEndsWithExitCodeOne() throws Exception {
        Ended closed = main("Closed", "try (Nao nao = Nao.connect(args)) { nao.perform(\"wawe\"); }");
        Ended open = main("Open", "Nao nao = Nao.connect(args); nao.perform(\"wawe\");");
        Ended right = main("Right", "try (Nao nao = Nao.connect(args)) { nao.sense(); }");

        assertThat(closed.exitCode()).isEqualTo(1);
        assertThat(open.exitCode()).isEqualTo(1);
        assertThat(right.exitCode()).as(right.output()).isZero();
        assertThat(closed.output())
                .containsOnlyOnce("There is no motion \"wawe\". Did you mean \"wave\"?")
                .containsPattern("\\(Closed\\.java:\\d+\\)");
    }

    @Tag("slow")
    @Test
    void allMemoryIsOneSentenceWithTheLine() throws Exception {
        Ended thinking = agent("Hoarder", "", "long[] much = new long[Integer.MAX_VALUE];");
        Ended made = main("Maker", "long[] much = new long[Integer.MAX_VALUE];");

        assertThat(thinking.exitCode()).isEqualTo(1);
        assertThat(thinking.output())
                .containsOnlyOnce("think() ran out of memory; the run ends here.")
                .contains("(Hoarder.java:7)")
                .doesNotContain("at org.robonewbie", "OutOfMemoryError");
        assertThat(made.exitCode()).isEqualTo(1);
        assertThat(made.output())
                .containsPattern("Maker ran out of memory;.*\\(Maker\\.java:\\d+\\)")
                .doesNotContain("    at ");
    }

    @Tag("slow")
    @Test
    void fieldsThatCannotBePreparedAreNamedWithTheirLine() throws Exception {
        Ended instance = agent("Fields", "int[] numbers = new int[-1];", "");
        Ended statics = agent("Statics", "static int speed = Integer.parseInt(\"fast\");", "");

        assertThat(instance.exitCode()).isEqualTo(1);
        assertThat(instance.output())
                .contains("Fields ended with java.lang.NegativeArraySizeException: -1 (Fields.java:6)")
                .doesNotContain("at org.robonewbie", "at java.base");
        assertThat(statics.exitCode()).isEqualTo(1);
        assertThat(statics.output())
                .contains(
                        "Statics ended with java.lang.NumberFormatException: For input string: \"fast\" (Statics.java:6)")
                .doesNotContain("at org.robonewbie", "at java.base", "Caused by");
    }

    @Tag("slow")
    @Test
    void recursionWithoutEndIsOneLine() throws Exception {
        Ended ended = main("Deep", "main(args);");

        assertThat(ended.exitCode()).isEqualTo(1);
        assertThat(ended.output())
                .containsPattern("Deep ended with java\\.lang\\.StackOverflowError \\(Deep\\.java:\\d+\\)")
                .doesNotContain("    at ");
    }

    @Tag("slow")
    @Test
    void gradingEndsSoonWithTheLineOfASleep() throws Exception {
        Path file = write("RaiseArms", "", "try { Thread.sleep(200); } catch (InterruptedException e) { }");

        Ended ended = robonewbie("grade", "raise-arms", file.toString(), "--seeds", "1");

        assertThat(ended.exitCode()).isEqualTo(1);
        assertThat(ended.output())
                .containsPattern(
                        "0 points +think\\(\\) slept \\d{3,} ms at RaiseArms\\.java:7; it is called 50 times per simulated"
                                + " second\\.")
                .contains("Hint: Count cycles or compare nao.getTime() instead.");
    }

    @Tag("slow")
    @Test
    void damagedProgressIsSaidOnceAndKept() throws Exception {
        Files.writeString(folder.resolve("progress.json"), "{\"version\": 1, \"exercises\": {\"raise-a");
        Path file = write("RaiseArms", "", "leaveGame();");

        Ended first = robonewbie("grade", "raise-arms", file.toString(), "--seeds", "1");
        Ended second = robonewbie("grade");

        assertThat(first.output())
                .containsOnlyOnce("progress.json is damaged and is treated as empty. Your next attempt renames it to ")
                .contains("progress.json.damaged");
        assertThat(folder.resolve("progress.json.damaged")).content().endsWith("raise-a");
        assertThat(second.output()).doesNotContain("damaged");
    }

    @Test
    void listOfExercisesHasTicksAndBestPoints() throws Exception {
        Files.writeString(folder.resolve("progress.json"), """
                {"version": 1, "exercises": {
                  "raise-arms": {"tries": 2, "bestPoints": 10, "passed": true},
                  "kick": {"tries": 1, "bestPoints": 4.5, "passed": false}}}
                """);

        Ended ended = robonewbie("grade");

        assertThat(ended.output())
                .contains("The exercises, with your best points:")
                .containsPattern("(?m)^[✓+?] 10\\.0 01-raise-arms")
                .containsPattern("(?m)^   4\\.5 12-kick")
                .containsPattern("(?m)^       02-stop-at-30")
                .contains("1 of ", "robonewbie grade --progress");
    }

    private Ended agent(String name, String members, @Nullable String think) throws Exception {
        return run(write(name, members, think));
    }

    private Path write(String name, String members, @Nullable String think) throws IOException {
        String step = think == null ? "" : "@Override protected void think() {\n" + think + "\n}";
        return Files.writeString(folder.resolve(name + ".java"), """
                import org.robonewbie.agent.Agent;
                public class %1$s extends Agent {
                    public static void main(String[] args) {
                        new %1$s().run(args);
                    }
                    %2$s%3$s
                }
                """.formatted(name, members, step));
    }

    private Ended main(String name, String statements) throws Exception {
        return run(Files.writeString(folder.resolve(name + ".java"), """
                import org.robonewbie.agent.Nao;
                public class %s {
                    public static void main(String[] args) throws Exception {
                        %s
                    }
                }
                """.formatted(name, statements)));
    }

    private Ended run(Path file) throws Exception {
        return robonewbie(Stream.concat(Stream.of("run", file.toString()), Stream.of(SHORT))
                .toArray(String[]::new));
    }

    private Ended robonewbie(String... words) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(JavaCommand.of(
                        List.of("-Xmx128m"), ClassPath.ofThisProgram(), "org.robonewbie.app.Main", List.of(words)))
                .directory(folder.toFile())
                .redirectErrorStream(true);
        builder.environment()
                .put("ROBONEWBIE_PROGRESS", folder.resolve("progress.json").toString());
        Process process = builder.start();
        process.getOutputStream().close();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Ended(process.waitFor(), output);
    }
}
