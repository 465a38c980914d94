package org.robonewbie.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.programs.ClassPath;

/**
 * The archive of loaded classes that halves the time of a start: Java's application class-data sharing (JEP 310, JEP 350). The
 * launcher names its file and uses it when it is there. It is made in the background when the program ends for the first time,
 * so that no robot shares the processor with it; Java itself refuses one that does not fit the program or the JVM.
 */
final class StartArchive {

    /** System property with which the launcher names the file. */
    static final String PROPERTY = "robonewbie.archive";

    private final Path file;
    private final Path program;

    private StartArchive(Path file, Path program) {
        this.file = file;
        this.program = program;
    }

    /** The archive that the launcher has named; empty if it named none or the program is no single file. */
    static Optional<StartArchive> wanted() {
        return Optional.ofNullable(System.getProperty(PROPERTY))
                .flatMap(file -> ClassPath.ownJar().map(program -> new StartArchive(Path.of(file), program)));
    }

    /** Lets the archive be made when this process ends, unless there is one already that fits the program. */
    void makeAtTheEnd() throws IOException {
        if (!fits() && Files.isWritable(file.toAbsolutePath().getParent())) {
            Runtime.getRuntime().addShutdownHook(new Thread(this::startMaking, "start-archive"));
        }
    }

    /** Java refuses an archive if the program's file has changed or been moved since. */
    private boolean fits() throws IOException {
        Path note = noteOf(file);
        return Files.isRegularFile(file)
                && Files.isRegularFile(note)
                && Files.getLastModifiedTime(file).compareTo(Files.getLastModifiedTime(program)) >= 0
                && Files.readString(note).equals(program.toString());
    }

    /** A file beside the archive with the place of the program for which it was made. */
    static Path noteOf(Path archive) {
        return archive.resolveSibling(archive.getFileName() + ".txt");
    }

    /** Another process makes it, so that this one ends at once. */
    private void startMaking() {
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
            // The program starts without an archive, only slower.
        }
    }
}
