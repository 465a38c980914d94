package org.robonewbie.competition.trial;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Where a trial puts what it writes.
 *
 * @param recording file for the recording
 * @param logs folder for what programs print
 * @param work folder in which programs work, deleted afterwards
 */
public record TrialFiles(Optional<Path> recording, Path logs, Path work) {

    /** What programs must not see: the folder with all results, in which they work. */
    List<Path> hidden() {
        return List.of(
                Objects.requireNonNullElse(work.toAbsolutePath().normalize().getParent(), work));
    }

    /** Keeps what was noticed at the doors, if anything was. */
    void tell(String trial, List<String> noticed) throws IOException {
        if (!noticed.isEmpty()) {
            Files.write(logs.resolve(trial + "-doors.txt"), noticed);
        }
    }
}
