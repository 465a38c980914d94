package org.robonewbie.app.doctor;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.process.JavaCommand;

/** Creates a project as {@code robonewbie new} does and runs its program; both must work without a network. */
final class ProjectCheck {

    private static final String SUBJECT = "A project";
    private static final String AGENT = "src/main/java/room/MyAgent.java";
    private static final String GREETING = "Started a simulator";
    private static final int MAX_SECONDS = 120;

    private ProjectCheck() {}

    static Finding made() {
        if (ClassPath.ownJar().isEmpty()) {
            return Finding.notable(
                    SUBJECT, "skipped, since this program is not packaged", "Start it with ./robonewbie instead.");
        }
        try (TemporaryFolder folder = TemporaryFolder.create("room")) {
            Optional<String> trouble = trouble(folder.path(), List.of("new", "room"))
                    .or(() -> trouble(
                            folder.path().resolve("room"),
                            List.of("run", AGENT, "--headless", "--fast", "--seed", "1", "--seconds", "1")));
            return trouble.map(ProjectCheck::broken)
                    .orElseGet(
                            () -> Finding.well(SUBJECT, "was created by \"new\", compiled and run without a network"));
        } catch (IOException failed) {
            return broken(String.valueOf(failed.getMessage()));
        }
    }

    private static Finding broken(String trouble) {
        return Finding.broken(SUBJECT, trouble, "Try it manually: robonewbie new my-team");
    }

    /** Runs a command and returns its error message if it fails. */
    private static Optional<String> trouble(Path folder, List<String> words) {
        Path output = folder.resolve("output.txt");
        try {
            Process process = new ProcessBuilder(JavaCommand.ofCommand(words))
                    .directory(folder.toFile())
                    .redirectErrorStream(true)
                    .redirectOutput(output.toFile())
                    .start();
            boolean ended = process.waitFor(MAX_SECONDS, TimeUnit.SECONDS);
            process.destroyForcibly();
            if (!ended) {
                return Optional.of("\"" + words.get(0) + "\" did not finish within " + MAX_SECONDS + " s");
            }
            return process.exitValue() == 0
                    ? Optional.empty()
                    : Optional.of(Files.readString(output, Charset.defaultCharset())
                            .lines()
                            .filter(line -> !line.startsWith(GREETING))
                            .findFirst()
                            .orElse("\"" + words.get(0) + "\" failed without a message"));
        } catch (IOException failed) {
            return Optional.of(String.valueOf(failed.getMessage()));
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return Optional.of("The check was interrupted.");
        }
    }
}
