package org.robonewbie.app.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.zip.CRC32;

/** The version of this program: the project's version and the commit from which it was built. */
final class ProgramVersion {

    private static final String COMMIT = "/org/robonewbie/site/pages/commit.txt";

    private ProgramVersion() {}

    /** Returns the line that identifies the program and the Java runtime, such as {@code RoboNewbie 2.0.0 (0839a708), Java 17.0.17+10}. */
    static String line() {
        String commit = commit();
        return "RoboNewbie "
                + project()
                        .map(version -> commit.isEmpty() ? version : version + " (" + commit + ")")
                        .orElse("(not packaged)")
                + ", Java " + Runtime.version();
    }

    /**
     * Returns the version under which Maven and Gradle cache a jar of this program, such as {@code 2.0.0-0839a708}.
     * They identify jars only by version, so the version includes the jar's checksum if the commit does not identify
     * the jar.
     *
     * @param jar a release, whose file name contains its version, or a local build
     */
    static String of(Path jar) throws IOException {
        return of(jar, number(), commit());
    }

    static String of(Path jar, String version, String commit) throws IOException {
        if (jar.getFileName().toString().equals("robonewbie-" + version + ".jar") || !Files.isRegularFile(jar)) {
            return version;
        }
        if (!commit.isEmpty() && !commit.contains("-")) {
            return version + "-" + commit;
        }
        CRC32 sum = new CRC32();
        sum.update(Files.readAllBytes(jar));
        return version + "-" + (commit.isEmpty() ? "built" : commit) + "-" + Long.toHexString(sum.getValue());
    }

    /** Returns the version, such as {@code 2.0.0}; 0 if the program is not packaged. */
    static String number() {
        return project().orElse("0");
    }

    private static Optional<String> project() {
        return Optional.ofNullable(ProgramVersion.class.getPackage().getImplementationVersion());
    }

    private static String commit() {
        try (InputStream stream = ProgramVersion.class.getResourceAsStream(COMMIT)) {
            return stream == null ? "" : new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException unreadable) {
            return "";
        }
    }
}
