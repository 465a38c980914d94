package org.robonewbie.app.program;

import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The one file that holds this program. */
public final class ProgramFile {

    private ProgramFile() {}

    /** {@return the jar that this class comes from; empty if it comes from a folder, as in an IDE} */
    public static Optional<Path> ofThisProgram() {
        try {
            Path place = Path.of(ProgramFile.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
            return Optional.of(place).filter(Files::isRegularFile);
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
