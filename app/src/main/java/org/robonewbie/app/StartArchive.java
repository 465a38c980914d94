package org.robonewbie.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.programs.ClassPath;

/**
 * Archive for application class-data sharing (JEP 310 and JEP 350) that halves the start time. The launcher passes its
 * path and uses the file if it exists. The archive is created in the background when the program exits for the first
 * time, so that creating it takes no processor time away from a robot; the JVM rejects an archive that was created for
 * another program or by another JVM.
 */
final class StartArchive {

    /** System property with the path of the archive, set by the launcher. */
    static final String PROPERTY = "robonewbie.archive";

    private final Path file;
    private final Path program;

    private StartArchive(Path file, Path program) {
        this.file = file;
        this.program = program;
    }

    /**
     * Returns the archive that the launcher requests; empty if it requests none or if the program is not a single jar.
     */
    static Optional<StartArchive> wanted() {
        return Optional.ofNullable(System.getProperty(PROPERTY))
                .flatMap(file -> ClassPath.ownJar().map(program -> new StartArchive(Path.of(file), program)));
    }

    /** Creates the archive when this process exits, unless a valid one exists. */
    void createOnExit() throws IOException {
        if (!isValid() && Files.isWritable(file.toAbsolutePath().getParent())) {
            Runtime.getRuntime().addShutdownHook(new Thread(this::startCreation, "start-archive"));
        }
    }

    /** Returns whether the archive is valid. The JVM rejects an archive whose jar has since been changed or moved. */
    private boolean isValid() throws IOException {
        Path note = noteOf(file);
        return Files.isRegularFile(file)
                && Files.isRegularFile(note)
                && Files.getLastModifiedTime(file).compareTo(Files.getLastModifiedTime(program)) >= 0
                && Files.readString(note).equals(program.toString());
    }

    /** Returns the file, next to the archive, that contains the path of the jar from which the archive was created. */
    static Path noteOf(Path archive) {
        return archive.resolveSibling(archive.getFileName() + ".txt");
    }

    /** Creates the archive in a separate process, so that this one can exit without delay. */
    private void startCreation() {
        try {
            ProcessBuilder builder = new ProcessBuilder(List.of(
                    Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "-XX:+UseSerialGC",
                    "-cp",
                    program.toString(),
                    StartTraining.class.getName(),
                    file.toString()));
            builder.environment().put("ROBONEWBIE_RECORDINGS", "off");
            builder.redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start()
                    .getOutputStream()
                    .close();
        } catch (IOException slowStart) {
            // the archive is optional
        }
    }
}
