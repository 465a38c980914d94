package org.robonewbie.app;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robonewbie.app.command.RoboNewbieCommand;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.FolderLock;

/** Makes a {@link StartArchive}: a second Java does what people do first, and writes down the classes that it has loaded. */
final class StartTraining {

    private static final int LONGEST_SECONDS = 60;

    private static final String UNFINISHED = ".new";

    private StartTraining() {}

    /**
     * Makes an archive, or is the training itself.
     *
     * @param arguments the file; nothing for the training
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        if (arguments.length == 0) {
            System.exit(train());
        }
        Path file = Path.of(arguments[0]);
        Optional<FolderLock> lock = FolderLock.take(file.resolveSibling(file.getFileName() + ".lock"));
        if (lock.isPresent()) {
            FolderLock taken = lock.get();
            try (taken) {
                deleteWhatAnotherHasLeft(file);
                make(file);
            }
        }
    }

    /** One that was killed meanwhile leaves many megabytes. */
    private static void deleteWhatAnotherHasLeft(Path file) throws IOException {
        String own = file.getFileName() + ".";
        try (DirectoryStream<Path> left = Files.newDirectoryStream(
                Objects.requireNonNull(file.toAbsolutePath().getParent()),
                each -> String.valueOf(each.getFileName()).startsWith(own)
                        && each.toString().endsWith(UNFINISHED))) {
            for (Path each : left) {
                Files.deleteIfExists(each);
            }
        }
    }

    private static void make(Path file) throws IOException, InterruptedException {
        Path made = file.resolveSibling(
                file.getFileName() + "." + ProcessHandle.current().pid() + UNFINISHED);
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:ArchiveClassesAtExit=" + made,
                "-cp",
                System.getProperty("java.class.path"),
                StartTraining.class.getName()));
        Process training = new ProcessBuilder(command).inheritIO().start();
        boolean ended = training.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS);
        training.destroyForcibly();
        if (ended && training.exitValue() == 0 && Files.isRegularFile(made)) {
            AtomicFile.write(StartArchive.noteOf(file), System.getProperty("java.class.path"));
            Files.move(made, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        }
        Files.deleteIfExists(made);
    }

    /** What people do first: ask for the version, start the server, watch the demo. */
    private static int train() {
        Main.prepare();
        return RoboNewbieCommand.run("--version")
                + RoboNewbieCommand.run(
                        "simulator", "--agent-port", "0", "--monitor-port", "0", "--fast", "--seconds", "1")
                + RoboNewbieCommand.run("demo", "--no-browser", "--seed", "1", "--seconds", "2");
    }
}
