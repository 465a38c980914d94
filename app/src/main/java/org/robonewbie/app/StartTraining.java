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

/** Creates a {@link StartArchive}: a separate JVM runs typical first commands and dumps the classes that it has loaded. */
final class StartTraining {

    private static final int MAX_SECONDS = 60;

    private static final String UNFINISHED = ".new";

    private StartTraining() {}

    /**
     * Creates an archive, or performs the training run.
     *
     * @param arguments path of the archive; empty for the training run
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
                deleteUnfinished(file);
                create(file);
            }
        }
    }

    /** Deletes the files that killed processes left behind. */
    private static void deleteUnfinished(Path file) throws IOException {
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

    private static void create(Path file) throws IOException, InterruptedException {
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
        boolean ended = training.waitFor(MAX_SECONDS, TimeUnit.SECONDS);
        training.destroyForcibly();
        if (ended && training.exitValue() == 0 && Files.isRegularFile(made)) {
            AtomicFile.write(StartArchive.noteOf(file), System.getProperty("java.class.path"));
            Files.move(made, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        }
        Files.deleteIfExists(made);
    }

    /** Runs typical first commands: version, simulator, demo. */
    private static int train() {
        Main.prepare();
        return RoboNewbieCommand.run("--version")
                + RoboNewbieCommand.run(
                        "simulator", "--agent-port", "0", "--monitor-port", "0", "--fast", "--seconds", "1")
                + RoboNewbieCommand.run("demo", "--no-browser", "--seed", "1", "--seconds", "2");
    }
}
